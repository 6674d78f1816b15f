// Every program of the renderer and every variant that can be asked for, in one list: passes take their
// descriptions from here, and the tests compile all of them offline.
#pragma once

#include "engine/settings.h"
#include "gl/capabilities.h"
#include "gl/program.h"
#include "lab/step_timer.h"
#include "scene/scene_features.h"

namespace vct {

// Where the passes of one renderer take their shaders from, with the defines that the settings' experiments
// and the driver's arithmetic ask of all of them (shaders/shared/precision.glsl).
gl::ShaderLibrary shaderLibrary(const Settings& settings, const gl::Capabilities& capabilities,
                                gl::ReadShader read);

// Every combination of MaterialFeature that a material can have.
std::vector<unsigned> allFeatures();

gl::ProgramDescription shadowMapProgram(unsigned features);
gl::ProgramDescription shadowLevelProgram();
// Targets that the G-buffer has where something in the scene needs them: a material that emits; a glossy one.
struct ExtraTargets {
    bool emissive = false;
    bool gloss = false;
};
ExtraTargets extraTargets(const SceneFeatures& needs, Specular specular);
gl::ProgramDescription gBufferProgram(unsigned features, ExtraTargets targets);
gl::ProgramDescription packedVoxelizerProgram(unsigned features, Voxelization voxelization);
gl::ProgramDescription packedMipmapperProgram();
gl::ProgramDescription packedClearProgram();
gl::ProgramDescription occupancyProgram(unsigned features, Voxelization voxelization);
gl::ProgramDescription directionalVoxelizerProgram(unsigned features, Voxelization voxelization);
gl::ProgramDescription directionalResolveProgram();
// Where only the light changed: engine/directional/relighter.h.
gl::ProgramDescription clearRadianceProgram();
gl::ProgramDescription relightProgram(unsigned features, Voxelization voxelization);
gl::ProgramDescription relightResolveProgram();
// Of the static geometry of a scene where something moves, and of a part:
// engine/directional/incremental_update.h.
gl::ProgramDescription staticVoxelizerProgram(unsigned features, Voxelization voxelization);
gl::ProgramDescription staticResolveProgram();
gl::ProgramDescription dirtyResolveProgram();
gl::ProgramDescription dirtyMipmapperProgram();
gl::ProgramDescription dirtyClearBaseProgram();
gl::ProgramDescription directionalLevelsProgram();  // and the next level's lists
gl::ProgramDescription directionalMipmapperProgram();
gl::ProgramDescription directionalClearProgram();
gl::ProgramDescription directionalClearBaseProgram();
// Light that the faces receive: engine/directional/irradiance.h. `name`: light_inherit, light_clear,
// light_bricks or light_shine.
gl::ProgramDescription lightProgram(const std::string& name);
gl::ProgramDescription irradianceProgram(const GatherSettings& settings, GatherOf of);
// `mode` is one of VCT_MODE_* and VCT_VIEW_*.
gl::ProgramDescription shadeProgram(int mode, ExtraTargets targets, const Settings& settings);
gl::ProgramDescription voxelViewProgram();
// `stage` is one of VCT_STAGE_*.
gl::ProgramDescription debugViewProgram(int stage);

// The picture in a window, sRGB-encoded and scaled.
gl::ProgramDescription presentProgram();
// The head-up display; also compiles in ESSL 3.00.
gl::ProgramDescription hudProgram();

std::vector<gl::ProgramDescription> everyProgram();

// What one frame of a mode runs, step by step, in a scene with these needs; each program once.
struct FrameProgram {
    Step step;
    gl::ProgramDescription program;
};
std::vector<FrameProgram> framePrograms(const Settings& settings, Mode mode, const SceneFeatures& needs);

}  // namespace vct
