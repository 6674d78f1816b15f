// Renderers and settings for tests.
#pragma once

#include <string>

#include "engine/renderer.h"
#include "gl/shader_source.h"
#include "platform/platform.h"
#include "scene/gltf.h"

namespace vct::test {

inline std::string asset(const std::string& name) {
    return std::string(VCT_SOURCE_DIR "/assets/") + name;
}

inline gl::ReadShader testShaders() {
    return gl::shadersFromFolder(VCT_SOURCE_DIR "/shaders");
}

inline Renderer makeRenderer(const Context& context, const Scene& scene, const DirectionalLight& light,
                             const Settings& settings, std::shared_ptr<gl::ProgramCache> programs = {}) {
    return Renderer(scene, light, settings, context.capabilities, testShaders(), std::move(programs));
}

// The size of one resource, or of all.
inline std::size_t bytesOf(const Resources& resources, const std::string& name = "") {
    std::size_t sum = 0;
    for (const Resource& resource : resources)
        if (name.empty() || resource.name == name) sum += resource.bytes;
    return sum;
}

inline Settings smallSettings(int grid = 64, int pixels = 64) {
    Settings settings;
    settings.grid = grid;
    settings.size = glm::ivec2(pixels);
    settings.shadowMapSize = 256;
    return settings;
}

// A preset without the refinement of its light, which takes ten times as long as the bounces.
inline Settings unrefinedPreset(const std::string& preset) {
    Settings settings = presetSettings(preset);
    settings.gather.refinedDirections = 0;
    return settings;
}

// The preset mobile at its own grid.
inline Settings mobileAt(int pixels) {
    Settings settings = unrefinedPreset("mobile");
    settings.size = glm::ivec2(pixels);
    settings.shadowMapSize = 256;
    return settings;
}

}  // namespace vct::test
