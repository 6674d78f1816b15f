#include "support/gather.h"

#include "render/programs.h"
#include "render/read_back.h"
#include "support/renderers.h"

namespace vct::test {

namespace {

// ES cannot read a depth texture; the depth view writes it into a colour target.
std::vector<float> readDepth(const gl::ShaderLibrary& shaders, const gl::Texture& depth) {
    depth.bind(VCT_TEX_G_DEPTH);
    const gl::Program program(shaders, stageViewProgram(VCT_STAGE_DEPTH));
    const gl::Texture color = gl::Texture::make2d("depth", GL_RGBA32F, depth.width(), depth.height());
    const gl::Framebuffer framebuffer("depth", {&color}, nullptr);
    const gl::VertexArray noVertices;
    framebuffer.bind();
    gl::Disable(GL_DEPTH_TEST);
    program.use();
    noVertices.bind();
    gl::DrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<float> result;
    for (const glm::vec3& pixel : readImage(color).pixels)
        result.push_back(pixel.x);
    return result;
}

}  // namespace

GatherResult gatherOver(const Context& context, const Scene& scene, const DirectionalLight& light,
                        const Settings& settings, const Camera& camera, int view,
                        const std::function<void(Words& base)>& editBase) {
    const gl::ShaderLibrary shaders{testShaders(), context.capabilities.essl320};
    const Volume volume = volumeAround(scene.boundsWorld, settings.grid);
    const GpuScene gpuScene(scene, volume, radianceUnit(light),
                            context.capabilities.uniformBufferOffsetAlignment);
    const shared::FrameUniforms uniforms = frameUniforms(camera, light, scene.boundsWorld, volume, settings);
    const gl::Buffer buffer("frame uniforms", GL_UNIFORM_BUFFER, sizeof uniforms, &uniforms, GL_STATIC_DRAW);
    buffer.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_FRAME);

    ShadowMap shadowMap(shaders, gpuScene, settings.shadowMapSize);
    GBuffer gBuffer(shaders, gpuScene, settings.size);
    VoxelPyramid pyramid(shaders, settings.grid, 0);
    Voxelizer voxelizer(shaders, gpuScene, settings.grid);
    ConeTracer coneTracer(shaders, settings.size);
    const gl::Texture& shadow = shadowMap.draw(gpuScene);
    const GBuffer::Targets surface = gBuffer.draw(gpuScene);
    voxelizer.run(gpuScene, shadow, pyramid);

    Words base = readVoxels(pyramid.texture(), 0);
    editBase(base);
    writePyramid(pyramid.texture(), base);

    GatherResult result;
    result.image = readImage(coneTracer.draw(view, surface, &shadow, &pyramid.texture()));
    const std::vector<float> depth = readDepth(shaders, *surface.depth);
    const glm::dmat4 volumeFromClip = glm::inverse(glm::dmat4(uniforms.clipFromVolume));
    for (int y = 0; y < settings.size.y; ++y)
        for (int x = 0; x < settings.size.x; ++x) {
            const float z = depth[static_cast<std::size_t>(y) * settings.size.x + x];
            if (z == 1.0F) continue;
            const glm::dvec2 ndc((x + 0.5) / settings.size.x * 2.0 - 1.0,
                                 1.0 - (y + 0.5) / settings.size.y * 2.0);
            const glm::dvec4 p = volumeFromClip * glm::dvec4(ndc, z * 2.0 - 1.0, 1.0);
            result.positions.push_back(glm::dvec3(p) / p.w);
            result.values.push_back(result.image.at(x, y).x);
        }
    return result;
}

}  // namespace vct::test
