#include "support/rooms.h"

#include "scene/camera.h"
#include "support/scenes.h"

namespace vct::test {

namespace {

const glm::dvec3 half(1.0, 0.8, 1.2);
// The window is in the wall at +x.
const glm::dvec2 windowLow(-0.3, -0.5), windowHigh(0.4, 0.6);  // y, z

void addSheets(Scene& scene, Opening opening) {
    const glm::dvec3 x(2.0 * half.x, 0, 0), y(0, 2.0 * half.y, 0), z(0, 0, 2.0 * half.z);
    addQuad(scene, -half, z, x);                       // floor, facing +y
    addQuad(scene, {-half.x, half.y, -half.z}, x, z);  // ceiling
    addQuad(scene, -half, y, z);                       // left, facing +x
    addQuad(scene, -half, x, y);                       // back, facing +z
    if (opening != Opening::front) addQuad(scene, {-half.x, -half.y, half.z}, y, x);
    if (opening != Opening::window) {
        addQuad(scene, {half.x, -half.y, -half.z}, z, y);
        return;
    }
    const auto piece = [&](double y0, double y1, double z0, double z1) {
        addQuad(scene, {half.x, y0, z0}, {0, 0, z1 - z0}, {0, y1 - y0, 0});
    };
    piece(-half.y, windowLow.x, -half.z, half.z);
    piece(windowHigh.x, half.y, -half.z, half.z);
    piece(windowLow.x, windowHigh.x, -half.z, windowLow.y);
    piece(windowLow.x, windowHigh.x, windowHigh.y, half.z);
}

void addSlabs(Scene& scene, Opening opening, double thickness) {
    const auto slab = [&](const glm::dvec3& low, const glm::dvec3& high) {
        addBox(scene, high - low, 0.5 * (low + high));
    };
    const glm::dvec3 out = half + thickness;
    slab({-out.x, -out.y, -out.z}, {out.x, -half.y, out.z});
    slab({-out.x, half.y, -out.z}, {out.x, out.y, out.z});
    slab({-out.x, -half.y, -out.z}, {-half.x, half.y, out.z});
    slab({-half.x, -half.y, -out.z}, {half.x, half.y, -half.z});
    if (opening != Opening::front) slab({-half.x, -half.y, half.z}, {half.x, half.y, out.z});
    if (opening != Opening::window) {
        slab({half.x, -half.y, -out.z}, {out.x, half.y, out.z});
        return;
    }
    slab({half.x, -half.y, -out.z}, {out.x, windowLow.x, out.z});
    slab({half.x, windowHigh.x, -out.z}, {out.x, half.y, out.z});
    slab({half.x, windowLow.x, -out.z}, {out.x, windowHigh.x, windowLow.y});
    slab({half.x, windowLow.x, windowHigh.y}, {out.x, windowHigh.x, out.z});
}

}  // namespace

Room makeRoom(Opening opening, double thickness, bool doubleSided, double angleDeg) {
    Room room;
    room.scene = emptyScene();
    room.scene.materials.front().doubleSided = doubleSided;
    if (thickness > 0.0)
        addSlabs(room.scene, opening, thickness);
    else
        addSheets(room.scene, opening);
    addBox(room.scene, {0.5, 0.6, 0.4}, {-0.35, -half.y + 0.3, -0.4});
    addBox(room.scene, {0.03, 1.0, 0.03}, {0.5, -half.y + 0.5, 0.1});
    const bool inside = opening != Opening::front;
    room.camera =
        lookAt({-0.2, 0.1, inside ? half.z - 0.06 : half.z + 1.3}, {0.1, -0.05, -half.z}, inside ? 85 : 62);
    const glm::dmat4 turn = turnScene(room.scene, angleDeg);
    room.camera.worldFromCamera = turn * room.camera.worldFromCamera;
    room.scene = finished(std::move(room.scene));
    room.name = std::string(opening == Opening::none    ? "closed"
                            : opening == Opening::front ? "open"
                                                        : "window") +
                (thickness > 0.0 ? ", thin walls" : "") + (doubleSided ? ", double-sided" : "") +
                (angleDeg != 0.0 ? ", turned" : "");
    return room;
}

std::vector<Room> everyRoom() {
    std::vector<Room> rooms;
    for (const double angleDeg : {0.0, 25.0})
        for (const Opening opening : {Opening::none, Opening::front, Opening::window}) {
            rooms.push_back(makeRoom(opening, 0.0, false, angleDeg));
            rooms.push_back(makeRoom(opening, 0.0, true, angleDeg));
            rooms.push_back(makeRoom(opening, 0.04, false, angleDeg));
        }
    return rooms;
}

}  // namespace vct::test
