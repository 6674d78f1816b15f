// The parts of a glTF file that the example draws: meshes with textures, one skin, one animation, a camera
// and a sun. It does not depend on the library.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <string>
#include <vector>

struct Picture {
    int width = 0, height = 0;
    std::vector<unsigned char> rgba;
};

struct Surface {
    glm::vec3 baseColor{1.0F}, emission{0.0F};
    int picture = -1;  // index into Model::pictures, or -1
};

// Triangles of one material, placed in the world by a node or by the joints of the skin.
struct Part {
    std::string name;
    std::size_t surface = 0;
    int node = 0;
    bool hasSkin = false;
    std::vector<glm::vec3> positions, normals;
    std::vector<glm::vec2> coordinates;
    std::vector<glm::u8vec4> joints;
    std::vector<glm::vec4> weights;
    std::vector<std::uint32_t> indices;
};

struct Node {
    int parent = -1;
    glm::vec3 translation{0.0F}, scale{1.0F};
    glm::quat rotation{1, 0, 0, 0};
};

// Keys of one property of a node, interpolated linearly.
struct Channel {
    int node = 0;
    bool isRotation = false;  // else a translation
    std::vector<float> times;
    std::vector<glm::vec4> values;
};

struct Model {
    std::vector<Picture> pictures;
    std::vector<Surface> surfaces;
    std::vector<Part> parts;
    std::vector<Node> nodes;
    std::vector<Channel> channels;
    std::vector<int> jointNodes;
    std::vector<glm::mat4> inverseBind;  // by joint
    glm::mat4 worldFromCamera{1.0F};
    float verticalFovRad = 0.8F;
    glm::vec3 directionToSun{0, 1, 0}, sunColor{1.0F};
    float sunIlluminance = 0.0F;

    // Throws std::runtime_error.
    explicit Model(const std::string& path);
    // Moves the nodes to a time of the animation, which repeats.
    void animate(float seconds);
    glm::mat4 worldFromNode(int node) const;
    // Positions and normals of a part with a skin, in the world.
    void deform(const Part& part, std::vector<glm::vec3>& positions, std::vector<glm::vec3>& normals) const;
};
