// The app's own programs. One shows the picture in the window, scaled and sRGB-encoded; the other draws the
// panel, and also compiles in ESSL 3.00.
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
