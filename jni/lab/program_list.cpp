#include "lab/program_list.h"

#include <set>
#include <string>
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

bool possible(unsigned features) {
    return !(features & featureEmissiveTexture) || (features & featureEmissive);
}

std::vector<FrameProgram> programsOf(const Settings& settings, Output mode, const SceneFeatures& features,
                                     Voxelization voxelization, bool compactEmitters) {
    std::vector<FrameProgram> programs;
    const auto add = [&](Step step, const gl::ProgramDescription& program) {
        for (const FrameProgram& known : programs)
            if (known.program.name == program.name && known.program.defines == program.defines) return;
        programs.push_back({step, program});
    };
    const ExtraTargets targets = extraTargets(features, settings.voxels);
    const bool isEmissive = features.has(featureEmissive),
               emission = isEmissive && (features.materialsChange || !compactEmitters);
    const LightFeatures lights{features.has(featurePunctualLights), settings.environment != nullptr,
                               settings.voxels == Voxels::directional && isEmissive && compactEmitters,
                               emission};
    const OutputReads& read = reads(mode);
    if (read.shadowMap())
        for (unsigned f : features.materialFeatures)
            add(Step::shadowMap, shadowMapProgram(f));
    if (read.softShadow && settings.voxels == Voxels::directional) add(Step::shadowMap, shadowLevelProgram());
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
            add(Step::voxelize, listFreshProgram());
            add(Step::voxelize, listBlocksProgram());
        }
        for (unsigned f : features.materialFeatures) {
            add(Step::voxelize, markFacesProgram(f));
            add(Step::voxelize, accumulateProgram(f, emission));
        }
        add(Step::voxelize, listFacesProgram(emission));
        add(Step::voxelize, resolveProgram(emission));
        add(Step::voxelize, extentsProgram(emission));
        add(Step::voxelize, fillBlocksProgram(emission));
        if (read.ambientVisibility || read.indirectLight) {
            for (const char* name :
                 {"clear_bricks", "place_bricks", "mark_walls", "link_faces", "fill_bricks"})
                add(Step::irradiance, lightProgram(name, lights));
            if (lights.emitters) add(Step::irradiance, emittersProgram(lights));
            add(Step::inject, injectProgram(lights));
            const auto addRays = [&](std::initializer_list<const char*> names) {
                for (const char* name : names)
                    add(Step::irradiance, raysProgram(name, settings.gatherOfFrames(), lights));
            };
            addRays({"sky", "trace", "gather", "refine", "smooth_rows", "smooth"});
            if (features.movingObjects || settings.revoxelize || settings.cascades > 1)
                addRays({"carry_over", "carry_hits", "trace_moving"});
            if (settings.cascades > 1) addRays({"forward_hits", "list_visited"});
            if (settings.cascades > 1) add(Step::irradiance, lightProgram("list_arrived", lights));
            if (features.movingObjects) addRays({"block_rays"});
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
        add(Step::trace, filterGlossProgram(targets.mappedNormals, lights));
        add(Step::trace, glossProgram(targets.mappedNormals, lights));
    }
    return programs;
}

// A scene for each combination of what programs depend on, with all materials that it can have.
std::vector<SceneFeatures> everyScene() {
    std::vector<SceneFeatures> scenes;
    for (const unsigned emission : {0U, featureEmissive | featureUnlit})
        for (const unsigned normalMap : {0U, unsigned{featureNormalMap}})
            for (const unsigned punctual : {0U, unsigned{featurePunctualLights}})
                for (const bool glossy : {false, true}) {
                    SceneFeatures scene;
                    const unsigned missing =
                        (featureEmissive | featureUnlit | featureNormalMap | featurePunctualLights) &
                        ~(emission | normalMap | punctual);
                    for (const unsigned features : allFeatures())
                        if ((features & missing) == 0) scene.materialFeatures.push_back(features);
                    scene.glossy = glossy;
                    scene.movingObjects = scene.deforms = true;
                    scenes.push_back(std::move(scene));
                }
    return scenes;
}

// Settings for each combination of what programs depend on.
std::vector<Settings> everySettings() {
    std::vector<Settings> all;
    for (const std::string& preset : presetNames())
        all.push_back(presetSettings(preset));
    Settings soft = presetSettings("mobile");
    soft.lightRadius = 0.1F;
    soft.cascades = 2;
    all.push_back(soft);
    soft.voxels = Voxels::packed;
    soft.cascades = 1;
    all.push_back(soft);
    const auto sky = std::make_shared<const Environment>(Image(2, 1), "of no light");
    for (std::size_t i = 0, count = all.size(); i < count; ++i) {
        all.push_back(all[i]);
        all.back().environment = sky;
    }
    return all;
}

}  // namespace

std::vector<gl::ProgramDescription> everyProgram() {
    std::vector<gl::ProgramDescription> programs{voxelViewProgram(), copyVerticesProgram()};
    for (int view = VCT_DEBUG_VIEW_SHADOW_MAP; view <= VCT_DEBUG_VIEW_EMISSIVE; ++view)
        programs.push_back(debugViewProgram(view));
    for (const gl::ProgramDescription& program : driverCheckPrograms())
        programs.push_back(program);
    std::set<std::pair<std::vector<std::string>, std::vector<std::string>>> known;
    const auto addFrames = [&](const Settings& settings, const SceneFeatures& scene,
                               Voxelization voxelization, bool compactEmitters) {
        for (const OutputReads& read : outputTable)
            for (const FrameProgram& use :
                 programsOf(settings, read.output, scene, voxelization, compactEmitters))
                if (known.emplace(use.program.shaders, use.program.defines).second)
                    programs.push_back(use.program);
    };
    const std::vector<SceneFeatures> scenes = everyScene();
    for (const Settings& settings : everySettings())
        for (const SceneFeatures& scene : scenes) {
            addFrames(settings, scene, Voxelization::sortedAxes, true);
            SceneFeatures changing = scene;
            changing.materialsChange = true;
            addFrames(settings, changing, Voxelization::sortedAxes, true);
            if (settings.voxels == Voxels::packed)
                addFrames(settings, scene, Voxelization::geometryShader, true);
            else
                addFrames(settings, scene, Voxelization::sortedAxes, false);
        }
    return programs;
}

std::vector<FrameProgram> framePrograms(const Settings& settings, Output mode, const SceneFeatures& features,
                                        const gl::Capabilities& capabilities) {
    // Assumes that all emitters of the scene are compact.
    return programsOf(settings, mode, features, voxelizationFor(settings.voxels, capabilities), true);
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
