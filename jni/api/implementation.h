// The state of a GlobalIllumination.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "engine/renderer.h"
#include "vct/vct.h"

namespace vct {

// The window system's function that returns the current context.
using CurrentContext = void* (*)();

struct GlobalIllumination::Implementation {
    Implementation(GetProcAddress getProcAddress, const SceneDescription& description,
                   const Options& options);
    ~Implementation();

    // True if the context is current that the objects of GL belong to, as far as the window system can be
    // asked.
    bool isContextCurrent() const;
    void requireContext(const std::string& function) const;
    unsigned textureOf(Output output) const;

    // Throw vct::Error if there is no such instance, or if it does not move. The second returns its node.
    void requireInstance(std::size_t instance, const char* function) const;
    int nodeOf(std::size_t instance, const char* function) const;
    void requireMesh(std::size_t mesh, const std::string& where) const;
    void requireMaterial(std::size_t material, const std::string& where) const;
    void requireLight(std::size_t number, const char* function) const;

    void setAppearance(int node, bool isVisible, float emission);
    Pictures render(const View& view, Light light, const GBuffer::Targets* surface);

    // The features of programs for a material on a mesh. Throws vct::Error that begins with `name` if the
    // scene has no shaders for it.
    unsigned featuresFor(const Material& material, bool hasColors, const std::string& name) const;
    // The material, with places for its textures; those of `replaced` are free.
    Material withTextures(const MaterialDescription& description, const std::string& name,
                          std::size_t replaced);

    CurrentContext currentContext = nullptr;  // null if the window system cannot be asked
    void* context = nullptr;
    std::vector<Output> outputs;
    struct MeshState {
        std::size_t material = 0, vertices = 0;
        bool exists = true, isAdded = false, hasColors = false, hasTextureCoordinates = false;
        bool deforms = false;
        int node = -1;  // that deforms it
    };
    struct InstanceState {
        std::size_t mesh = 0;
        int node = -1;  // -1: it does not move
        bool exists = true, isAdded = false;
    };
    std::vector<std::optional<Material>> materials;
    std::size_t describedMaterials = 0;
    std::vector<Texture> textures;  // those of the materials; Texture::external is 0 if a place is free
    std::vector<MeshState> meshes;
    std::vector<InstanceState> instances;
    std::size_t describedInstances = 0, maxInstances = 0;
    Pose pose;
    struct Appearance {
        bool isVisible = true;
        float emission = 1.0F;
    };
    std::vector<Appearance> appearances;  // by node
    std::vector<bool> hasLight;           // by number; false: there is room for one
    LightKey lightKey;                    // of the description
    std::optional<Renderer> renderer;
    std::optional<gl::PlainSampler> plain;  // reads the caller's G-buffer
    std::function<void(const Progress& progress)> onProgress;
    bool measures = false;
    std::vector<StepTime> stepTimes;
};

// The implementation of an object for a call of a function, which must be possible.
template <class Implementation>
Implementation& ready(const std::unique_ptr<Implementation>& implementation, const char* function) {
    if (implementation == nullptr)
        throw Error(std::string(function) +
                    ": this GlobalIllumination was moved from; call the one that it was moved to");
    implementation->requireContext(function);
    return *implementation;
}

}  // namespace vct
