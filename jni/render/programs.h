// Every program of the renderer and every variant that can be asked for, in one list: passes take their
// descriptions from here, and the tests compile all of them offline.
#pragma once

#include "gl/capabilities.h"
#include "gl/program.h"
#include "render/settings.h"
#include "render/step_timer.h"
#include "scene/scene.h"

namespace vct {

// Where the passes of one renderer take their shaders from, with the defines that the settings' experiments
// and the driver's arithmetic ask of all of them (shaders/shared/precision.glsl).
gl::ShaderLibrary shaderLibrary(const Settings& settings, const gl::Capabilities& capabilities,
                                gl::ReadShader read);

// What occurs in a material; a draw call pays for nothing else. Bits.
enum MaterialFeature : unsigned {
    featureBaseColorTexture = 1,
    featureAlphaMask = 2,
    featureEmissive = 4,
    featureEmissiveTexture = 8,
    featureGlossy = 16,  // roughness below 1
    materialFeatureCombinations = 32,
};
unsigned materialFeatures(const Material& material);
// Of all the materials that a scene's instances have, without duplicates.
std::vector<unsigned> sceneFeatures(const Scene& scene);
// Every combination that a material can have.
std::vector<unsigned> allFeatures();

gl::ProgramDescription shadowMapProgram(unsigned features);
// Targets that the G-buffer has where something in the scene needs them: a material that emits; a glossy one.
struct ExtraTargets {
    bool emissive = false;
    bool gloss = false;
};
gl::ProgramDescription gBufferProgram(unsigned features, ExtraTargets targets);
gl::ProgramDescription voxelizerProgram(unsigned features, Voxelization voxelization);
gl::ProgramDescription mipmapperProgram();
gl::ProgramDescription sparseClearProgram();
gl::ProgramDescription faceTouchProgram(unsigned features, Voxelization voxelization);
gl::ProgramDescription faceVoxelizerProgram(unsigned features, Voxelization voxelization);
gl::ProgramDescription faceResolveProgram();
gl::ProgramDescription faceParentsProgram();
gl::ProgramDescription faceMipmapperProgram();
gl::ProgramDescription faceClearProgram();
// `pixels`: the gather's settings, from which those of the bounces follow.
gl::ProgramDescription facePatchesProgram();
gl::ProgramDescription faceAlbedosProgram(int grid);
gl::ProgramDescription faceBounceGatherProgram(int grid);
gl::ProgramDescription faceBouncePatchesProgram();
gl::ProgramDescription faceBounceProgram(int grid);
// The level whose blocks gather for bounces: 32^3.
int patchLevel(int grid);
gl::ProgramDescription gatherProgram(const GatherSettings& settings, GatherOf of);
gl::ProgramDescription gatherFilterProgram(const GatherSettings& settings);
// `mode` is one of VCT_MODE_* and VCT_VIEW_*.
gl::ProgramDescription coneTracerProgram(int mode, ExtraTargets targets, const Settings& settings);
gl::ProgramDescription voxelViewProgram();
// `stage` is one of VCT_STAGE_*.
gl::ProgramDescription stageViewProgram(int stage);

// The picture in a window, sRGB-encoded and scaled.
gl::ProgramDescription presentProgram();
// The head-up display; also compiles in ESSL 3.00.
gl::ProgramDescription hudProgram();

std::vector<gl::ProgramDescription> everyProgram();

// What one frame of a mode runs, step by step, in a scene with these material features; each program once.
struct FrameProgram {
    Step step;
    gl::ProgramDescription program;
};
std::vector<FrameProgram> framePrograms(const Settings& settings, Mode mode,
                                        const std::vector<unsigned>& features);

}  // namespace vct
