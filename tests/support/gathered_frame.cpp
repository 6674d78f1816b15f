#include "support/gathered_frame.h"

#include "engine/programs.h"
#include "lab/read_back.h"
#include "support/renderers.h"

namespace vct::test {

namespace {

shared::FrameUniforms uniformsOf(const Scene& scene, const DirectionalLight& light, const Settings& settings,
                                 const Volume& volume, const Camera& camera) {
    shared::FrameUniforms uniforms = frameUniforms(camera, light, scene.boundsWorld, volume, settings);
    uniforms.faceSumUnits = faceSumUnits(scene.triangleCount());
    uniforms.radianceRange = faceRadianceRange(scene, light, settings.skyRadiance);
    uniforms.largestBounceShare = largestBounceShare(scene);
    return uniforms;
}

}  // namespace

GatheredFrame::GatheredFrame(const Context& context, const Scene& scene, const DirectionalLight& light,
                             const Settings& settings, const Volume& volume, const Camera& camera)
    : shaders_(shaderLibrary(settings, context.capabilities, testShaders())),
      uniforms_(uniformsOf(scene, light, settings, volume, camera)),
      scene_(scene, volume, radianceUnit(light), context.capabilities.uniformBufferOffsetAlignment,
             settings.voxelization),
      uniformBuffer_("frame uniforms", GL_UNIFORM_BUFFER, sizeof uniforms_, &uniforms_, GL_STATIC_DRAW),
      shadowMap_(shaders_, scene_, settings.shadowMapSize, shadowMapLevels(settings)),
      gBuffer_(shaders_, scene_, settings.size, extraTargets(scene_.features(), settings.specular)),
      voxels_(shaders_, volume.grid, settings.activeVoxelLimit),
      mipmapper_(shaders_),
      light_(shaders_, settings.gather, GatherOf::light, settings.lightFrames, false),
      occlusion_(shaders_, settings.occlusion, GatherOf::occlusion, settings.lightFrames, false),
      shade_(shaders_, settings) {
    uniformBuffer_.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_FRAME);
    const gl::Texture& shadow = shadowMap_.draw(scene_);
    if (shadow.levels() > 1) shadowMap_.makeLevels();
    gBuffer_.draw(scene_);
    DirectionalVoxelizer(shaders_, scene_, volume.grid, settings.voxelization).run(scene_, shadow, voxels_);
    mipmapper_.makeLevels(voxels_);
}

std::vector<SurfacePixel> GatheredFrame::pixels() const {
    return surfacePixels(shaders_, gBuffer_.targets(), uniforms_);
}

void GatheredFrame::step(int steps, bool allBounces) {
    uniformBuffer_.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_FRAME);
    for (int i = 0; i < steps; ++i)
        light_.step(voxels_, mipmapper_, allBounces);
}

void GatheredFrame::settle(bool allBounces) {
    while (!light_.settled())
        step(1, allBounces);
}

ReceivedFaces GatheredFrame::received() {
    if (light_.irradiance() == nullptr) settle(false);
    return readReceived(voxels_, light_.received());
}

Image GatheredFrame::view(int view) {
    uniformBuffer_.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_FRAME);
    const bool occlusion = view == VCT_VIEW_AO || view == VCT_MODE_AO;
    if (occlusion)
        while (!occlusion_.settled())
            occlusion_.step(voxels_, mipmapper_, true);
    else if (light_.irradiance() == nullptr)
        settle(view != VCT_VIEW_INDIRECT);
    const Irradiance& received = occlusion ? occlusion_ : light_;
    return readImage(shade_.draw(view, gBuffer_.targets(), &shadowMap_.texture(),
                                 {nullptr, received.irradiance(), received.bricks(), &voxels_.faces()}));
}

}  // namespace vct::test
