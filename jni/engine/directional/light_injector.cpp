#include "engine/directional/light_injector.h"

#include "engine/directional/irradiance.h"
#include "gl/debug.h"

namespace vct {

gl::ProgramDescription injectProgram(const LightFeatures& sources) {
    std::vector<std::string> defines = emissionDefines(sources.emission);
    if (sources.punctual) defines.emplace_back("VCT_PUNCTUAL_LIGHTS");
    if (sources.emitters > 0) defines.push_back("VCT_EMITTERS " + std::to_string(sources.emitters));
    return {"inject", {"directional/inject.comp"}, defines};
}

LightInjector::LightInjector(const gl::ShaderLibrary& shaders, const LightFeatures& sources)
    : inject_(shaders, injectProgram(sources)) {}

void LightInjector::run(const DirectionalVoxels& voxels, const DirectLight& light,
                        const Irradiance& irradiance) const {
    const gl::DebugGroup group("inject");
    irradiance.bind(voxels);
    inject_.use();
    light.bind();
    irradiance.dispatchOverVisited(voxels);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

}  // namespace vct
