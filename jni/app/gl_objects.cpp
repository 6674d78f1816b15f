#include "app/gl_objects.h"

#include <EGL/egl.h>

#include "app/log.h"
#include "core/memory.h"
#include "engine/programs.h"
#include "gl/debug.h"
#include "lab/program_list.h"

namespace vct::app {

namespace {

// Baked light that does not suit is left out, because the renderer computes its own.
void useBakedLight(Renderer& renderer, const Scene& scene, const DirectionalLight& light,
                   const Settings& settings, const std::vector<unsigned char>& baked) {
    try {
        renderer.useBakedLight(
            bakedLightOf(baked, lightKey(scene, light, settings), "the file beside " + scene.path));
        log("the light beside " + scene.path + " is used");
    } catch (const Error& error) {
        log(std::string("note: baked light is not used: ") + error.what());
    }
}

}  // namespace

GlObjects::GlObjects(const gl::ReadShader& shaders) : shaders_(shaders) {
    try {
        gl::load([](const char* name, const void*) { return eglGetProcAddress(name); }, nullptr);
    } catch (const Error& error) {
        missing_ = error.what();  // the panel can be drawn without these functions
    }
    capabilities_ = gl::queryCapabilities();
    capabilities_.texturesInMainMemory = true;  // a phone's GPU has no memory of its own
    // An old driver reports errors for queries of limits that it does not know. They are ignored here.
    for (int i = 0; i < 64 && gl::GetError() != GL_NO_ERROR; ++i) {
    }
    gl::installDebugCallback();
    log(LogLevel::detail, gl::describe(capabilities_));
    try {
        capabilities_.requireAll();
    } catch (const Error& error) {
        missing_ = error.what();
    }
    if (!missing_.empty()) log(LogLevel::error, missing_);
    hud_.emplace(gl::ShaderLibrary{shaders_, gl::Language::essl300});
    if (missing_.empty()) presenter_.emplace(gl::ShaderLibrary{shaders_, capabilities_.language()});
    gl::checkErrors("setting up the panel");
}

std::size_t GlObjects::linkNext(const SceneFeatures& features, const Settings& settings, Output mode) {
    return vct::linkNext(shaderLibrary(settings, capabilities_, shaders_, programs_), settings, mode,
                         features, capabilities_);
}

std::vector<int> GlObjects::possibleGrids(const Settings& settings) const {
    std::size_t bytes = availableMemory();
    if (renderer_)
        for (const Resource& resource : renderer_->resources())
            bytes += resource.bytes;
    return vct::possibleGrids(settings, capabilities_, bytes);
}

Renderer& GlObjects::rendererFor(const std::shared_ptr<const Scene>& scene, const DirectionalLight& light,
                                 const Settings& settings, const Choices& choices,
                                 const std::vector<unsigned char>& baked) {
    if (!renderer_ || scene != scene_ || choices.preset != preset_ ||
        settings.grid != renderer_->settings().grid || settings.cascades != renderer_->settings().cascades ||
        settings.skyRadiance != renderer_->settings().skyRadiance ||
        settings.environment != renderer_->settings().environment ||
        settings.background != renderer_->settings().background) {
        // The old renderer is freed first, because a phone may not have memory for the voxels of both.
        renderer_.reset();
        if (const std::string note = voxelizationNote(settings.voxels, capabilities_); !note.empty())
            log(note);
        renderer_.emplace(*scene, light, settings, capabilities_, shaders_, programs_);
        if (!baked.empty()) useBakedLight(*renderer_, *scene, light, settings, baked);
        scene_ = scene;
        preset_ = choices.preset;
    }
    if (settings.size != renderer_->settings().size) renderer_->resize(settings.size);
    renderer_->setLightDirection(light.directionToLight);
    renderer_->setShadowConeAngle(settings.shadowConeAngleDeg);
    for (std::size_t i = 0; i < scene->punctualLights.size(); ++i)
        renderer_->setLightOn(i, !choices.lightsOff.test(i));
    return *renderer_;
}

void GlObjects::dropRenderer() {
    renderer_.reset();
    if (presenter_) presenter_->dropTargets();
}

void GlObjects::dropCaches(Output mode) {
    if (!missing_.empty()) return;
    if (renderer_) renderer_->dropUnread(mode);
    programs_->removeUnused();
    gl::ReleaseShaderCompiler();
}

}  // namespace vct::app
