#include "lab/scene_costs.h"

#include <chrono>

#include "gl/api.h"
#include "lab/table.h"
#include "scene/camera.h"

namespace vct {

namespace {

void forEachMaterial(Scene& scene, void (*change)(Material& material)) {
    for (Material& material : scene.materials)
        change(material);
}

// A renderer of a scene, and the scene's time.
class Player {
  public:
    Player(Scene scene, const FrameOptions& options, const gl::Capabilities& capabilities,
           const gl::ReadShader& readShader)
        : scene_(std::move(scene)),
          options_(options),
          light_(options.light),
          renderer_(scene_, light_, options.settings, capabilities, readShader) {
        if (!featuresOf(scene_).movingLight) light_.node = -1;
    }

    void frame() {
        if (!scene_.animation.channels.empty()) {
            const Pose pose = poseAt(scene_.animation, 0.01 * frames_++);
            renderer_.setPose(pose);
            renderer_.setLightDirection(posed(light_, pose).directionToLight);
        }
        renderer_.render({{options_.mode}, options_.camera});
    }

    // The cost of the third frame: every pass is made in the first two.
    FrameCost cost() {
        for (int i = 0; i < 2; ++i)
            frame();
        const gl::CallLog log;
        frame();
        return {gl::summaryOf(log.calls()), renderer_.resources()};
    }

    double frameMs() {
        const auto start = std::chrono::steady_clock::now();
        frame();
        gl::Finish();
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    }

