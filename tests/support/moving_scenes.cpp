#include "support/moving_scenes.h"

#include "scene/camera.h"

namespace vct::test {

namespace {

int addMesh(GltfBuilder& builder, const std::vector<float>& positions,
            const std::vector<std::uint16_t>& indices, const std::vector<float>& color) {
    const int material = builder.add(
        "materials", {{"pbrMetallicRoughness",
                       {{"baseColorFactor", {color[0], color[1], color[2], 1.0}}, {"metallicFactor", 0.0}}}});
    return builder.mesh({{"attributes", {{"POSITION", builder.floats(positions)}}},
                         {"indices", builder.accessor(indices, uint16, "SCALAR")},
                         {"material", material}});
}

}  // namespace

int addCube(GltfBuilder& builder, const std::vector<float>& color, json node) {
    std::vector<float> corners;
    for (int i = 0; i < 8; ++i)
        for (int axis = 0; axis < 3; ++axis)
            corners.push_back((i >> axis & 1) != 0 ? 0.5F : -0.5F);
    node["mesh"] = addMesh(builder, corners, {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                              2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6},
                           color);
    return builder.node(std::move(node));
}

GltfBuilder openFloor() {
    GltfBuilder builder;
    builder.node({{"mesh", addMesh(builder, {-2, 0, -2, -2, 0, 2, 2, 0, 2, 2, 0, -2}, {0, 1, 2, 0, 2, 3},
                                   {0.8F, 0.8F, 0.8F})}});
    builder.document["extensionsUsed"] = {"KHR_lights_punctual"};
    builder.document["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "directional"}, {"intensity", 3.14159265}}};
    // 60 degrees down, about +X.
    builder.node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}},
                  {"name", "sun"},
                  {"rotation", {-0.5, 0, 0, 0.8660254}}});
    builder.add(
        "cameras",
        {{"type", "perspective"}, {"name", "front"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}});
    // 0.4 rad down.
    builder.node(
        {{"camera", 0}, {"translation", {0, 2.6, 5.2}}, {"rotation", {-0.1986693, 0, 0, 0.9800666}}});
    return builder;
}

GltfBuilder twoThatMove() {
    GltfBuilder builder = openFloor();
    addCube(builder, {0.2F, 0.7F, 0.2F}, {{"translation", {1, 0.5, -1}}});
    const int box = addCube(builder, {0.8F, 0.1F, 0.1F}, {{"translation", {-1, 0.6, -1}}});
    const int mesh = builder.document["nodes"][static_cast<std::size_t>(box)]["mesh"];
    const int child =
        builder.add("nodes", {{"mesh", mesh}, {"scale", {-0.5, 0.5, 0.3}}, {"translation", {0, 0.9, 0}}});
    builder.document["nodes"][static_cast<std::size_t>(box)]["children"] = {child};
    builder.animate(box, "translation", {0, 2}, {-1, 0.6F, -1, 1.2F, 0.7F, -0.8F});
    // Inside out, and flat in between.
    builder.animate(child, "scale", {0, 2}, {-0.5F, 0.5F, 0.3F, 0.5F, 0.5F, 0.3F});
    builder.animate(box, "rotation", {0, 1, 2},
                    {0, 0, 0, 1, 0.3F, 0.5F, 0.1F, 0.8F, 0.1F, 0.9F, -0.2F, 0.3F});
    return builder;
}

Scene frozenAt(Scene scene, double seconds) {
    const Pose pose = poseAt(scene.animation, seconds);
    for (Instance& instance : scene.instances) {
        if (instance.moves())
            instance.worldFromObject = pose.worldFromNode.at(static_cast<std::size_t>(instance.node));
        instance.node = -1;
    }
    for (Camera& camera : scene.cameras) {
        camera = posed(camera, pose);
        camera.node = -1;
    }
    for (DirectionalLight& light : scene.lights) {
        light = posed(light, pose);
        light.node = -1;
    }
    for (PunctualLight& light : scene.punctualLights) {
        light = posed(light, pose);
        light.node = -1;
    }
    scene.animation = {};
    return scene;
}

}  // namespace vct::test
