#include "lab/program_list.h"

#include <algorithm>
#include <array>
#include <string>
#include <tuple>

#include "engine/directional/directional_volume.h"
#include "engine/environment.h"
#include "engine/packed/packed_volume.h"
#include "engine/passes/g_buffer.h"
#include "engine/passes/shade.h"
#include "engine/passes/shadow_map.h"
#include "lab/debug_view.h"
#include "lab/driver_checks.h"
#include "lab/voxel_view.h"

namespace vct {

namespace {

constexpr std::array lightPrograms{"light_inherit", "light_clear", "light_bricks", "light_blocks",
                                   "light_shine"};

bool possible(unsigned features) {
    return !(features & featureEmissiveTexture) || (features & featureEmissive);
}

}  // namespace

std::vector<gl::ProgramDescription> everyProgram() {
    std::vector<gl::ProgramDescription> programs{packedMipmapperProgram(),
                                                 packedClearProgram(),
                                                 voxelViewProgram(),

                                                 directionalResolveProgram(),
                                                 directionalLevelsProgram(),
                                                 directionalClearBaseProgram(),
                                                 directionalMipmapperProgram(),
                                                 directionalClearProgram(),
                                                 shadowMomentsProgram(),
                                                 nextShadowMomentsProgram(),
                                                 staticResolveProgram(),
                                                 dirtyResolveProgram(),
                                                 dirtyMipmapperProgram(),
                                                 dirtyClearBaseProgram(),
                                                 clearDynamicProgram(),
                                                 clearRadianceProgram(),
                                                 relightResolveProgram(),
                                                 deformProgram(),
                                                 sortAxesProgram()};
    for (const gl::ProgramDescription& program : driverCheckPrograms())
        programs.push_back(program);
    for (unsigned features : allFeatures()) {
        programs.push_back(shadowMapProgram(features));
        programs.push_back(lightMapProgram(features));
        programs.push_back(packedVoxelizerProgram(features, Voxelization::geometryShader));
        for (const auto& voxelizer : {packedVoxelizerProgram, occupancyProgram, directionalVoxelizerProgram,
                                      relightProgram, staticVoxelizerProgram})
            programs.push_back(voxelizer(features, Voxelization::sortedAxes));
        for (bool emissive : {false, true})
            for (bool gloss : {false, true})
                for (bool mapped : {false, true})
                    programs.push_back(gBufferProgram(features, {emissive, gloss, mapped}));
    }
    Settings softMap;
    softMap.shadow = Shadow::softMap;
    std::vector<Settings> variants{softMap};
    for (const std::string& preset : presetNames())
        variants.push_back(presetSettings(preset));
    const auto sky = std::make_shared<const Environment>(Image(2, 1), "of no light");
    for (std::size_t i = 0, count = variants.size(); i < count; ++i) {
        variants.push_back(variants[i]);
        variants.back().environment = sky;
    }
    for (const bool environment : {false, true})
        for (const bool emitters : {false, true})
            for (const char* name : lightPrograms)
                programs.push_back(lightProgram(name, {false, environment, emitters}));
    for (const Settings& settings : variants) {
        const bool faces = settings.voxels == Voxels::directional;
        for (const OutputReads& read : outputTable)
            for (bool emissive : {false, true})
                for (bool gloss : {false, true})
                    for (bool punctual : {false, true})
                        for (bool emitters : {false, true})
                            for (bool mapped : {false, true})
                                if ((faces || (!gloss && !emitters)) && (!mapped || !emissive))
                                    programs.push_back(shadeProgram(
                                        read.output, {emissive, gloss, mapped},
                                        {punctual, settings.environment != nullptr, emitters}, settings));
        if (settings.voxels != Voxels::directional) continue;
        for (const bool emitters : {false, true})
            programs.push_back(irradianceProgram(settings.gather, GatherOf::light,
                                                 {false, settings.environment != nullptr, emitters}));
        programs.push_back(irradianceProgram(settings.occlusion, GatherOf::occlusion, {}));
        programs.push_back(emittersProgram(settings.gather));
    }
    for (int view = VCT_DEBUG_VIEW_SHADOW_MAP; view <= VCT_DEBUG_VIEW_EMISSIVE; ++view)
        programs.push_back(debugViewProgram(view));
    // Presets share most of them.
    const auto key = [](const gl::ProgramDescription& p) { return std::tie(p.shaders, p.defines); };
    std::sort(programs.begin(), programs.end(),
              [&](const auto& a, const auto& b) { return key(a) < key(b); });
    programs.erase(std::unique(programs.begin(), programs.end(),
                               [&](const auto& a, const auto& b) { return key(a) == key(b); }),
                   programs.end());
    return programs;
}

std::vector<FrameProgram> framePrograms(const Settings& settings, Output mode,
                                        const SceneFeatures& features) {
    std::vector<FrameProgram> programs;
    const auto add = [&](Step step, const gl::ProgramDescription& program) {
        for (const FrameProgram& known : programs)
            if (known.program.name == program.name && known.program.defines == program.defines) return;
        programs.push_back({step, program});
    };
    const Voxelization voxelization = voxelizationFor(settings.voxels, {});
    const ExtraTargets targets = extraTargets(features, settings.specular);
    // What glows is a lamp, unless it is large: then there are less.
    const LightFeatures lights{features.has(featurePunctualLights), settings.environment != nullptr,
                               settings.voxels == Voxels::directional && features.has(featureEmissive)};
    const OutputReads& read = reads(mode);
    if (read.shadowMap())
        for (unsigned f : features.materialFeatures)
            add(Step::shadowMap, shadowMapProgram(f));
    if (read.softShadow && settings.shadow == Shadow::softMap) {
        add(Step::shadowMap, shadowMomentsProgram());
        add(Step::shadowMap, nextShadowMomentsProgram());
    }
    for (unsigned f : features.materialFeatures)
        add(Step::renderData, gBufferProgram(f, targets));
    if (read.voxels && settings.voxels == Voxels::directional) {
        add(Step::voxelize, directionalClearBaseProgram());
        add(Step::voxelize, directionalClearProgram());
        for (unsigned f : features.materialFeatures) {
            add(Step::voxelize, occupancyProgram(f, voxelization));
            add(Step::voxelize, directionalVoxelizerProgram(f, voxelization));
        }
        add(Step::voxelize, directionalResolveProgram());
        add(Step::mipmap, directionalLevelsProgram());
        const GatherOf of = read.ambientVisibility ? GatherOf::occlusion : GatherOf::light;
        const LightFeatures received = featuresFor(of, lights);
        for (const char* name : lightPrograms)
            if (of == GatherOf::light || name != std::string("light_shine"))
                add(Step::irradiance, lightProgram(name, received));
        if (received.emitters) add(Step::irradiance, emittersProgram(settings.gather));
        if (of == GatherOf::light) add(Step::irradiance, directionalMipmapperProgram());
        add(Step::irradiance,
            irradianceProgram(of == GatherOf::light ? settings.gather : settings.occlusion, of, received));
    } else if (read.voxels) {
        add(Step::voxelize, packedClearProgram());
        for (unsigned f : features.materialFeatures)
            add(Step::voxelize, packedVoxelizerProgram(f, voxelization));
        add(Step::mipmap, packedMipmapperProgram());
    }
    if (features.deforms) {
        add(Step::voxelize, deformProgram());
        if (voxelization == Voxelization::sortedAxes) add(Step::voxelize, sortAxesProgram());
    }
    if (lights.punctual && read.shadowMap())
        for (unsigned f : features.materialFeatures)
            add(Step::shadowMap, lightMapProgram(f));
    add(Step::trace, shadeProgram(mode, targets, lights, settings));
    return programs;
}

std::vector<unsigned> allFeatures() {
    std::vector<unsigned> all;
    for (unsigned features = 0; features < materialFeatureCombinations; ++features)
        if (possible(features)) all.push_back(features);
    // What a material needs and lights besides the sun are told apart in different functions: one with all of
    // it stands for the others.
    all.push_back(featurePunctualLights);
    all.push_back(featurePunctualLights | (materialFeatureCombinations - 1));
    unsigned everything = featurePunctualLights | (materialFeatureCombinations - 1);
    for (const unsigned feature :
         {featureVertexColors, featureGlossTexture, featureNormalMap, featureUnlit}) {
        all.push_back(feature);
        all.push_back(everything |= feature);
    }
    return all;
}

}  // namespace vct
