// Injects light: writes the radiance that each face emits and reflects.
#pragma once

#include "engine/directional/directional_voxels.h"
#include "engine/passes/punctual_lights.h"
#include "engine/programs.h"

namespace vct {

class Irradiance;

gl::ProgramDescription injectProgram(const LightFeatures& sources);

class LightInjector {
  public:
    LightInjector(const gl::ShaderLibrary& shaders, const LightFeatures& sources);

    // `irradiance`: after its beginStep().
    void run(const DirectionalVoxels& voxels, const DirectLight& light, const Irradiance& irradiance) const;

  private:
    gl::Program inject_;
};

}  // namespace vct
