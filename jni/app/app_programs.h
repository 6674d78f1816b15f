// The app's own programs: the picture in a window, sRGB-encoded and scaled, and the head-up display, which
// also compiles in ESSL 3.00.
#pragma once

#include "gl/program.h"

namespace vct::app {

inline gl::ProgramDescription presentProgram() {
    return {"present", {"passes/full_screen.vert", "app/present.frag"}, {}};
}

inline gl::ProgramDescription hudProgram() {
    return {"hud", {"app/hud.vert", "app/hud.frag"}, {}};
}

}  // namespace vct::app
