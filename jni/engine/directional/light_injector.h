// Injects light: writes the radiance that each face emits and reflects into the base level of the directional
// voxels.
#pragma once

#include <optional>

#include "engine/directional/directional_voxels.h"
#include "engine/passes/punctual_lights.h"
#include "engine/programs.h"

namespace vct {

class Irradiance;

gl::ProgramDescription chooseRangeProgram();
// `bounces`: faces also reflect their irradiance.
gl::ProgramDescription injectProgram(const LightFeatures& sources, bool bounces);

class LightInjector {
  public:
    LightInjector(gl::ShaderLibrary shaders, const LightFeatures& sources);

    // `irradiance`: after its beginStep(), or null if faces reflect direct light only. `frameIndex` seeds
    // the dither. Afterwards shaders can fetch the base level as a texture. The range of its 8 bits follows
    // from the radiance in the last run; the first run injects twice, to measure it.
    void run(const DirectionalVoxels& voxels, const DirectLight& light, const Irradiance* irradiance,
             std::uint32_t frameIndex);

  private:
    void inject(const DirectionalVoxels& voxels, const DirectLight& light, const Irradiance* irradiance,
                std::uint32_t frameIndex);

    gl::ShaderLibrary shaders_;
    LightFeatures sources_;
    gl::Program chooseRange_;
    bool isMeasured_ = false;
    bool isComplete_ = true;                       // the last injection was into all faces
    std::optional<gl::Program> direct_, bounces_;  // compiled on first use
};

}  // namespace vct
