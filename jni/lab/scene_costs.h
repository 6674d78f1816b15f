// What each feature of a scene costs: the frame of the scene beside that of the same scene without it, both
// rendered.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/renderer.h"
#include "gl/call_log.h"
#include "scene/scene_features.h"

namespace vct {

// Something that may occur in a scene, and how to remove it.
struct SceneFeature {
    const char* name;
    bool (*occurs)(const SceneFeatures& found);
    void (*remove)(Scene& scene);
    // Whether a frame that makes everything anew, as those that are timed do, takes longer for it.
    bool takesTime = true;
};
const std::vector<SceneFeature>& allSceneFeatures();

struct FrameCost {
    gl::CallSummary calls;  // of one frame, when every pass has been made
    std::vector<Resource> resources;

    int passes() const { return static_cast<int>(calls.passes.size()); }
    int programs() const { return static_cast<int>(calls.programs.size()); }
    std::size_t bytes() const;
};
// What a frame is rendered with.
struct FrameOptions {
    Settings settings;
    Output mode = Output::giConeShadow;
    Camera camera;
    DirectionalLight light;
    int timedFrames = 0;  // of each of two renderers in turn; 0: no times
};

struct SceneCosts {
    struct Row {
        std::string name;
        bool occurs = false;
        FrameCost without;              // where it occurs
        std::optional<double> addedMs;  // the difference of the medians, where it occurs and takes time
    };
    FrameCost frame;
    std::vector<Row> rows;  // of allSceneFeatures(), in that order, and of a picture of the sky
};
// Where the scene is animated it plays: each frame is of another moment.
SceneCosts sceneCosts(const Scene& scene, const FrameOptions& options, const gl::Capabilities& capabilities,
                      const gl::ReadShader& readShader);

// Markdown: the frame pass by pass, and what each feature adds to it.
std::string sceneCostsText(const SceneCosts& costs, bool timed);

}  // namespace vct
