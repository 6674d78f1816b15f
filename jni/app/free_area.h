// The part of a window where a panel can be read and touched.
#pragma once

#include <array>
#include <glm/glm.hpp>

namespace vct::app {

// Pixels at each side of a window.
struct Edges {
    int left = 0, top = 0, right = 0, bottom = 0;
};

// The parts of a window that the system covers or the screen does not have.
struct WindowInsets {
    Edges edges;                          // under system bars and cutouts (notches, cameras)
    std::array<int, 4> cornerRadii = {};  // of rounded corners, clockwise from the top left
};

// Returns left, top, right and bottom of a rectangle that no system bar, cutout or rounded corner covers. It
// is the whole window if the insets leave less than half of a side, because then they belong to another size
// of the window: the system tells about a rotation in several steps.
glm::ivec4 freeArea(glm::ivec2 window, const WindowInsets& insets);

}  // namespace vct::app
