// The app's own programs. Three present a frame (app/presenter.h); the last draws the panel, and also
// compiles in ESSL 3.00.
#pragma once

#include "gl/program.h"

namespace vct::app {

inline gl::ProgramDescription toneMapProgram() {
    return {"tone map", {"passes/full_screen.vert", "app/tone_map.frag"}, {}};
}

inline gl::ProgramDescription smoothProgram() {
    return {"smooth", {"passes/full_screen.vert", "app/smooth.frag"}, {}};
}

inline gl::ProgramDescription scaleProgram() {
    return {"scale", {"passes/full_screen.vert", "app/scale.frag"}, {}};
}

inline gl::ProgramDescription hudProgram() {
    return {"hud", {"app/hud.vert", "app/hud.frag"}, {}};
}

}  // namespace vct::app
