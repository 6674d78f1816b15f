// Textures, alpha masks and vertex colours of the interface in include/vct/vct.h.
#include "api/described_scene.h"
#include "engine/material_texture.h"
#include "image/compare.h"
#include "support/errors.h"

namespace vct::test {
namespace {

constexpr int side = 16;

// Red stripes with holes in between them.
Texture stripes() {
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const bool hole = x % 4 < 2;
            const std::uint8_t red = static_cast<std::uint8_t>(255 - 8 * y);
            rgba.insert(rgba.end(), {red, 60, 30, static_cast<std::uint8_t>(hole ? 0 : 255)});
        }
    Texture texture;
    texture.name = "stripes";
    texture.width = texture.height = side;
    texture.rgba = rgba;
    return texture;
}

// The described scene and the same scene as the engine knows it: the box has holes, the emitter's emission
// and the wall's colour have a texture, and the floor has vertex colours.
class Textures : public Embedded {
  protected:
    Textures() {
        for (std::size_t i = 0; i < described_.positions.size() / 3; ++i) {
            const float* p = &described_.positions[3 * i];
            uv_.insert(uv_.end(), {0.5F + 0.5F * p[0] + 0.3F * p[2], 0.5F + 0.5F * p[1]});
            colors_.insert(colors_.end(), {p[0] > 0 ? 1.0F : 0.2F, 1, p[2] > 0 ? 1.0F : 0.5F, 1});
        }
        Scene& loaded = described_.loaded;
        loaded.textures = {stripes()};
        for (const std::size_t index : {std::size_t{1}, std::size_t{3}})
            loaded.materials[index].baseColorTexture = 0;
        loaded.materials[1].alphaMode = Material::AlphaMode::mask;
        loaded.materials[1].alphaCutoff = 0.4F;
        loaded.materials[0].vertexColors = true;
        for (std::size_t m = 1; m < 4; ++m)
            for (std::size_t i = 0; i < loaded.meshes[m].vertices.size(); ++i)
                loaded.meshes[m].vertices[i].uv =
                    loaded.meshes[m].vertices[i].emissiveUv = {uv_[2 * i], uv_[2 * i + 1]};
        for (std::size_t i = 0; i < colors_.size(); i += 4)
            loaded.meshes[0].extras.emplace_back().color = {colors_[i], colors_[i + 1], colors_[i + 2],
                                                            colors_[i + 3]};

        texture_ = materialTexture(stripes());
        SceneDescription& scene = described_.scene;
        scene.materials[1].baseColorTexture = scene.materials[3].baseColorTexture = texture_.name();
        scene.materials[1].alphaCutoff = 0.4F;
        for (std::size_t m = 1; m < 4; ++m)
            scene.meshes[m].textureCoordinates = uv_;
        scene.meshes[0].colors = colors_;
    }
    Image expected() {
        const gl::Capabilities capabilities = gl::queryCapabilities();
        Settings settings = unrefinedPreset("mobile");
        settings.size = {width, height};
        settings.skyRadiance = {0.1F, 0.2F, 0.3F};
        DirectionalLight sun;
        sun.directionToLight = glm::normalize(glm::dvec3(0.4, 1, 0.5));
        sun.intensity = 3;
        Renderer renderer(described_.loaded, sun, settings, capabilities, testShaders());
        Camera camera = described_.camera;
        renderer.render({{Output::giConeShadow}, camera, LightSteps::all});
        return renderer.radiance();
    }
    Image seen() {
        GlobalIllumination light(getProcAddress, described_.scene, optionsOf("mobile"));
        return imageOf(afterBounces(light).radiance, light.radianceUnit());
    }
    std::vector<float> uv_, colors_;
    gl::Texture texture_;
};

TEST_F(Textures, GiveThePictureOfTheEngine) {
    const Image expected = this->expected();
    const Difference difference = compareImages(seen(), expected, 0.02F);
    EXPECT_TRUE(difference.comparable) << difference.reason;
    EXPECT_LE(difference.fraction, 0.013) << "largest difference " << difference.largest;
    // Each of them shows.
    SceneDescription& scene = described_.scene;
    const auto expectOther = [&](const char* what) {
        EXPECT_GT(compareImages(seen(), expected, 0.02F).fraction, 0.02) << what;
    };
    scene.materials[1].alphaCutoff = 0;
    expectOther("holes");
    scene.materials[1].alphaCutoff = 0.4F;
    scene.meshes[0].colors = {};
    expectOther("vertex colours");
}

// The mean of the texture's texels. Its stripes are not the same on each side of the emitter, hence the wide
// bound; without the texture there would be 1.39 times as much light.
TEST_F(Textures, MultiplyEmission) {
    SceneDescription& scene = described_.scene;
    scene.sun.illuminance = 0;  // the emitter is the only light
    scene.skyRadiance = {};
    scene.materials[2].emissionTexture = texture_.name();
    const Image textured = seen();
    scene.materials[2].emissionTexture = 0;
    scene.materials[2].emission = {4 * 0.72F, 3 * 0.045F, 2 * 0.013F};
    const Image plain = seen();
    double sums[2] = {};
    for (std::size_t i = 0; i < plain.pixels.size(); ++i) {
        sums[0] += textured.pixels[i].r;
        sums[1] += plain.pixels[i].r;
    }
    EXPECT_NEAR(sums[0] / sums[1], 1.0, 0.25);
}

TEST_F(Textures, ErrorsNameTheMaterialOrTheMesh) {
    const auto expectError = [&](const char* part) {
        expectMentions(
            errorOf([&] { GlobalIllumination(getProcAddress, described_.scene, optionsOf("mobile")); }),
            {part});
    };
    SceneDescription& scene = described_.scene;
    scene.meshes[0].colors = std::span<const float>(colors_).first(8);
    expectError("mesh 0: it has 8 numbers of colours for 24 vertices; give four");
    scene.meshes[0].colors = {};
    scene.meshes[1].textureCoordinates = {};
    expectError("mesh 1: it has 0 numbers of texture coordinates for 24 vertices");
    scene.meshes[1].textureCoordinates = uv_;
    scene.materials[3].baseColorTexture = 12345;
    expectError("material 3: baseColorTexture is 12345");
    scene.materials[3].baseColorTexture = 0;
    scene.materials[0].alphaCutoff = 2;
    expectError("material 0: give an alpha cutoff");
}

}  // namespace
}  // namespace vct::test
