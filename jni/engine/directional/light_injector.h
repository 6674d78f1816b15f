// Injects light into the base level of the directional voxels: each face gets the radiance that it emits and
// reflects.
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

    // `irradiance`: null where faces reflect direct light alone; else its step has begun. `frameIndex` seeds
    // the dither. Afterwards the base level is ready to be fetched as a texture. Its range is that of the
    // radiance of the last run; the first run measures direct light before it stores anything.
    void run(const DirectionalVoxels& voxels, const DirectLight& light, const Irradiance* irradiance,
             std::uint32_t frameIndex);

  private:
    void inject(const DirectionalVoxels& voxels, const DirectLight& light, const Irradiance* irradiance,
                std::uint32_t frameIndex);

    gl::ShaderLibrary shaders_;
    LightFeatures sources_;
    gl::Program chooseRange_;
    bool isMeasured_ = false;
    std::optional<gl::Program> direct_, bounces_;  // compiled when first asked for
};

}  // namespace vct
