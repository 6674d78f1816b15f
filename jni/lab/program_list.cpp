#include "lab/program_list.h"

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <utility>

#include "engine/directional/directional_volume.h"
#include "engine/environment.h"
#include "engine/packed/packed_volume.h"
#include "engine/passes/g_buffer.h"
#include "engine/passes/gloss.h"
#include "engine/passes/shade.h"
#include "engine/passes/shadow_map.h"
#include "lab/debug_view.h"
#include "lab/driver_checks.h"
#include "lab/voxel_view.h"

namespace vct {

namespace {

constexpr std::array lightPrograms{"clear_bricks", "place_bricks", "mark_walls", "fill_bricks"};
constexpr std::array rayPrograms{"carry_over", "carry_hits", "forward_hits", "list_visited", "sky",   "trace",
                                 "block",      "gather",     "refine",       "smooth_rows",  "smooth"};

bool possible(unsigned features) {
    return !(features & featureEmissiveTexture) || (features & featureEmissive);
}

}  // namespace

std::vector<gl::ProgramDescription> everyProgram() {
    std::vector<gl::ProgramDescription> programs{
        packedMipmapperProgram(), packedClearProgram(), voxelViewProgram(),

        listBlocksProgram(),      listFreeProgram(),    listFacesProgram(),   clearBlocksProgram(),
        resetListsProgram(),      markStaticProgram(),  shadowLevelProgram(), deformProgram(),
        copyVerticesProgram(),    sortAxesProgram()};
    for (const gl::ProgramDescription& program : driverCheckPrograms())
        programs.push_back(program);
    for (unsigned features : allFeatures()) {
        programs.push_back(shadowMapProgram(features));
        programs.push_back(lightMapProgram(features));
        for (Voxelization voxelization : {Voxelization::geometryShader, Voxelization::sortedAxes})
            programs.push_back(packedVoxelizerProgram(features, voxelization));
        programs.push_back(markFacesProgram(features));
        for (bool emission : {false, true})
            programs.push_back(accumulateProgram(features, emission));
        for (bool emissive : {false, true})
            for (bool gloss : {false, true})
                for (bool mapped : {false, true})
                    programs.push_back(gBufferProgram(features, {emissive, gloss, mapped}));
    }
    Settings softMap;
    softMap.shadow = Shadow::softMap;
    Settings softLights = softMap;
    softLights.voxels = Voxels::directional;
    softLights.lightRadius = 0.1F;
    std::vector<Settings> variants{softMap, softLights};
    for (const std::string& preset : presetNames())
        variants.push_back(presetSettings(preset));
    const auto sky = std::make_shared<const Environment>(Image(2, 1), "of no light");
    for (std::size_t i = 0, count = variants.size(); i < count; ++i) {
        variants.push_back(variants[i]);
        variants.back().environment = sky;
    }
    programs.push_back(markGlossProgram());
    // A scene with compact emitters also has emission, so the fourth combination does not exist.
    constexpr std::array<std::pair<bool, bool>, 3> emissionAndEmitters{
        {{false, false}, {true, false}, {true, true}}};
    for (const auto& [emission, emitters] : emissionAndEmitters) {
        programs.push_back(clearDynamicProgram(emission));
        programs.push_back(unlistStaticProgram(emission));
        programs.push_back(scrollProgram(emission));
        programs.push_back(resolveProgram(emission));
        programs.push_back(fillBlocksProgram(emission));
        for (const bool environment : {false, true}) {
            for (const char* name : lightPrograms)
                programs.push_back(lightProgram(name, {false, environment, emitters, emission}));
            for (const bool punctual : {false, true})
                programs.push_back(injectProgram({punctual, environment, emitters, emission}));
        }
    }
    for (const Settings& settings : variants) {
        const bool faces = settings.voxels == Voxels::directional;
        for (const OutputReads& read : outputTable)
            for (bool emissive : {false, true})
                for (bool gloss : {false, true})
                    for (bool punctual : {false, true})
                        for (bool mapped : {false, true})
                            if ((faces || !gloss) && (!mapped || !emissive))
                                programs.push_back(shadeProgram(read.output, {emissive, gloss, mapped},
                                                                {punctual, settings.environment != nullptr},
                                                                settings));
        if (settings.voxels != Voxels::directional) continue;
        for (const auto& [emission, emitters] : emissionAndEmitters) {
            const LightFeatures lights{false, settings.environment != nullptr, emitters, emission};
            for (const bool mapped : {false, true})
                for (const bool punctual : {false, true}) {
                    const LightFeatures all{punctual, lights.environment, emitters, emission};
                    programs.push_back(halfGlossProgram(mapped, all));
                    programs.push_back(glossProgram(mapped, all));
                }
            for (const char* name : rayPrograms)
                programs.push_back(raysProgram(name, settings.gather, lights));
            if (emitters) programs.push_back(emittersProgram(lights));
        }
    }
    for (int view = VCT_DEBUG_VIEW_SHADOW_MAP; view <= VCT_DEBUG_VIEW_EMISSIVE; ++view)
        programs.push_back(debugViewProgram(view));
    // Presets share most programs.
    const auto key = [](const gl::ProgramDescription& p) { return std::tie(p.shaders, p.defines); };
    std::sort(programs.begin(), programs.end(),
              [&](const auto& a, const auto& b) { return key(a) < key(b); });
    programs.erase(std::unique(programs.begin(), programs.end(),
                               [&](const auto& a, const auto& b) { return key(a) == key(b); }),
                   programs.end());
    return programs;
}

std::vector<FrameProgram> framePrograms(const Settings& settings, Output mode, const SceneFeatures& features,
                                        const gl::Capabilities& capabilities) {
    std::vector<FrameProgram> programs;
    const auto add = [&](Step step, const gl::ProgramDescription& program) {
        for (const FrameProgram& known : programs)
            if (known.program.name == program.name && known.program.defines == program.defines) return;
        programs.push_back({step, program});
    };
    const Voxelization voxelization = voxelizationFor(settings.voxels, capabilities);
    const ExtraTargets targets = extraTargets(features, settings.specular);
    // Assumes that all emitters of the scene are compact; large ones need fewer programs.
    const bool emission = features.has(featureEmissive);
    const LightFeatures lights{features.has(featurePunctualLights), settings.environment != nullptr,
                               settings.voxels == Voxels::directional && emission, emission};
    const OutputReads& read = reads(mode);
    if (read.shadowMap())
        for (unsigned f : features.materialFeatures)
            add(Step::shadowMap, shadowMapProgram(f));
    if (read.softShadow && settings.shadow == Shadow::softMap) add(Step::shadowMap, shadowLevelProgram());
    for (unsigned f : features.materialFeatures)
        add(Step::renderData, gBufferProgram(f, targets));
    if (read.voxels && settings.voxels == Voxels::directional) {
        add(Step::voxelize, clearDynamicProgram(emission));
        add(Step::voxelize, clearBlocksProgram());
        add(Step::voxelize, resetListsProgram());
        add(Step::voxelize, markStaticProgram());
        if (settings.cascades > 1) {
            add(Step::voxelize, unlistStaticProgram(emission));
            add(Step::voxelize, scrollProgram(emission));
            add(Step::voxelize, listFreeProgram());
            add(Step::voxelize, listBlocksProgram());
        }
        for (unsigned f : features.materialFeatures) {
            add(Step::voxelize, markFacesProgram(f));
            add(Step::voxelize, accumulateProgram(f, emission));
        }
        add(Step::voxelize, listFacesProgram());
        add(Step::voxelize, resolveProgram(emission));
        add(Step::voxelize, fillBlocksProgram(emission));
        if (read.ambientVisibility || read.indirectLight) {
            for (const char* name : lightPrograms)
                add(Step::irradiance, lightProgram(name, lights));
            if (lights.emitters) add(Step::irradiance, emittersProgram(lights));
            add(Step::inject, injectProgram(lights));
            const auto addRays = [&](std::initializer_list<const char*> names) {
                for (const char* name : names)
                    add(Step::irradiance, raysProgram(name, settings.gather, lights));
            };
            addRays({"sky", "trace", "gather", "refine", "smooth_rows", "smooth"});
            if (features.movingObjects || settings.revoxelize || settings.cascades > 1)
                addRays({"carry_over", "carry_hits"});
            if (settings.cascades > 1) addRays({"forward_hits", "list_visited"});
            if (features.movingObjects) addRays({"block"});
        }
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
    if (targets.gloss && read.reflections) {
        add(Step::trace, markGlossProgram());
        add(Step::trace, halfGlossProgram(targets.mappedNormals, lights));
        add(Step::trace, glossProgram(targets.mappedNormals, lights));
    }
    return programs;
}

std::vector<unsigned> allFeatures() {
    std::vector<unsigned> all;
    for (unsigned features = 0; features < materialFeatureCombinations; ++features)
        if (possible(features)) all.push_back(features);
    // Features of materials and punctual lights are handled in separate functions of the shaders, so one
    // combination with all material features represents the others.
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

std::size_t linkNext(const gl::ShaderLibrary& library, const Settings& settings, Output mode,
                     const SceneFeatures& features, const gl::Capabilities& capabilities) {
    std::vector<gl::ProgramDescription> missing;
    for (const FrameProgram& use : framePrograms(settings, mode, features, capabilities))
        if (!library.cache->contains(library, use.program)) missing.push_back(use.program);
    if (!missing.empty()) gl::Program(library, missing.front());  // the cache keeps it
    return missing.size();
}

}  // namespace vct