  private:
    Scene scene_;
    const FrameOptions& options_;
    DirectionalLight light_;
    Renderer renderer_;
    int frames_ = 0;
};

// The frames take turns: a machine that slows down meanwhile slows both.
double addedMs(Player& with, Player& without, int frames) {
    std::vector<double> withMs, withoutMs;
    for (int i = 0; i < frames; ++i) {
        withMs.push_back(with.frameMs());
        withoutMs.push_back(without.frameMs());
    }
    return median(withMs) - median(withoutMs);
}

std::vector<std::string> cellsOf(const SceneCosts& costs, const SceneCosts::Row& row, bool timed) {
    std::vector<std::string> cells{row.name, "does not occur", "", "", ""};
    if (row.occurs) {
        const FrameCost &with = costs.frame, &without = row.without;
        const double bytes = static_cast<double>(with.bytes()) - static_cast<double>(without.bytes());
        cells = {row.name, cellText("%+.0f", with.passes() - without.passes()),
                 cellText("%+.0f", with.programs() - without.programs()),
                 cellText("%+.0f", with.calls.calls - without.calls.calls), cellText("%+.1f", bytes / 1e3)};
    }
    if (timed) cells.push_back(row.addedMs ? cellText("%+.2f", *row.addedMs) : row.occurs ? "–" : "");
    return cells;
}

void keepForm(Scene& scene) {
    for (Instance& instance : scene.instances)
        instance.deforms = false;
    for (Mesh& mesh : scene.meshes)
        mesh.deformation = nullptr;
}

}  // namespace

const std::vector<SceneFeature>& allSceneFeatures() {
    static const std::vector<SceneFeature> features{
        {"base-colour textures", [](const SceneFeatures& f) { return f.has(featureBaseColorTexture); },
         [](Scene& scene) { forEachMaterial(scene, [](Material& m) { m.baseColorTexture = -1; }); }},
        {"alpha masks", [](const SceneFeatures& f) { return f.has(featureAlphaMask); },
         [](Scene& scene) {
             forEachMaterial(scene, [](Material& m) { m.alphaMode = Material::AlphaMode::opaque; });
         }},
        {"emission", [](const SceneFeatures& f) { return f.has(featureEmissive); },
         [](Scene& scene) { forEachMaterial(scene, [](Material& m) { m.emissive = glm::vec3(0.0F); }); }},
        {"emissive textures", [](const SceneFeatures& f) { return f.has(featureEmissiveTexture); },
         [](Scene& scene) { forEachMaterial(scene, [](Material& m) { m.emissiveTexture = -1; }); }},
        {"glossy materials", [](const SceneFeatures& f) { return f.glossy; },
         [](Scene& scene) {
             forEachMaterial(scene, [](Material& m) {
                 m.roughness = 1.0F;
                 m.glossTexture = -1;
             });
         }},
        {"metallic-roughness textures", [](const SceneFeatures& f) { return f.has(featureGlossTexture); },
         [](Scene& scene) { forEachMaterial(scene, [](Material& m) { m.glossTexture = -1; }); }},
        {"normal maps", [](const SceneFeatures& f) { return f.has(featureNormalMap); },
         [](Scene& scene) { forEachMaterial(scene, [](Material& m) { m.normalTexture = -1; }); }},
        {"vertex colours", [](const SceneFeatures& f) { return f.has(featureVertexColors); },
         [](Scene& scene) { forEachMaterial(scene, [](Material& m) { m.vertexColors = false; }); }},
        {"unlit materials", [](const SceneFeatures& f) { return f.has(featureUnlit); },
         [](Scene& scene) { forEachMaterial(scene, [](Material& m) { m.unlit = false; }); }},
        {"double-sided materials", [](const SceneFeatures& f) { return f.has(featureDoubleSided); },
         [](Scene& scene) { forEachMaterial(scene, [](Material& m) { m.doubleSided = false; }); }},
        {"several materials and their features", [](const SceneFeatures& f) { return f.materials > 1; },
         [](Scene& scene) { forEachMaterial(scene, [](Material& m) { m = Material(); }); }},
        {"skins and morph targets that play", [](const SceneFeatures& f) { return f.deforms; }, keepForm},
        {"moving objects", [](const SceneFeatures& f) { return f.movingObjects; },
         [](Scene& scene) {
             keepForm(scene);
             for (Instance& instance : scene.instances)
                 instance.node = -1;
         }},
        {"lights besides the sun", [](const SceneFeatures& f) { return f.has(featurePunctualLights); },
         [](Scene& scene) { scene.punctualLights.clear(); }},
        {"moving light", [](const SceneFeatures& f) { return f.movingLight; },
         [](Scene& scene) {
             for (DirectionalLight& light : scene.lights)
                 light.node = -1;
             for (PunctualLight& light : scene.punctualLights)
                 light.node = -1;
         },
         false},
    };
    return features;
}

std::size_t FrameCost::bytes() const {
    std::size_t sum = 0;
    for (const Resource& resource : resources)
        sum += resource.bytes;
    return sum;
}

SceneCosts sceneCosts(const Scene& scene, const FrameOptions& options, const gl::Capabilities& capabilities,
                      const gl::ReadShader& readShader) {
    Player with(scene, options, capabilities, readShader);
    SceneCosts costs{with.cost(), {}};
    const SceneFeatures found = featuresOf(scene);
    const auto measure = [&](SceneCosts::Row& row, Scene stripped, const FrameOptions& strippedOptions,
                             bool takesTime) {
        row.occurs = true;
        Player without(std::move(stripped), strippedOptions, capabilities, readShader);
        row.without = without.cost();
        if (takesTime && options.timedFrames > 0) row.addedMs = addedMs(with, without, options.timedFrames);
    };
    for (const SceneFeature& feature : allSceneFeatures()) {
        SceneCosts::Row& row = costs.rows.emplace_back();
        row.name = feature.name;
        if (!feature.occurs(found)) continue;
        Scene stripped = scene;
        feature.remove(stripped);
        measure(row, std::move(stripped), options, feature.takesTime);
    }
    // A sky that is the same in all directions is a number, and black costs as much.
    costs.rows.emplace_back().name = "picture of the sky";
    if (options.settings.environment) {
        FrameOptions plain = options;
        plain.settings.environment.reset();
        measure(costs.rows.back(), scene, plain, true);
    }
    return costs;
}

std::string sceneCostsText(const SceneCosts& costs, bool timed) {
    const FrameCost& frame = costs.frame;
    TableRows passes{{"pass", "GL calls"}};
    for (const auto& [group, calls] : frame.calls.byGroup)
        passes.push_back({group.empty() ? "between them" : group, std::to_string(calls)});
    passes.push_back({"the frame", std::to_string(frame.calls.calls)});
    TableRows features{{"what occurs in it, and what that adds", "passes", "programs", "GL calls", "kB"}};
    if (timed) features[0].emplace_back("ms");
    for (const SceneCosts::Row& row : costs.rows)
        features.push_back(cellsOf(costs, row, timed));
    return markdownTable(passes) + "\nthe frame: " + std::to_string(frame.calls.draws) + " draws, " +
           std::to_string(frame.calls.dispatches) + " dispatches, " + std::to_string(frame.programs()) +
           " programs, " + cellText("%.1f kB", static_cast<double>(frame.bytes()) / 1e3) + "\n\n" +
           markdownTable(features);
}

}  // namespace vct
