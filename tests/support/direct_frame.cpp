#include "support/direct_frame.h"

#include <algorithm>

#include "engine/programs.h"
#include "lab/read_back.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {

namespace {

// The received light is no matter here, and takes longest.
gl::ReadShader withoutReceivedLight(const gl::ReadShader& readShader) {
    return [read = readShader](const std::string& name) -> std::string {
        if (name != "directional/irradiance.glsl") return read(name);
        return "mediump vec3 receivedAt(vec3 position, vec3 normal) { return vec3(0.0); }\n"
               "mediump float ambientVisibilityAt(vec3 position, vec3 normal) { return 1.0; }\n";
    };
}

}  // namespace

DirectFrame::DirectFrame(const Context& context, Scene scene, const Settings& settings, const Camera& camera,
                         const gl::ReadShader& readShader)
    : shaders_(shaderLibrary(settings, context.capabilities, withoutReceivedLight(readShader))),
      plain_(std::move(scene)),
      settings_(settings),
      camera_(camera),
      volume_(volumeAround(plain_.boundsWorld, settings.grid)),
      scene_(plain_, volume_, radianceUnit(lightFrom({0, 1, 0})),
             context.capabilities.uniformBufferOffsetAlignment, settings.voxelization),
      uniformBuffer_("frame uniforms", GL_UNIFORM_BUFFER, sizeof(shared::FrameUniforms), nullptr,
                     GL_DYNAMIC_DRAW),
      shadowMap_(shaders_, scene_, settings.shadowMapSize, shadowMapLevels(settings)),
      gBuffer_(shaders_, scene_, settings.size, extraTargets(scene_.features(), settings.specular)),
      shade_(shaders_, settings),
      light_(lightFrom({0, 1, 0})) {
    upload();
    gBuffer_.draw(scene_);
    pixels_ = surfacePixels(shaders_, gBuffer_.targets(),
                            frameUniforms(camera_, light_, plain_.boundsWorld, volume_, settings_));
    const glm::dmat4 worldFromVolume = glm::inverse(volume_.volumeFromWorld());
    for (SurfacePixel& pixel : pixels_)
        if (pixel.surface)
            pixel.positionVolume = glm::dvec3(worldFromVolume * glm::dvec4(pixel.positionVolume, 1.0));
}

void DirectFrame::upload() {
    const shared::FrameUniforms uniforms =
        frameUniforms(camera_, light_, plain_.boundsWorld, volume_, settings_);
    shadowFromVolume_ = glm::dmat4(uniforms.shadowFromVolume);
    uniformBuffer_.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_FRAME);
    gl::BufferSubData(GL_UNIFORM_BUFFER, 0, sizeof uniforms, &uniforms);
}

void DirectFrame::setLight(const glm::dvec3& towardsLight) {
    light_ = lightFrom(towardsLight);
    upload();
    shadowMap_.draw(scene_);
    if (shadowMap_.texture().levels() > 1) shadowMap_.makeLevels();
}

Image DirectFrame::view(int view) {
    uniformBuffer_.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_FRAME);
    return readImage(shade_.draw(view, gBuffer_.targets(), &shadowMap_.texture(), {}));
}

std::vector<float> DirectFrame::hardShadow() {
    const Image image = view(VCT_MODE_GI);
    std::vector<float> light(image.pixels.size());
    for (std::size_t i = 0; i < light.size(); ++i) {
        if (!pixels_[i].surface) continue;
        const double cosine = glm::dot(pixels_[i].normal, light_.towardsLight) * pixels_[i].albedo.x;
        light[i] = cosine > 1e-3 ? static_cast<float>(image.pixels[i].x / cosine) : 0.0F;
    }
    return light;
}

std::vector<float> DirectFrame::softShadow() {
    const Image image = view(VCT_VIEW_CONE_SHADOW);
    std::vector<float> light(image.pixels.size());
    for (std::size_t i = 0; i < light.size(); ++i)
        light[i] = image.pixels[i].x;
    return light;
}

}  // namespace vct::test
