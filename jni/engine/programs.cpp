#include "engine/programs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <tuple>

namespace vct {

namespace {

// What a material has of the features that a pass reads, `used`, as shared/material.glsl wants it, behind
// other defines. A pass that does not read a feature is not forked by it.
std::vector<std::string> featureDefines(unsigned features, unsigned used,
                                        std::vector<std::string> defines = {}) {
    features &= used;
    const auto define = [&](const char* name, bool has) {
        defines.push_back(std::string(name) + (has ? " true" : " false"));
    };
    define("VCT_ALPHA_MASK", features & featureAlphaMask);
    define("VCT_EMISSIVE", features & featureEmissive);
    define("VCT_DOUBLE_SIDED", features & featureDoubleSided);
    if (features & featureBaseColorTexture) defines.emplace_back("VCT_BASE_COLOR_TEXTURE");
    if (features & featureEmissiveTexture) defines.emplace_back("VCT_EMISSIVE_TEXTURE");
    return defines;
}

std::string number(float value) {
    char text[32];
    std::snprintf(text, sizeof text, "%#.9g", value);
    return text;
}

std::vector<std::string> gatherDefines(const GatherSettings& g) {
    return {"VCT_GATHER_DIRECTIONS " + std::to_string(g.directions),
            "VCT_GATHER_START " + number(g.startOffset),
            "VCT_GATHER_FIRST_SAMPLE " + number(g.firstSample),
            "VCT_GATHER_OWN_SURFACE " + number(g.ownSurface),
            "VCT_GATHER_STEP " + number(g.step),
            "VCT_GATHER_HEIGHT " + number(g.height),
            "VCT_GATHER_EXTINCTION " + number(g.extinction),
            "VCT_GATHER_THRESHOLD " + number(g.threshold)};
}

// `name`: also the fragment shader's.
gl::ProgramDescription voxelizing(const std::string& name, std::vector<std::string> defines,
                                  Voxelization voxelization) {
    if (voxelization == Voxelization::geometryShader)
        return {name, {"shared/voxelizer.vert", "shared/voxelizer.geom", name + ".frag"}, std::move(defines)};
    defines.emplace_back("VCT_SORTED_AXES");
    return {name, {"shared/voxelizer.vert", name + ".frag"}, std::move(defines)};
}

bool possible(unsigned features) {
    return !(features & featureEmissiveTexture) || (features & featureEmissive);
}

}  // namespace

gl::ShaderLibrary shaderLibrary(const Settings& settings, const gl::Capabilities& capabilities,
                                gl::ReadShader read) {
    std::vector<std::string> defines;
    if (settings.countInvocations) defines.emplace_back("VCT_SHADER_COUNTERS");
    // llvmpipe rounds mediump for real, in software, and the cones take up to twice as long.
    if (capabilities.softwareDriver) defines.emplace_back("mediump highp");
    return {std::move(read), capabilities.language(), std::move(defines)};
}

std::vector<unsigned> allFeatures() {
    std::vector<unsigned> all;
    for (unsigned features = 0; features < materialFeatureCombinations; ++features)
        if (possible(features)) all.push_back(features);
    return all;
}

gl::ProgramDescription shadowMapProgram(unsigned features) {
    // An opaque surface's texture does not matter to its shadow.
    if (!(features & featureAlphaMask)) features = 0;
    return {"shadow_map",
            {"passes/shadow_map.vert", "passes/shadow_map.frag"},
            featureDefines(features, featureBaseColorTexture | featureAlphaMask)};
}

gl::ProgramDescription shadowLevelProgram() {
    return {"shadow_level", {"passes/full_screen.vert", "passes/shadow_level.frag"}, {}};
}

ExtraTargets extraTargets(const SceneFeatures& needs, Specular specular) {
    return {needs.has(featureEmissive), specular == Specular::cone && needs.glossy};
}

gl::ProgramDescription gBufferProgram(unsigned features, ExtraTargets targets) {
    unsigned used = featureBaseColorTexture | featureAlphaMask;
    if (targets.emissive) used |= featureEmissive | featureEmissiveTexture;
    std::vector<std::string> defines = featureDefines(features, used);
    if (targets.emissive) defines.emplace_back("VCT_EMISSIVE_TARGET");
    if (targets.gloss) defines.emplace_back(targets.emissive ? "VCT_GLOSS_TARGET 3" : "VCT_GLOSS_TARGET 2");
    return {"g_buffer", {"passes/g_buffer.vert", "passes/g_buffer.frag"}, defines};
}

gl::ProgramDescription packedVoxelizerProgram(unsigned features, Voxelization voxelization) {
    return voxelizing("packed/voxelizer", featureDefines(features, ~0U), voxelization);
}

gl::ProgramDescription packedMipmapperProgram() {
    return {"packed/mipmapper", {"packed/mipmapper.comp"}, {}};
}

gl::ProgramDescription packedClearProgram() {
    return {"packed/clear", {"packed/clear.comp"}, {}};
}

gl::ProgramDescription occupancyProgram(unsigned features, Voxelization voxelization) {
    if (!(features & featureAlphaMask)) features = 0;
    return voxelizing("directional/occupancy",
                      featureDefines(features, featureBaseColorTexture | featureAlphaMask), voxelization);
}

gl::ProgramDescription directionalVoxelizerProgram(unsigned features, Voxelization voxelization) {
    return voxelizing("directional/voxelizer", featureDefines(features, ~0U, {"VCT_RELIGHT false"}),
                      voxelization);
}

gl::ProgramDescription directionalResolveProgram() {
    return {"directional/resolve", {"directional/resolve.comp"}, {"VCT_STATIC false"}};
}

gl::ProgramDescription clearRadianceProgram() {
    return {"directional/clear_radiance", {"directional/clear_radiance.comp"}, {}};
}

gl::ProgramDescription relightProgram(unsigned features, Voxelization voxelization) {
    return voxelizing("directional/voxelizer", featureDefines(features, ~0U, {"VCT_RELIGHT true"}),
                      voxelization);
}

gl::ProgramDescription relightResolveProgram() {
    return {"directional/relight", {"directional/relight.comp"}, {}};
}

gl::ProgramDescription staticVoxelizerProgram(unsigned features, Voxelization voxelization) {
    return voxelizing("directional/voxelizer",
                      featureDefines(features, ~0U, {"VCT_RELIGHT false", "VCT_DIRTY_BLOCKS"}), voxelization);
}

gl::ProgramDescription staticResolveProgram() {
    return {"directional/resolve of what is static", {"directional/resolve.comp"}, {"VCT_STATIC true"}};
}

gl::ProgramDescription dirtyResolveProgram() {
    return {"directional/resolve_dirty", {"directional/resolve_dirty.comp"}, {}};
}

gl::ProgramDescription dirtyMipmapperProgram() {
    return {"directional/mipmapper_dirty", {"directional/mipmapper_dirty.comp"}, {}};
}

gl::ProgramDescription dirtyClearBaseProgram() {
    return {"directional/clear_base_dirty", {"directional/clear_base_dirty.comp"}, {}};
}

gl::ProgramDescription clearDynamicProgram() {
    return {"directional/clear_dynamic", {"directional/clear_dynamic.comp"}, {}};
}

gl::ProgramDescription directionalLevelsProgram() {
    return {"directional/levels", {"directional/mipmapper.comp"}, {"VCT_LIST_PARENTS true"}};
}

gl::ProgramDescription directionalMipmapperProgram() {
    return {"directional/mipmapper", {"directional/mipmapper.comp"}, {"VCT_LIST_PARENTS false"}};
}

gl::ProgramDescription directionalClearProgram() {
    return {"directional/clear", {"directional/clear.comp"}, {}};
}

gl::ProgramDescription directionalClearBaseProgram() {
    return {"directional/clear_base", {"directional/clear_base.comp"}, {}};
}

gl::ProgramDescription lightProgram(const std::string& name) {
    return {name, {"directional/" + name + ".comp"}, {}};
}

gl::ProgramDescription irradianceProgram(const GatherSettings& settings, GatherOf of) {
    std::vector<std::string> defines = gatherDefines(settings);
    defines.push_back("VCT_FORGETTING " + number(irradianceForgetting));
    defines.emplace_back(of == GatherOf::occlusion ? "VCT_GATHER_OCCLUSION true"
                                                   : "VCT_GATHER_OCCLUSION false");
    return {of == GatherOf::occlusion ? "irradiance, occlusion" : "irradiance",
            {"directional/irradiance.comp"},
            defines};
}

gl::ProgramDescription shadeProgram(int mode, ExtraTargets targets, const Settings& settings) {
    std::vector<std::string> defines{"VCT_MODE " + std::to_string(mode)};
    if (targets.emissive) defines.emplace_back("VCT_EMISSIVE_TARGET");
    const bool reflects = mode == VCT_MODE_GI || mode == VCT_MODE_GI_CONE_SHADOW || mode == VCT_VIEW_SPECULAR;
    if (targets.gloss && reflects) defines.emplace_back("VCT_GLOSS_TARGET");
    const bool softShadow = mode == VCT_MODE_GI_CONE_SHADOW || mode == VCT_VIEW_CONE_SHADOW;
    if (softShadow && settings.shadow == Shadow::softMap) {
        defines.emplace_back("VCT_SOFT_SHADOW");
        defines.push_back("VCT_FILTER_TAPS " + std::to_string(settings.filterTaps));
    }
    const bool gathers = mode >= VCT_MODE_AO && mode != VCT_VIEW_CONE_SHADOW;
    if (gathers && settings.voxels == Voxels::directional) defines.emplace_back("VCT_RECEIVED");
    if (targets.gloss && reflects)
        for (const std::string& define : gatherDefines(settings.gather))
            defines.push_back(define);
    return {"shade " + std::to_string(mode), {"passes/full_screen.vert", "passes/shade.frag"}, defines};
}

gl::ProgramDescription voxelViewProgram() {
    return {"voxel_view", {"lab/voxel_view.vert", "lab/voxel_view.frag"}, {}};
}

gl::ProgramDescription debugViewProgram(int stage) {
    return {"stage_view " + std::to_string(stage),
            {"passes/full_screen.vert", "lab/debug_view.frag"},
            {"VCT_DEBUG_VIEW " + std::to_string(stage)}};
}

gl::ProgramDescription presentProgram() {
    return {"present", {"passes/full_screen.vert", "app/present.frag"}, {}};
}

gl::ProgramDescription hudProgram() {
    return {"hud", {"app/hud.vert", "app/hud.frag"}, {}};
}

std::vector<gl::ProgramDescription> everyProgram() {
    std::vector<gl::ProgramDescription> programs{packedMipmapperProgram(),
                                                 packedClearProgram(),
                                                 voxelViewProgram(),
                                                 presentProgram(),
                                                 hudProgram(),
                                                 directionalResolveProgram(),
                                                 directionalLevelsProgram(),
                                                 directionalClearBaseProgram(),
                                                 directionalMipmapperProgram(),
                                                 directionalClearProgram(),
                                                 lightProgram("light_inherit"),
                                                 lightProgram("light_clear"),
                                                 lightProgram("light_blocks"),
                                                 lightProgram("light_bricks"),
                                                 lightProgram("light_shine"),
                                                 shadowLevelProgram(),
                                                 staticResolveProgram(),
                                                 dirtyResolveProgram(),
                                                 dirtyMipmapperProgram(),
                                                 dirtyClearBaseProgram(),
                                                 clearDynamicProgram(),
                                                 clearRadianceProgram(),
                                                 relightResolveProgram()};
    for (unsigned features : allFeatures()) {
        programs.push_back(shadowMapProgram(features));
        for (Voxelization voxelization : {Voxelization::geometryShader, Voxelization::sortedAxes}) {
            programs.push_back(packedVoxelizerProgram(features, voxelization));
            programs.push_back(occupancyProgram(features, voxelization));
            programs.push_back(directionalVoxelizerProgram(features, voxelization));
            programs.push_back(relightProgram(features, voxelization));
            programs.push_back(staticVoxelizerProgram(features, voxelization));
        }
        for (bool emissive : {false, true})
            for (bool gloss : {false, true})
                programs.push_back(gBufferProgram(features, {emissive, gloss}));
    }
    Settings softMap;
    softMap.shadow = Shadow::softMap;
    std::vector<Settings> variants{softMap};
    for (const std::string& preset : presetNames())
        variants.push_back(presetSettings(preset));
    for (const Settings& settings : variants) {
        const bool faces = settings.voxels == Voxels::directional;
        for (int mode = VCT_MODE_PHONG; mode <= (faces ? VCT_VIEW_SPECULAR : VCT_VIEW_IRRADIANCE); ++mode)
            for (bool emissive : {false, true})
                for (bool gloss : {false, true})
                    if (faces || !gloss) programs.push_back(shadeProgram(mode, {emissive, gloss}, settings));
        if (settings.voxels != Voxels::directional) continue;
        programs.push_back(irradianceProgram(settings.gather, GatherOf::light));
        programs.push_back(irradianceProgram(settings.occlusion, GatherOf::occlusion));
    }
    for (int stage = VCT_DEBUG_VIEW_SHADOW_MAP; stage <= VCT_DEBUG_VIEW_EMISSIVE; ++stage)
        programs.push_back(debugViewProgram(stage));
    // Presets share most of them.
    const auto key = [](const gl::ProgramDescription& p) { return std::tie(p.shaders, p.defines); };
    std::sort(programs.begin(), programs.end(),
              [&](const auto& a, const auto& b) { return key(a) < key(b); });
    programs.erase(std::unique(programs.begin(), programs.end(),
                               [&](const auto& a, const auto& b) { return key(a) == key(b); }),
                   programs.end());
    return programs;
}

std::vector<FrameProgram> framePrograms(const Settings& settings, Mode mode, const SceneFeatures& needs) {
    std::vector<FrameProgram> programs;
    const auto add = [&](Step step, const gl::ProgramDescription& program) {
        for (const FrameProgram& known : programs)
            if (known.program.name == program.name && known.program.defines == program.defines) return;
        programs.push_back({step, program});
    };
    const ExtraTargets targets = extraTargets(needs, settings.specular);
    if (mode != Mode::phong)
        for (unsigned f : needs.materialFeatures)
            add(Step::shadowMap, shadowMapProgram(f));
    if (mode == Mode::giConeShadow && settings.shadow == Shadow::softMap)
        add(Step::shadowMap, shadowLevelProgram());
    for (unsigned f : needs.materialFeatures)
        add(Step::renderData, gBufferProgram(f, targets));
    const bool voxels = mode == Mode::ao || mode == Mode::gi || mode == Mode::giConeShadow;
    if (voxels && settings.voxels == Voxels::directional) {
        add(Step::voxelize, directionalClearBaseProgram());
        add(Step::voxelize, directionalClearProgram());
        for (unsigned f : needs.materialFeatures) {
            add(Step::voxelize, occupancyProgram(f, settings.voxelization));
            add(Step::voxelize, directionalVoxelizerProgram(f, settings.voxelization));
        }
        add(Step::voxelize, directionalResolveProgram());
        add(Step::mipmap, directionalLevelsProgram());
        const bool occlusion = mode == Mode::ao;
        add(Step::irradiance, lightProgram("light_inherit"));
        add(Step::irradiance, lightProgram("light_clear"));
        add(Step::irradiance, lightProgram("light_bricks"));
        if (!occlusion) {
            add(Step::irradiance, lightProgram("light_shine"));
            add(Step::irradiance, directionalMipmapperProgram());
        }
        add(Step::irradiance, irradianceProgram(occlusion ? settings.occlusion : settings.gather,
                                                occlusion ? GatherOf::occlusion : GatherOf::light));
        add(Step::irradiance, lightProgram("light_blocks"));
    } else if (voxels) {
        add(Step::voxelize, packedClearProgram());
        for (unsigned f : needs.materialFeatures)
            add(Step::voxelize, packedVoxelizerProgram(f, settings.voxelization));
        add(Step::mipmap, packedMipmapperProgram());
    }
    add(Step::trace, shadeProgram(static_cast<int>(mode), targets, settings));
    return programs;
}

}  // namespace vct
