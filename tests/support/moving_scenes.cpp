#include "support/moving_scenes.h"

#include <cmath>

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
    // The child turns inside out.
    builder.animate(child, "scale", {0, 2}, {-0.5F, 0.5F, 0.3F, 0.5F, 0.5F, 0.3F});
    builder.animate(box, "rotation", {0, 1, 2},
                    {0, 0, 0, 1, 0.3F, 0.5F, 0.1F, 0.8F, 0.1F, 0.9F, -0.2F, 0.3F});
    return builder;
}

namespace {

// A column of `rings` octagons, 1.6 high. Each ring follows the two joints next to it.
json columnOf(GltfBuilder& builder, int rings) {
    std::vector<float> positions, normals, weights;
    std::vector<std::uint8_t> joints;
    std::vector<std::uint16_t> indices;
    for (int ring = 0; ring < rings; ++ring)
        for (int i = 0; i < 8; ++i) {
            const float angle = static_cast<float>(i) * 0.785398163F;
            const float along = static_cast<float>(ring) / static_cast<float>(rings - 1) * 2.0F;
            positions.insert(positions.end(),
                             {0.25F * std::cos(angle), 0.8F * along, 0.25F * std::sin(angle)});
            normals.insert(normals.end(), {std::cos(angle), 0.0F, std::sin(angle)});
            const int lower = along < 1.0F ? 0 : 1;
            const float share = along - static_cast<float>(lower);
            joints.insert(joints.end(),
                          {static_cast<std::uint8_t>(lower), static_cast<std::uint8_t>(lower + 1), 0, 0});
            weights.insert(weights.end(), {1.0F - share, share, 0.0F, 0.0F});
            if (ring == 0) continue;
            const auto at = [&](int r, int k) { return static_cast<std::uint16_t>(8 * r + k % 8); };
            indices.insert(indices.end(), {at(ring - 1, i), at(ring, i), at(ring, i + 1), at(ring - 1, i),
                                           at(ring, i + 1), at(ring - 1, i + 1)});
        }
    return {{"attributes",
             {{"POSITION", builder.floats(positions)},
              {"NORMAL", builder.floats(normals)},
              {"JOINTS_0", builder.accessor(joints, uint8, "VEC4")},
              {"WEIGHTS_0", builder.floats(weights, "VEC4")}}},
            {"indices", builder.accessor(indices, uint16, "SCALAR")},
            {"material",
             builder.add("materials", {{"doubleSided", true},
                                       {"pbrMetallicRoughness",
                                        {{"baseColorFactor", {0.8, 0.3, 0.1, 1}}, {"metallicFactor", 0}}}})}};
}

}  // namespace

GltfBuilder twoThatDeform() {
    GltfBuilder builder = openFloor();
    json& document = builder.document;
    // The joints are 0.8 apart. In the mesh the lowest one is at the origin.
    const int hand = builder.add("nodes", {{"translation", {0, 0.8, 0}}});
    const int knee = builder.add("nodes", {{"translation", {0, 0.8, 0}}, {"children", {hand}}});
    const int foot = builder.node({{"translation", {-1, 0, -0.5}}, {"children", {knee}}});
    std::vector<float> inverseBind;
    for (const float height : {0.0F, 0.8F, 1.6F})
        inverseBind.insert(inverseBind.end(), {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -height, 0, 1});
    builder.add("skins", {{"joints", {foot, knee, hand}},
                          {"inverseBindMatrices", builder.floats(inverseBind, "MAT4")}});
    builder.node({{"mesh", builder.mesh(columnOf(builder, 9))}, {"skin", 0}, {"translation", {50, 7, 3}}});
    builder.animate(foot, "translation", {0, 2}, {-1, 0, -0.5F, 0.6F, 0, 0.2F});
    builder.animate(knee, "rotation", {0, 1, 2},
                    {0, 0, 0, 1, 0, 0, 0.3826834F, 0.9238795F, 0.3826834F, 0, 0, 0.9238795F});
    builder.animate(hand, "scale", {0, 2}, {1, 1, 1, 2, 0.5F, 2});

    const int box = addCube(builder, {0.1F, 0.4F, 0.8F}, {{"translation", {1, 0.5, -0.8}}});
    const int mesh = document["nodes"][static_cast<std::size_t>(box)]["mesh"];
    std::vector<float> swelling, leaning;
    for (int i = 0; i < 8; ++i) {
        const bool top = (i >> 1 & 1) != 0;
        swelling.insert(swelling.end(), {top ? ((i & 1) != 0 ? 0.4F : -0.4F) : 0.0F, top ? 0.3F : 0.0F, 0});
        leaning.insert(leaning.end(), {0, 0, top ? 0.5F : 0.0F});
    }
    document["meshes"][static_cast<std::size_t>(mesh)]["primitives"][0]["targets"] = {
        {{"POSITION", builder.floats(swelling)}}, {{"POSITION", builder.floats(leaning)}}};
    builder.animate(box, "weights", {0, 1, 2}, {0, 0, 1, 0, 0.5F, 1});
    return builder;
}

Scene frozenAt(Scene scene, double seconds) {
    const Pose pose = poseAt(scene.animation, seconds);
    for (Instance& instance : scene.instances) {
        if (instance.deforms) {
            Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
            const DeformationState state = stateOf(*mesh.deformation, &pose);
            for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
                const DeformedVertex vertex = deformedVertex(*mesh.deformation, state, i);
                mesh.vertices[i].position = glm::vec3(vertex.positionWorld - mesh.centre);
                mesh.vertices[i].normal = glm::vec3(vertex.normalWorld);
            }
            mesh.deformation = nullptr;
            instance.deforms = false;
        }
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
