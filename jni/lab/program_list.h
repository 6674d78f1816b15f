// Lists every program of the renderer in every possible variant. The tests compile all of them offline, and
// `vct shaders` writes those of a frame.
#pragma once

#include "engine/output.h"
#include "engine/settings.h"
#include "engine/step_timer.h"
#include "gl/capabilities.h"
#include "gl/program.h"
#include "scene/scene_features.h"

namespace vct {

// The combinations of MaterialFeature that programs are listed for.
std::vector<unsigned> allFeatures();

std::vector<gl::ProgramDescription> everyProgram();

// A program, and the step that runs it. framePrograms() lists the programs of a mode in a scene with these
// features, each once, as a driver with these capabilities runs them.
struct FrameProgram {
    Step step;
    gl::ProgramDescription program;
};
std::vector<FrameProgram> framePrograms(const Settings& settings, Output mode, const SceneFeatures& features,
                                        const gl::Capabilities& capabilities);

// Links one program that such frames need and the library's cache lacks. Returns how many were missing; 0:
// all are linked. Throws vct::Error.
std::size_t linkNext(const gl::ShaderLibrary& library, const Settings& settings, Output mode,
                     const SceneFeatures& features, const gl::Capabilities& capabilities);

}  // namespace vct
