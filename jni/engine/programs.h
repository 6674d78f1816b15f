// Preprocessor defines and program descriptions that several passes share. Each pass describes its own
// programs in its header.
#pragma once

#include "engine/settings.h"
#include "engine/voxelization.h"
#include "gl/capabilities.h"
#include "gl/program.h"
#include "scene/scene_features.h"

namespace vct {

// The shader sources of a renderer, with the defines that all of its shaders share.
gl::ShaderLibrary shaderLibrary(const Settings& settings, const gl::Capabilities& capabilities,
                                gl::ReadShader read, std::shared_ptr<gl::ProgramCache> cache = {});

// Material features that voxelization reads. Gloss and normal maps are only read per pixel.
constexpr unsigned voxelFeatures = ~(unsigned{featureGlossTexture} | unsigned{featureNormalMap});
// Material features that determine the holes of alpha-masked surfaces.
constexpr unsigned holeFeatures =
    unsigned{featureBaseColorTexture} | unsigned{featureAlphaMask} | unsigned{featureVertexColors};
// Appends the defines of shared/material.glsl for those of a material's `features` that are in `used`, the
// features that the pass reads. Materials that differ in other features then share a program.
std::vector<std::string> featureDefines(unsigned features, unsigned used,
                                        std::vector<std::string> defines = {});
// Returns "NAME true" or "NAME false".
std::string booleanDefine(const char* name, bool value);

// The constants of directional/gather_directions.glsl.
std::vector<std::string> gatherDefines(const GatherSettings& settings);
// The kinds of light in a scene besides the sun and a sky of one colour.
struct LightFeatures {
    bool punctual = false;      // punctual lights (passes/punctual_lights.h)
    bool environment = false;   // a sky that depends on direction (environment.h)
    int emitters = 0;           // compact emitters (emitters.h): words per face for what it sees of them
    bool emission = false;      // surfaces that emit light and are no compact emitters, so voxels have it
    bool softPunctual = false;  // punctual lights have a size of their own (PunctualLight::size)
};
// The defines of shaders that gather light.
std::vector<std::string> lightDefines(const LightFeatures& sources);
// The define of shaders that read or write the sums of directional voxels' faces.
std::vector<std::string> emissionDefines(bool emission);
// Writes a number in ESSL with enough digits to give the same float again.
std::string number(float value);
// A program that draws triangles along their dominant axis. Its fragment shader is `name`.frag.
gl::ProgramDescription voxelizing(const std::string& name, std::vector<std::string> defines,
                                  Voxelization voxelization);

}  // namespace vct
