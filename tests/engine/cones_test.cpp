// Cones through faces whose light is known: the example of docs/voxel-cone-tracing.md ("A cone in numbers"),
// the mean of the faces that a slanted cone meets, and a sample on the volume's border.
#include <gtest/gtest.h>

#include "engine/programs.h"
#include "support/faces.h"
#include "support/renderers.h"

namespace vct::test {
namespace {

constexpr int gridSide = 64;
constexpr const char* shader = R"(
#include "directional/cones.glsl"
layout(local_size_x = 1) in;
layout(std430, binding = VCT_SSBO_COMMANDS) buffer Found {
    vec4 found[3];
};
void main() {
    const vec3 up = vec3(1e-6, 1.0, 1e-6), slanted = vec3(0.48, 0.6, 0.64);
    ConeResult cone = traceCone(vec3(32.0, VCT_GATHER_START, 32.0), 0, up, vec3(0.0), up,
                                VCT_GATHER_FIRST_SAMPLE, 128.0, 1.0);
    found[0] = vec4(cone.radiance.g, cone.transmittance, cone.nearness, 0.0);
    found[1] = sampleFaces(vec3(0.5, 0.9, 0.5), slanted, slanted, 0, 0.0);
    // On the border of the volume, half of a texel is inside.
    Cone fading = coneFrom(vec3(32.0, 60.0, 32.0), 0, up, vec3(0.0), up, true);
    found[2] = sampleLevel(fading, 4.0, vec3(0.5, 1.0, 0.5), 0, 0.0);
}
)";

// Fills layers of voxels with faces of one direction. The faces are white.
void fill(const gl::Texture& faces, int level, int face, int firstY, int layers, double radiance,
          double coverage) {
    const int side = gridSide >> level;
    const glm::u8vec4 texel(glm::round(glm::dvec4(glm::dvec3(radiance * coverage), coverage) * 255.0));
    const std::vector<glm::u8vec4> texels(static_cast<std::size_t>(side * layers * side), texel);
    faces.bind(VCT_TEX_FACES);
    gl::TexSubImage3D(GL_TEXTURE_3D, level, face / 2 * side, face % 2 * side + firstY, 0, side, layers, side,
                      GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
}

TEST(Cones, GiveTheNumbersOfTheExampleAndOfSamples) {
    const Context context = openContext(Backend::egl);
    constexpr int levels = 7;
    const gl::Texture faces =
        gl::Texture::make3d("faces", GL_RGBA8, 3 * gridSide, 2 * gridSide, gridSide, levels);
    faces.setFilter(GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR);
    for (int level = 0; level < levels; ++level)
        for (int face = 0; face < faceCount; ++face)
            fill(faces, level, face, 0, gridSide >> level, 0.0, 0.0);
    constexpr int downwards = 3;
    for (const int level : {0, 1}) {
        fill(faces, level, downwards, 2 >> level, 1, 0.5, 0.4);  // the shelf
        fill(faces, level, downwards, 9 >> level, 1, 0.8, 1.0);  // the ceiling
    }
    // Faces against the slanted direction.
    const glm::dvec3 direction(0.48, 0.6, 0.64), radiance(0.8, 0.4, 0.2), coverage(0.2, 0.4, 0.8);
    for (int axis = 0; axis < 3; ++axis)
        fill(faces, 0, 2 * axis + 1, 48, 16, radiance[axis], coverage[axis]);

    shared::FrameUniforms frame{};
    frame.gridSide = gridSide;
    const shared::FaceRange range{1.0F, 1.0F, 0.0F, 0.0F};
    glm::vec4 found[3] = {};
    const gl::Buffer frameBlock("frame", GL_UNIFORM_BUFFER, sizeof frame, &frame, GL_STATIC_DRAW);
    const gl::Buffer rangeBlock("range", GL_UNIFORM_BUFFER, sizeof range, &range, GL_STATIC_DRAW);
    const gl::Buffer results("results", GL_SHADER_STORAGE_BUFFER, sizeof found, found, GL_DYNAMIC_COPY);
    frameBlock.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_FRAME);
    rangeBlock.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_FACE_RANGE);
    results.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_COMMANDS);
    const auto read = [](const std::string& path) {
        return path == "cones_test.comp" ? shader : testShaders()(path);
    };
    const gl::Program program({read, context.capabilities.language()},
                              {"cones", {"cones_test.comp"}, gatherDefines(presetSettings("mobile").gather)});
    program.use();
    gl::DispatchCompute(1, 1, 1);
    gl::MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    results.read(found, sizeof found);

    EXPECT_NEAR(found[0].x, 0.682, 0.004);  // radiance
    EXPECT_EQ(found[0].y, 0.0F);            // transmittance
    EXPECT_NEAR(found[0].z, 0.291, 0.002);  // nearness
    const glm::dvec3 squares = direction * direction * coverage;
    const double covered = glm::dot(direction, coverage);
    EXPECT_NEAR(found[1].a, covered, 0.003);
    EXPECT_NEAR(found[2].a, 0.5 * coverage.y, 0.003);
    EXPECT_NEAR(found[1].g, covered * glm::dot(squares, radiance) / glm::dot(squares, glm::dvec3(1.0)),
                0.003);
}

}  // namespace
}  // namespace vct::test
