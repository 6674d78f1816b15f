// Loads the node hierarchy of a glTF file as a flat list, its cameras, and the animation of the nodes.
#pragma once

#include <vector>

#include "scene/gltf_file.h"

namespace vct {

struct PlacedNode {
    const tinygltf::Node* node = nullptr;
    glm::dmat4 worldFromNode{1.0};
    NodeTransform transform;
    int parent = -1;        // index of a node before this one; -1: none
    int moving = -1;        // index into Animation::nodes; -1: it never moves
    int morph = -1;         // index into Animation::morphWeights; -1: its weights never change
    bool isVisible = true;  // KHR_node_visibility hides neither it nor an ancestor
};

// Returns the root nodes of the default scene, or all nodes without a parent if the file has no scenes.
std::vector<int> rootsOf(const GltfFile& file);

// Throws vct::Error if a node's transformation has elements that are not finite, or above 1e30.
void checkFinite(const GltfFile& file, const glm::dmat4& matrix, const tinygltf::Node& node);

// Returns the nodes of the default scene, parents first. Throws vct::Error if a node is in the scene twice.
std::vector<PlacedNode> placeNodes(const GltfFile& file);

// Adds the nodes' cameras to the scene, whose bounds must be known: first the perspective cameras, then the
// orthographic ones, converted to perspective. Warns about these, and about cameras that it leaves out.
void addCameras(GltfFile& file, const std::vector<PlacedNode>& nodes, Scene& scene);

// Returns the weights at rest of the morph targets of the node's mesh.
std::vector<float> morphWeightsAtRest(const GltfFile& file, const tinygltf::Node& node);

// Loads the animation `nameOrIndex` ("": the first, if there is one), and marks in `placed` the nodes that it
// moves. Throws vct::Error if the animation was asked for and does not exist or is not valid. Warns about
// animations that are not played, and about an invalid first one that was not asked for.
Animation loadAnimation(GltfFile& file, const std::string& nameOrIndex, std::vector<PlacedNode>& placed);

}  // namespace vct
