// Measures the cost of each feature of a scene: renders the scene with and without it, and compares the
// frames.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/renderer.h"
#include "gl/call_log.h"
#include "scene/scene_features.h"

namespace vct {

// A feature that a scene may have, and how to remove it.
struct SceneFeature {
    const char* name;
    bool (*occurs)(const SceneFeatures& found);
    void (*remove)(Scene& scene);
    // True if it makes frames longer that rebuild everything, as the timed frames do.
    bool takesTime = true;
};
const std::vector<SceneFeature>& allSceneFeatures();

struct FrameCost {
    gl::CallSummary calls;  // calls of one frame, after all passes were created
    std::vector<Resource> resources;

    int passes() const { return static_cast<int>(calls.passes.size()); }
    int programs() const { return static_cast<int>(calls.programs.size()); }
    std::size_t bytes() const;
};
// Parameters of the measured frames.
struct FrameOptions {
    Settings settings;
    Output mode = Output::giConeShadow;
    Camera camera;
    DirectionalLight light;
    int timedFrames = 0;  // timed frames of each renderer; 0: no times
};

struct SceneCosts {
    struct Row {
        std::string name;
        bool occurs = false;
        FrameCost without;              // cost of the scene without the feature, if it occurs
        std::optional<double> addedMs;  // difference of the medians, if the feature occurs and takes time
    };
    FrameCost frame;
    std::vector<Row> rows;  // in the order of allSceneFeatures(), then one for a picture of the sky
};
// Measures the costs. The scene's animation plays: each frame shows another moment.
SceneCosts sceneCosts(const Scene& scene, const FrameOptions& options, const gl::Capabilities& capabilities,
                      const gl::ReadShader& readShader);

// Returns Markdown tables: the frame pass by pass, and what each feature adds to it.
std::string sceneCostsText(const SceneCosts& costs, bool timed);

}  // namespace vct
