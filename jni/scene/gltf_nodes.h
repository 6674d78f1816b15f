// The node hierarchy of a glTF file, flattened, and what moves it.
#pragma once

#include <vector>

#include "scene/gltf_file.h"

namespace vct {

struct PlacedNode {
    const tinygltf::Node* node = nullptr;
    glm::dmat4 worldFromNode{1.0};
    NodeTransform transform;
    int parent = -1;  // index of a node before it, or -1
    int moving = -1;  // index into Animation::nodes, or -1: it never moves
    int morph = -1;   // index into Animation::morphWeights, or -1: its weights never change
};

// Throws where a transformation of a node has elements that are not numbers, or too large to reckon with.
void checkFinite(const GltfFile& file, const glm::dmat4& matrix, const tinygltf::Node& node);

// The nodes of the default scene, parents first. Throws where one is in the scene twice.
std::vector<PlacedNode> placeNodes(const GltfFile& file);

// The nodes' cameras, added to the scene, whose bounds are known: perspective ones, then orthographic ones,
// made perspective. Warns of these, and of what is left out.
void addCameras(GltfFile& file, const std::vector<PlacedNode>& nodes, Scene& scene);

// Of each morph target that a primitive of the node's mesh has, at rest.
std::vector<float> morphWeightsAtRest(const GltfFile& file, const tinygltf::Node& node);

// The animation `nameOrIndex` ("" takes the first; where the file has none, there is none), and in `placed`
// which nodes it moves. Throws where one was asked for that is not there or not valid; warns of those that
// are not played, and of a first one that is not valid.
Animation loadAnimation(GltfFile& file, const std::string& nameOrIndex, std::vector<PlacedNode>& placed);

}  // namespace vct
