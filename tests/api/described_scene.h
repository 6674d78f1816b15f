// A scene as an embedding program describes it, and the same scene as a file.
#pragma once

#include <EGL/egl.h>
#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <memory>

#include "image/image.h"
#include "platform/contexts.h"
#include "scene/camera.h"
#include "support/gltf_builder.h"
#include "support/renderers.h"
#include "support/scenes.h"
#include "vct/vct.h"

namespace vct::test {

// Size of the pictures.
constexpr int width = 96, height = 72;

// A camera as the library takes it.
inline View viewOf(const Camera& camera, const Bounds& boundsWorld) {
    const glm::dmat4 projection =
        clipFromWorld(camera, boundsWorld, double{width} / height) * camera.worldFromCamera;
    return {Matrix::of(glm::value_ptr(glm::inverse(camera.worldFromCamera))),
            Matrix::of(glm::value_ptr(projection))};
}

// A floor, a box on it, an emitter and a glossy wall.
struct Described {
    std::vector<float> positions, normals;
    std::vector<std::uint32_t> indices;
    SceneDescription scene;
    GltfBuilder file;
    Camera camera = lookAt({1.5, 1.2, 2.5}, {0, 0.4, 0}, 50);
    Scene loaded;

    Described() {
        Scene box = emptyScene();
        addBox(box, glm::dvec3(2.0));
        indices = box.meshes[0].indices;
        for (const Vertex& vertex : box.meshes[0].vertices)
            for (int i = 0; i < 3; ++i) {
                positions.push_back(vertex.position[i]);
                normals.push_back(vertex.normal[i]);
            }
        add({0.8F, 0.7F, 0.6F}, {0, 0, 0}, 1, {0, -0.1, 0}, {1.5, 0.1, 1.5});
        add({0.2F, 0.5F, 0.9F}, {0, 0, 0}, 1, {0.3, 0.4, 0}, {0.3, 0.4, 0.3});
        add({1, 1, 1}, {4, 3, 2}, 1, {-0.9, 0.1, 0.6}, {0.1, 0.1, 0.1});
        add({0.9F, 0.9F, 0.9F}, {0, 0, 0}, 0.4F, {0, 0.7, -1.2}, {1.2, 0.7, 0.1});
        scene.sun.directionToSun = {0.4, 1, 0.5};
        scene.sun.illuminance = 3;
        scene.skyRadiance = {0.1F, 0.2F, 0.3F};
        loaded = load(file);
        // Twice the scene's: voxels of 10 cm, so that light takes a quarter of the time.
        scene.bounds = Box{{-3, -2, -3}, {3, 2, 3}};
        loaded.boundsWorld = {{-3, -2, -3}, {3, 2, 3}};
    }

    void add(std::array<float, 3> color, std::array<float, 3> emission, float roughness, glm::dvec3 centre,
             glm::dvec3 halfSize) {
        const glm::dmat4 place = glm::scale(glm::translate(glm::dmat4(1.0), centre), halfSize);
        const std::size_t index = scene.materials.size();
        scene.materials.push_back({color, emission, 0.0F, roughness});
        scene.meshes.push_back({positions, normals, indices, index});
        scene.instances.push_back({index, Matrix::of(glm::value_ptr(place))});
        file.add("materials",
                 {{"pbrMetallicRoughness",
                   {{"baseColorFactor", {color[0], color[1], color[2], 1}},
                    {"metallicFactor", 0},
                    {"roughnessFactor", roughness}}},
                  {"emissiveFactor", {emission[0] / 4, emission[1] / 4, emission[2] / 4}},
                  {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}}}});
        file.node(
            {{"mesh", file.mesh({{"attributes",
                                  {{"POSITION", file.floats(positions)}, {"NORMAL", file.floats(normals)}}},
                                 {"indices", file.accessor(indices, uint32, "SCALAR")},
                                 {"material", index}})},
             {"matrix", scene.instances.back().worldFromObject.columns}});
    }

    View view() const { return viewOf(camera, loaded.boundsWorld); }
};

inline Options optionsOf(const std::string& preset) {
    Options options;
    options.preset = preset;
    options.grid = 64;
    options.width = width;
    options.height = height;
    options.irradiance = options.ambientVisibility = options.sunVisibility = true;
    return options;
}

// A picture of the library, multiplied by `scale`.
inline Image imageOf(unsigned texture, double scale = 1.0, int w = width, int h = height) {
    GLuint framebuffer = gl::generate(gl::GenFramebuffers);
    gl::BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl::FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    std::vector<glm::vec4> texels(static_cast<std::size_t>(w * h));
    gl::ReadPixels(0, 0, w, h, GL_RGBA, GL_FLOAT, texels.data());
    gl::DeleteFramebuffers(1, &framebuffer);
    Image image(w, h);
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
            image.at(x, y) =
                static_cast<float>(scale) * glm::vec3(texels[static_cast<std::size_t>((h - 1 - y) * w + x)]);
    return image;
}

inline void* getProcAddress(const char* name) {
    return reinterpret_cast<void*>(eglGetProcAddress(name));
}

class Embedded : public ::testing::Test {
  protected:
    // The view after the frames in which all rays are traced and bounces converge. The refinement that
    // follows takes ten times as long, and changes little.
    Pictures afterBounces(GlobalIllumination& light) const {
        for (int frame = 1; frame < 20; ++frame)
            light.render(described_.view(), GlobalIllumination::Light::oneStep);
        return light.render(described_.view(), GlobalIllumination::Light::oneStep);
    }
    std::unique_ptr<Platform> context_ = createContext(Backend::egl, false);
    Described described_;
};

}  // namespace vct::test
