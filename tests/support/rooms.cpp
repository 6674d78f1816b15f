#include "support/rooms.h"

#include "scene/camera.h"
#include "support/scenes.h"

namespace vct::test {

namespace {

const glm::dvec3 roomHalf(1.0, 0.8, 1.2);
// The window is in the wall at +x.
const glm::dvec2 windowLow(-0.3, -0.5), windowHigh(0.4, 0.6);  // y, z

void addSheets(Scene& scene, Opening opening) {
    const glm::dvec3 x(2.0 * roomHalf.x, 0, 0), y(0, 2.0 * roomHalf.y, 0), z(0, 0, 2.0 * roomHalf.z);
    addQuad(scene, -roomHalf, z, x);                               // floor, facing +y
    addQuad(scene, {-roomHalf.x, roomHalf.y, -roomHalf.z}, x, z);  // ceiling
    addQuad(scene, -roomHalf, y, z);                               // left, facing +x
    addQuad(scene, -roomHalf, x, y);                               // back, facing +z
    if (opening != Opening::front) addQuad(scene, {-roomHalf.x, -roomHalf.y, roomHalf.z}, y, x);
    if (opening != Opening::window) {
        addQuad(scene, {roomHalf.x, -roomHalf.y, -roomHalf.z}, z, y);
        return;
    }
    const auto piece = [&](double y0, double y1, double z0, double z1) {
        addQuad(scene, {roomHalf.x, y0, z0}, {0, 0, z1 - z0}, {0, y1 - y0, 0});
    };
    piece(-roomHalf.y, windowLow.x, -roomHalf.z, roomHalf.z);
    piece(windowHigh.x, roomHalf.y, -roomHalf.z, roomHalf.z);
    piece(windowLow.x, windowHigh.x, -roomHalf.z, windowLow.y);
    piece(windowLow.x, windowHigh.x, windowHigh.y, roomHalf.z);
}

void addSlabs(Scene& scene, Opening opening, double thickness) {
    const auto slab = [&](const glm::dvec3& low, const glm::dvec3& high) {
        addBox(scene, high - low, 0.5 * (low + high));
    };
    const glm::dvec3 out = roomHalf + thickness;
    slab({-out.x, -out.y, -out.z}, {out.x, -roomHalf.y, out.z});
    slab({-out.x, roomHalf.y, -out.z}, {out.x, out.y, out.z});
    slab({-out.x, -roomHalf.y, -out.z}, {-roomHalf.x, roomHalf.y, out.z});
    slab({-roomHalf.x, -roomHalf.y, -out.z}, {roomHalf.x, roomHalf.y, -roomHalf.z});
    if (opening != Opening::front)
        slab({-roomHalf.x, -roomHalf.y, roomHalf.z}, {roomHalf.x, roomHalf.y, out.z});
    if (opening != Opening::window) {
        slab({roomHalf.x, -roomHalf.y, -out.z}, {out.x, roomHalf.y, out.z});
        return;
    }
    slab({roomHalf.x, -roomHalf.y, -out.z}, {out.x, windowLow.x, out.z});
    slab({roomHalf.x, windowHigh.x, -out.z}, {out.x, roomHalf.y, out.z});
    slab({roomHalf.x, windowLow.x, -out.z}, {out.x, windowHigh.x, windowLow.y});
    slab({roomHalf.x, windowLow.x, windowHigh.y}, {out.x, windowHigh.x, out.z});
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
    addBox(room.scene, {0.5, 0.6, 0.4}, {-0.35, -roomHalf.y + 0.3, -0.4});
    addBox(room.scene, {0.03, 1.0, 0.03}, {0.5, -roomHalf.y + 0.5, 0.1});
    const bool inside = opening != Opening::front;
    room.camera = lookAt({-0.2, 0.1, inside ? roomHalf.z - 0.06 : roomHalf.z + 1.3},
                         {0.1, -0.05, -roomHalf.z}, inside ? 85 : 62);
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
