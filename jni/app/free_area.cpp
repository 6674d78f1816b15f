#include "app/free_area.h"

#include <algorithm>
#include <cmath>

namespace vct::app {

namespace {

// Moves the corner of a rectangle, `x` and `y` pixels away from the window's, out of the rounded corner.
void leaveCorner(int radius, int& x, int& y) {
    const double r = radius;
    const auto arc = [&](int along) {
        const double rest = r - std::min<double>(along, r);
        return static_cast<int>(std::ceil(r - std::sqrt(r * r - rest * rest)));
    };
    // The point in the middle of the arc costs the least of both sides.
    const int middle = static_cast<int>(std::ceil(r * (1.0 - std::sqrt(0.5))));
    if (x < middle && y < middle)
        x = y = middle;
    else if (x < y)
        x = std::max(x, arc(y));
    else
        y = std::max(y, arc(x));
}

}  // namespace

glm::ivec4 freeArea(glm::ivec2 window, const WindowInsets& insets) {
    Edges edges = insets.edges;
    leaveCorner(insets.cornerRadii[0], edges.left, edges.top);
    leaveCorner(insets.cornerRadii[1], edges.right, edges.top);
    leaveCorner(insets.cornerRadii[2], edges.right, edges.bottom);
    leaveCorner(insets.cornerRadii[3], edges.left, edges.bottom);
    const glm::ivec4 free(edges.left, edges.top, window.x - edges.right, window.y - edges.bottom);
    const bool isPlausible = free.z - free.x >= window.x / 2 && free.w - free.y >= window.y / 2;
    return isPlausible ? free : glm::ivec4(0, 0, window);
}

}  // namespace vct::app
