#include "render/programs.h"

#include <algorithm>

namespace vct {

namespace {

// The features in `features & used`, as defines. A pass that does not read a feature is not forked by it.
std::vector<std::string> featureDefines(unsigned features, unsigned used) {
    features &= used;
    std::vector<std::string> defines;
    if (features & featureBaseColorTexture) defines.push_back("VCT_BASE_COLOR_TEXTURE");
    if (features & featureAlphaMask) defines.push_back("VCT_ALPHA_MASK");
    if (features & featureEmissive) defines.push_back("VCT_EMISSIVE");
    if (features & featureEmissiveTexture) defines.push_back("VCT_EMISSIVE_TEXTURE");
    return defines;
}

bool possible(unsigned features) {
    return !(features & featureEmissiveTexture) || (features & featureEmissive);
}

}  // namespace

gl::ShaderLibrary shaderLibrary(const Settings& settings, const gl::Capabilities& capabilities,
                                gl::ReadShader read) {
    std::vector<std::string> defines;
    for (const Experiment& experiment : allExperiments())
        if (std::count(settings.experiments.begin(), settings.experiments.end(), experiment.name) > 0)
            defines.emplace_back(experiment.define);
    if (settings.emulateHalf)
        defines.emplace_back("VCT_EMULATE_HALF");
    else if (capabilities.softwareDriver)
        defines.emplace_back("VCT_FULL_PRECISION");
    return {std::move(read), capabilities.language(), std::move(defines)};
}

unsigned materialFeatures(const Material& material) {
    unsigned features = 0;
    if (material.baseColorTexture >= 0) features |= featureBaseColorTexture;
    if (material.alphaMode == Material::AlphaMode::mask) features |= featureAlphaMask;
    if (material.emissive != glm::vec3(0.0F)) {
        features |= featureEmissive;
        if (material.emissiveTexture >= 0) features |= featureEmissiveTexture;
    }
    return features;
}

gl::ProgramDescription shadowMapProgram(unsigned features) {
    // An opaque surface's texture does not matter to its shadow.
    if (!(features & featureAlphaMask)) features = 0;
    return {"shadow_map",
            {"shadow_map.vert", "shadow_map.frag"},
            featureDefines(features, featureBaseColorTexture | featureAlphaMask)};
}

gl::ProgramDescription gBufferProgram(unsigned features, bool emissiveTarget) {
    unsigned used = featureBaseColorTexture | featureAlphaMask;
    if (emissiveTarget) used |= featureEmissive | featureEmissiveTexture;
    std::vector<std::string> defines = featureDefines(features, used);
    if (emissiveTarget) defines.push_back("VCT_EMISSIVE_TARGET");
    return {"g_buffer", {"g_buffer.vert", "g_buffer.frag"}, defines};
}

gl::ProgramDescription voxelizerProgram(unsigned features) {
    return {
        "voxelizer", {"voxelizer.vert", "voxelizer.geom", "voxelizer.frag"}, featureDefines(features, ~0U)};
}

gl::ProgramDescription mipmapperProgram() {
    return {"mipmapper", {"mipmapper.comp"}, {}};
}

gl::ProgramDescription sparseClearProgram() {
    return {"sparse_clear", {"sparse_clear.comp"}, {}};
}

gl::ProgramDescription coneTracerProgram(int mode, bool emissiveTarget, const Settings& settings) {
    std::vector<std::string> defines{"VCT_MODE " + std::to_string(mode)};
    if (emissiveTarget) defines.emplace_back("VCT_EMISSIVE_TARGET");
    const bool softShadow = mode == VCT_MODE_GI_CONE_SHADOW || mode == VCT_VIEW_CONE_SHADOW;
    if (softShadow && settings.shadow == Shadow::softMap) {
        defines.emplace_back("VCT_SOFT_SHADOW");
        defines.push_back("VCT_BLOCKER_TAPS " + std::to_string(settings.blockerTaps));
        defines.push_back("VCT_FILTER_TAPS " + std::to_string(settings.filterTaps));
    }
    return {"cone_tracer " + std::to_string(mode), {"full_screen.vert", "cone_tracer.frag"}, defines};
}

gl::ProgramDescription voxelViewProgram() {
    return {"voxel_view", {"voxel_view.vert", "voxel_view.frag"}, {}};
}

gl::ProgramDescription stageViewProgram(int stage) {
    return {"stage_view " + std::to_string(stage),
            {"full_screen.vert", "stage_view.frag"},
            {"VCT_STAGE " + std::to_string(stage)}};
}

gl::ProgramDescription presentProgram() {
    return {"present", {"full_screen.vert", "present.frag"}, {}};
}

gl::ProgramDescription hudProgram() {
    return {"hud", {"hud.vert", "hud.frag"}, {}};
}

std::vector<gl::ProgramDescription> everyProgram() {
    std::vector<gl::ProgramDescription> programs{mipmapperProgram(), sparseClearProgram(), voxelViewProgram(),
                                                 presentProgram(), hudProgram()};
    for (unsigned features = 0; features < materialFeatureCombinations; ++features) {
        if (!possible(features)) continue;
        programs.push_back(shadowMapProgram(features));
        programs.push_back(voxelizerProgram(features));
        for (bool emissiveTarget : {false, true})
            programs.push_back(gBufferProgram(features, emissiveTarget));
    }
    Settings softMap;
    softMap.shadow = Shadow::softMap;
    for (const Settings& settings : {Settings{}, softMap})
        for (int mode = VCT_MODE_PHONG; mode <= VCT_VIEW_CONE_SHADOW; ++mode)
            for (bool emissiveTarget : {false, true})
                programs.push_back(coneTracerProgram(mode, emissiveTarget, settings));
    for (int stage = VCT_STAGE_SHADOW_MAP; stage <= VCT_STAGE_EMISSIVE; ++stage)
        programs.push_back(stageViewProgram(stage));
    return programs;
}

}  // namespace vct
