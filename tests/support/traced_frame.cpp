#include "support/traced_frame.h"

#include "engine/programs.h"
#include "lab/read_back.h"
#include "support/renderers.h"

namespace vct::test {

TracedFrame::TracedFrame(const Context& context, const Scene& scene, const DirectionalLight& light,
                         const Settings& settings, const Volume& volume, const Camera& camera)
    : shaders_(shaderLibrary(settings, context.capabilities, testShaders())),
      uniforms_(frameUniforms(camera, light, scene.boundsWorld, volume, settings)),
      scene_(scene, volume, radianceUnit(light), context.capabilities.uniformBufferOffsetAlignment,
             settings.voxelization),
      uniformBuffer_("frame uniforms", GL_UNIFORM_BUFFER, sizeof uniforms_, &uniforms_, GL_STATIC_DRAW),
      shadowMap_(shaders_, scene_, settings.shadowMapSize, shadowMapLevels(settings)),
      gBuffer_(shaders_, scene_, settings.size, extraTargets(scene_.features(), settings.specular)),
      pyramid_(shaders_, settings.grid, 0),
      shade_(shaders_, settings) {
    uniformBuffer_.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_FRAME);
    const gl::Texture& shadow = shadowMap_.draw(scene_);
    if (shadow.levels() > 1) shadowMap_.makeLevels();
    gBuffer_.draw(scene_);
    PackedVoxelizer(shaders_, scene_, settings.grid, settings.voxelization).run(scene_, shadow, pyramid_);
    PackedMipmapper(shaders_).run(pyramid_);
}

Words TracedFrame::level(int level) const {
    return readVoxels(pyramid_.texture(), level);
}

std::vector<Words> TracedFrame::levels() const {
    std::vector<Words> levels;
    for (int i = 0; i < pyramid_.levels(); ++i)
        levels.push_back(level(i));
    return levels;
}

std::vector<SurfacePixel> TracedFrame::pixels() const {
    return surfacePixels(shaders_, gBuffer_.targets(), uniforms_);
}

Image TracedFrame::view(int view) {
    uniformBuffer_.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_FRAME);
    return readImage(shade_.draw(view, gBuffer_.targets(), &shadowMap_.texture(), {&pyramid_.texture(), {}}));
}

}  // namespace vct::test
