#include "engine/directional/light_injector.h"

#include <utility>

#include "engine/directional/irradiance.h"
#include "gl/debug.h"

namespace vct {

gl::ProgramDescription chooseRangeProgram() {
    return {"choose_range", {"directional/choose_range.comp"}, {}};
}

gl::ProgramDescription injectProgram(const LightFeatures& sources, bool bounces) {
    std::vector<std::string> defines = emissionDefines(sources.emission);
    if (sources.punctual) defines.emplace_back("VCT_PUNCTUAL_LIGHTS");
    if (!bounces) return {"inject, direct light", {"directional/inject.comp"}, defines};
    defines.emplace_back("VCT_BOUNCES");
    if (sources.emitters) defines.emplace_back("VCT_EMITTERS");
    return {"inject", {"directional/inject.comp"}, defines};
}

LightInjector::LightInjector(gl::ShaderLibrary shaders, const LightFeatures& sources)
    : shaders_(std::move(shaders)), sources_(sources), chooseRange_(shaders_, chooseRangeProgram()) {}

void LightInjector::run(const DirectionalVoxels& voxels, const DirectLight& light,
                        const Irradiance* irradiance, std::uint32_t frameIndex) {
    if (!std::exchange(isMeasured_, true)) inject(voxels, light, nullptr, frameIndex);
    inject(voxels, light, irradiance, frameIndex);
}

void LightInjector::inject(const DirectionalVoxels& voxels, const DirectLight& light,
                           const Irradiance* irradiance, std::uint32_t frameIndex) {
    const gl::DebugGroup group("inject");
    // The last frame read the faces and the range, which are written here.
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    voxels.bindLists();
    voxels.range().bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_FACE_RANGE);
    chooseRange_.use();
    gl::Uniform1ui(VCT_UNIFORM_COMPLETE, isComplete_ ? 1U : 0U);
    isComplete_ = irradiance == nullptr || voxels.cascades() == 1 || irradiance->injectsAll();
    gl::DispatchCompute(1, 1, 1);
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_UNIFORM_BARRIER_BIT);
    std::optional<gl::Program>& program = irradiance != nullptr ? bounces_ : direct_;
    if (!program) program.emplace(shaders_, injectProgram(sources_, irradiance != nullptr));
    program->use();
    gl::Uniform1ui(VCT_UNIFORM_FRAME_INDEX, frameIndex);
    voxels.bindLists();
    if (irradiance != nullptr) irradiance->bind(voxels);
    voxels.staticIndex().bind(VCT_TEX_VOXELS);
    voxels.dynamicIndex().bind(VCT_TEX_DYNAMIC_VOXELS);
    light.bind();
    voxels.bindLevel(VCT_IMAGE_FACES, 0);
    if (irradiance != nullptr)
        irradiance->dispatchOverFaces(voxels, irradiance->visitsAll());
    else
        voxels.index().dispatchOverFaces(0);
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

}  // namespace vct
