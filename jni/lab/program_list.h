// Every program of the renderer and every variant that can be asked for: the tests compile all of them
// offline, and `vct shaders` writes those of a frame.
#pragma once

#include "engine/output.h"
#include "engine/settings.h"
#include "engine/step_timer.h"
#include "gl/program.h"
#include "scene/scene_features.h"

namespace vct {

// Every combination of MaterialFeature that a material can have.
std::vector<unsigned> allFeatures();

std::vector<gl::ProgramDescription> everyProgram();

// What one frame of a mode runs, step by step, in a scene with these features; each program once.
struct FrameProgram {
    Step step;
    gl::ProgramDescription program;
};
std::vector<FrameProgram> framePrograms(const Settings& settings, Output mode, const SceneFeatures& features);

}  // namespace vct
