// A program that embeds the library: include/vct/vct.h keeps its promises.
#include <gtest/gtest.h>

#include "api/described_scene.h"
#include "cli/program_run.h"
#include "engine/renderer.h"
#include "gl/render_pass.h"
#include "image/compare.h"
#include "image/image.h"
#include "support/errors.h"
#include "support/pictures.h"

namespace vct::test {
namespace {

double mean(const Image& image) {
    double sum = 0.0;
    for (const glm::vec3& pixel : image.pixels)
        sum += double{pixel.r} + pixel.g + pixel.b;
    return sum / (3.0 * static_cast<double>(image.pixels.size()));
}

class EmbeddedPresets : public Embedded, public ::testing::WithParamInterface<const char*> {};

TEST_P(EmbeddedPresets, PictureIsThatOfTheProgram) {
    ProgramRun program;
    writeBytes(program.folder.file("scene.glb"), described_.file.glb());
    const bool isGlossy = GetParam() != std::string("thesis");
    program.expectSuccess("render scene.glb --out . --grid 64 --size 96x72 --samples 1 --preset " +
                          std::string(GetParam()) + (isGlossy ? " --light-parts" : "") +
                          " --camera eye=1.5,1.2,2.5,target=0,0.4,0,fov=50 --sky 0.1,0.2,0.3"
                          " --light direction=-0.4,-1,-0.5,intensity=3");
    Options options = optionsOf(GetParam());
    options.specular = isGlossy;
    described_.scene.bounds.reset();  // as the program finds them
    GlobalIllumination light(getProcAddress, described_.scene, options);
    const Pictures pictures = light.render(described_.view(), GlobalIllumination::Light::converged);
    const auto expectAsProgram = [&](unsigned picture, const std::string& file) {
        // The product of the camera's two matrices differs in its last bits from the program's matrix.
        const Difference difference = compareImages(imageOf(picture, light.radianceUnit()),
                                                    readImage(program.folder.file(file)), 0.002F);
        EXPECT_TRUE(difference.comparable) << file << ": " << difference.reason;
        EXPECT_LE(difference.fraction, 0.002) << file << ": largest difference " << difference.largest;
    };
    expectAsProgram(pictures.radiance, "gi-cone-shadow.exr");
    if (isGlossy) expectAsProgram(pictures.specular, "specular_light.exr");
    for (const unsigned part : {pictures.irradiance, pictures.ambientVisibility, pictures.sunVisibility}) {
        EXPECT_GT(mean(imageOf(part)), 0.005);
        EXPECT_LT(mean(imageOf(part)), 0.995);
    }
}

INSTANTIATE_TEST_SUITE_P(, EmbeddedPresets, ::testing::Values("thesis", "mobile"),
                         [](const auto& preset) { return std::string(preset.param); });

// The wall is the only glossy surface.
TEST_F(Embedded, ReflectionsAloneAreThoseOfTheWall) {
    Options options = optionsOf("mobile");
    options.radiance = options.irradiance = options.ambientVisibility = options.sunVisibility = false;
    options.specular = true;
    GlobalIllumination light(getProcAddress, described_.scene, options);
    const Pictures pictures = afterBounces(light);
    EXPECT_EQ(pictures.radiance, 0U);
    const Image picture = imageOf(pictures.specular, light.radianceUnit());
    EXPECT_EQ(picture.at(width / 2, height - 4), glm::vec3(0.0F)) << "the floor";
    EXPECT_GT(mean(picture), 0.003);
}

TEST_F(Embedded, GBufferOfTheCallerGivesTheSamePicture) {
    GlobalIllumination light(getProcAddress, described_.scene, optionsOf("mobile"));
    const View view = described_.view();
    const Image expected = imageOf(light.render(view, GlobalIllumination::Light::converged).radiance);

    const gl::Capabilities capabilities = gl::queryCapabilities();
    Settings settings = presetSettings("mobile");
    settings.size = {width, height};
    DirectionalLight sun;
    sun.intensity = 3;
    Renderer drawn(described_.loaded, sun, settings, capabilities, testShaders());
    drawn.render({{Output::phong}, described_.camera});
    const GBuffer::Targets targets = drawn.surface();
    GBufferTextures textures{targets.albedo->name(), targets.normal->name(), targets.depth->name(),
                             targets.emissive->name(), targets.gloss->name()};
    // Filters that would make a texture of integers unreadable do not matter.
    targets.normal->setFilter(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    EXPECT_EQ(imageOf(light.render(view, textures).radiance).pixels, expected.pixels);

    std::swap(textures.albedo, textures.normal);
    expectMentions(errorOf([&] { light.render(view, textures); }), {"albedo has the internal format"});
    light.resize(40, 30);
    expectMentions(errorOf([&] { light.render(view, textures); }), {"call resize()"});
    EXPECT_GT(mean(imageOf(light.render(view).radiance, 1.0, 40, 30)), 0.05);
}

// Reversed depth of a G-buffer, from the usual one. FROM_PROJECTION: columns 2 and 3 of the projection in row
// 2.
constexpr const char* reversedDepthShader = R"(
layout(binding = 0) uniform highp sampler2D usualDepth;
void main() {
    float depth = texelFetch(usualDepth, ivec2(gl_FragCoord.xy), 0).r;
    float distance = FROM_PROJECTION.y / (2.0 * depth - 1.0 + FROM_PROJECTION.x);
    gl_FragDepth = depth == 1.0 ? 0.0 : NEAR / distance;
}
)";

TEST_F(Embedded, ReversedDepthGivesTheSamePicture) {
    GlobalIllumination light(getProcAddress, described_.scene, optionsOf("mobile"));
    const View view = described_.view();
    const Image expected = imageOf(light.render(view, GlobalIllumination::Light::converged).radiance);
    // Depth from 1 at the near plane to 0 at infinity.
    constexpr double near = 0.05;
    View reversed = view;
    reversed.reversedDepth = true;
    for (std::size_t column = 0; column < 4; ++column)
        reversed.clipFromCamera.columns[4 * column + 2] = column == 3 ? near : 0.0;
    const auto expectSame = [&](const Image& picture, const char* what) {
        const Difference difference = compareImages(picture, expected, 0.04F);
        EXPECT_TRUE(difference.comparable) << what;
        EXPECT_LE(difference.fraction, 0.01) << what << ": largest difference " << difference.largest;
    };
    expectSame(imageOf(light.render(reversed).radiance), "with the library's G-buffer");

    Settings settings = presetSettings("mobile");
    settings.size = {width, height};
    Renderer drawn(described_.loaded, DirectionalLight(), settings, gl::queryCapabilities(), testShaders());
    drawn.render({{Output::phong}, described_.camera});
    const GBuffer::Targets targets = drawn.surface();
    gl::ShaderLibrary shaders = drawn.shaders();
    const std::array<double, 16>& clip = view.clipFromCamera.columns;
    shaders.read = [&](const std::string& path) {
        return path == "reversed.frag" ? reversedDepthShader : testShaders()(path);
    };
    const gl::Program convert(
        shaders, {"reversed depth",
                  {"passes/full_screen.vert", "reversed.frag"},
                  {"FROM_PROJECTION vec2(" + std::to_string(clip[10]) + "," + std::to_string(clip[14]) + ")",
                   "NEAR " + std::to_string(near)}});
    const gl::Texture depth = gl::Texture::make2d("reversed", GL_DEPTH_COMPONENT32F, width, height);
    const gl::Framebuffer framebuffer("reversed", {}, &depth);
    const gl::VertexArray noVertices;
    {
        const gl::RenderPass pass(framebuffer);
        gl::DepthFunc(GL_ALWAYS);
        targets.depth->bind(0);
        convert.use();
        noVertices.bind();
        gl::DrawArrays(GL_TRIANGLES, 0, 3);
    }
    const GBufferTextures textures{targets.albedo->name(), targets.normal->name(), depth.name(),
                                   targets.emissive->name(), targets.gloss->name()};
    expectSame(imageOf(light.render(reversed, textures).radiance), "with a G-buffer of the caller's");
}

// The floor has a known base colour and normal, so vct.h gives its radiance.
TEST_F(Embedded, PartsMakeThePicture) {
    described_.camera = lookAt({0, 0.6, 1}, {0, 0, 1}, 40);
    GlobalIllumination light(getProcAddress, described_.scene, optionsOf("mobile"));
    const Pictures pictures = light.render(described_.view());
    const Image radiance = imageOf(pictures.radiance), irradiance = imageOf(pictures.irradiance),
                visibility = imageOf(pictures.sunVisibility);
    const float cosine = 1.0F / std::sqrt(0.4F * 0.4F + 1.0F + 0.5F * 0.5F);
    for (std::size_t i = 0; i < radiance.pixels.size(); ++i) {
        const glm::vec3 expected =
            glm::vec3(0.8F, 0.7F, 0.6F) * (cosine * visibility.pixels[i] + irradiance.pixels[i]);
        ASSERT_LT(glm::length(radiance.pixels[i] - expected), 0.01F * glm::length(expected)) << i;
    }
}

TEST_F(Embedded, AMovedInstanceIsSeenAtItsNewPlace) {
    SceneDescription& scene = described_.scene;
    scene.instances[1].moves = true;
    GlobalIllumination light(getProcAddress, scene, optionsOf("mobile"));
    const View view = described_.view();
    const Image before = imageOf(light.render(view).sunVisibility);
    Matrix moved = scene.instances[1].worldFromObject;
    moved.columns[12] -= 0.5;
    light.setTransform(1, moved);
    light.setSun({-0.4, 1, 0.5});
    const Image after = imageOf(light.render(view).sunVisibility);
    EXPECT_NE(before.pixels, after.pixels);

    scene.instances[1].worldFromObject = moved;
    scene.sun.directionToSun = {-0.4, 1, 0.5};
    GlobalIllumination fresh(getProcAddress, scene, optionsOf("mobile"));
    EXPECT_EQ(imageOf(fresh.render(view).sunVisibility).pixels, after.pixels);
}

}  // namespace
}  // namespace vct::test
