// Rooms into which the sun shines through an opening, or not at all.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace vct::test {

struct Room {
    std::string name;
    Scene scene;
    Camera camera;  // sees most creases
};

enum class Opening { none, front, window };

// 2 x 1.6 x 2.4, with a box and a post on its floor. `thickness`: of walls that are boxes; 0: they are
// rectangles, whose front is inside. `angleDeg`: turns everything around an oblique axis.
Room makeRoom(Opening opening, double thickness, bool doubleSided, double angleDeg);

std::vector<Room> everyRoom();

}  // namespace vct::test
