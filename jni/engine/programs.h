// Defines and descriptions that the programs of several passes share. Each pass describes its own in its
// header.
#pragma once

#include "engine/settings.h"
#include "engine/voxelization.h"
#include "gl/capabilities.h"
#include "gl/program.h"
#include "scene/scene_features.h"

namespace vct {

// The source of all shaders of one renderer, with the defines that counting and the driver's arithmetic ask
// of all of them.
gl::ShaderLibrary shaderLibrary(const Settings& settings, const gl::Capabilities& capabilities,
                                gl::ReadShader read);

// Material features that passes over the voxels read: not those that only pixels show.
constexpr unsigned voxelFeatures = ~(unsigned{featureGlossTexture} | unsigned{featureNormalMap});
// Material features that decide where a surface has holes.
constexpr unsigned holeFeatures =
    unsigned{featureBaseColorTexture} | unsigned{featureAlphaMask} | unsigned{featureVertexColors};
// The defines of shared/material.glsl, behind other defines: those of a material's `features` that the pass
// has in `used`, so that features that it does not read do not fork it.
std::vector<std::string> featureDefines(unsigned features, unsigned used,
                                        std::vector<std::string> defines = {});
// "NAME true" or "NAME false".
std::string booleanDefine(const char* name, bool value);

// The constants of directional/cones.glsl.
std::vector<std::string> gatherDefines(const GatherSettings& settings);
// Light of a scene besides the sun and a sky that is the same in all directions.
struct LightFeatures {
    bool punctual = false;     // punctual lights (passes/punctual_lights.h)
    bool environment = false;  // a picture of the sky (environment.h)
    bool emitters = false;     // compact emitters (emitters.h)
    bool emission = false;     // surfaces that emit light
};
// The defines of shaders that gather light.
std::vector<std::string> lightDefines(const LightFeatures& sources);
// The define of shaders that read the words of directional voxels' faces.
std::vector<std::string> emissionDefines(bool emission);
// A number as ESSL writes it, so that it comes back as it was.
std::string number(float value);

// A program over the triangles along their dominant axis. `name`: also the fragment shader's.
gl::ProgramDescription voxelizing(const std::string& name, std::vector<std::string> defines,
                                  Voxelization voxelization);

}  // namespace vct
