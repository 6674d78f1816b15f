// What the programs of several passes have in common. Each pass describes its own in its header.
#pragma once

#include "engine/settings.h"
#include "engine/voxelization.h"
#include "gl/capabilities.h"
#include "gl/program.h"
#include "scene/scene_features.h"

namespace vct {

// Where the passes of one renderer take their shaders from, with the defines that counting and the driver's
// arithmetic ask of all of them.
gl::ShaderLibrary shaderLibrary(const Settings& settings, const gl::Capabilities& capabilities,
                                gl::ReadShader read);

// What a material has of the features that a pass reads, `used`, as shared/material.glsl wants it, behind
// other defines. A pass that does not read a feature is not forked by it.
// What passes over the voxels read of a material: not what only a picture's pixels show.
constexpr unsigned voxelFeatures = ~(unsigned{featureGlossTexture} | unsigned{featureNormalMap});
// What decides where a surface has holes.
constexpr unsigned holeFeatures =
    unsigned{featureBaseColorTexture} | unsigned{featureAlphaMask} | unsigned{featureVertexColors};
std::vector<std::string> featureDefines(unsigned features, unsigned used,
                                        std::vector<std::string> defines = {});

// The constants of directional/cones.glsl.
std::vector<std::string> gatherDefines(const GatherSettings& settings);
// What shines besides the sun and a sky that is the same in all directions.
struct LightSources {
    bool punctual = false;     // other lights of the file (passes/punctual_lights.h)
    bool environment = false;  // a picture of the sky (environment.h)
    bool emitters = false;     // lamps (emitters.h)
};
// What shaders of the received light are told of them.
std::vector<std::string> sourceDefines(const LightSources& sources);
// A number as ESSL writes it, so that it comes back as it was.
std::string number(float value);

// A program over the triangles along their dominant axis. `name`: also the fragment shader's.
gl::ProgramDescription voxelizing(const std::string& name, std::vector<std::string> defines,
                                  Voxelization voxelization);

}  // namespace vct
