// Specular reflection, compared with closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "engine/renderer.h"
#include "scene/camera.h"
#include "support/frame_inspector.h"
#include "support/pictures.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

const glm::dvec3 copper(0.9, 0.6, 0.3);

Settings glossyAt(glm::ivec2 size) {
    Settings settings = mobileAt(1);
    settings.size = size;
    return settings;
}

Material metal(float roughness) {
    Material material;
    material.baseColor = glm::vec4(copper, 1.0);
    material.metallic = 1.0F;
    material.roughness = roughness;
    return material;
}

// glTF 2.0, appendix B.2 and B.3, for light of irradiance pi from one direction: a white Lambert surface has
// n.l. All vectors have unit length. `base`: the diffuse albedo.
glm::dvec3 gltfReflection(const glm::dvec3& base, const glm::dvec3& f0, double roughness, const glm::dvec3& n,
                          const glm::dvec3& l, const glm::dvec3& v) {
    const double alpha2 = std::pow(roughness, 4.0);
    const glm::dvec3 h = glm::normalize(l + v);
    const double nh = glm::dot(n, h), nl = glm::dot(n, l), nv = glm::dot(n, v);
    const double d = alpha2 / (pi * std::pow(nh * nh * (alpha2 - 1.0) + 1.0, 2.0));
    const double g = 2.0 * nl / (nl + std::sqrt(alpha2 + (1.0 - alpha2) * nl * nl)) * 2.0 * nv /
                     (nv + std::sqrt(alpha2 + (1.0 - alpha2) * nv * nv));
    const glm::dvec3 fresnel = f0 + (1.0 - f0) * std::pow(1.0 - glm::dot(v, h), 5.0);
    return ((1.0 - fresnel) * base + fresnel * (g * d / (4.0 * nl * nv) * pi)) * nl;
}

// The radiance under light of 1 from everywhere, seen at that cosine: the midpoint rule over the hemisphere,
// weighted by the cosine.
glm::dvec3 gltfAlbedo(const glm::dvec3& base, const glm::dvec3& f0, double roughness, double cosEye) {
    const glm::dvec3 n(0, 1, 0), v(std::sqrt(1.0 - cosEye * cosEye), cosEye, 0);
    constexpr int count = 300;
    glm::dvec3 sum(0.0);
    for (int i = 0; i < count; ++i)
        for (int j = 0; j < count; ++j) {
            const double height = std::sqrt((i + 0.5) / count), turn = 2.0 * pi * (j + 0.5) / count;
            const double side = std::sqrt(1.0 - height * height);
            const glm::dvec3 l(side * std::cos(turn), height, side * std::sin(turn));
            sum += gltfReflection(base, f0, roughness, n, l, v) / height;
        }
    return sum / double(count * count);
}

// The specular part of that, seen from above. Lobes of less roughness are too narrow for the sum.
glm::dvec3 headOnShare(const glm::dvec3& f0, double roughness) {
    return roughness < 0.2 ? f0 : gltfAlbedo(glm::dvec3(0.0), f0, roughness, 1.0);
}

// The wall has the radiance 1, and reflects nothing.
TEST(Glossy, AMirrorShowsTheRadianceOfAWallTimesItsFresnelFactor) {
    const Context context = openContext(Backend::egl);
    for (const float roughness : {0.0F, 0.2F})
        for (const double turnDeg : {0.0, 30.0}) {
            SCOPED_TRACE(testing::Message() << "roughness " << roughness << ", turned by " << turnDeg);
            Scene scene = emptyScene();
            scene.materials.push_back(metal(roughness));
            scene.materials.push_back(scene.materials[0]);
            scene.materials[2].baseColor = glm::vec4(0, 0, 0, 1);
            scene.materials[2].emissive = glm::vec3(1.0F);
            addQuad(scene, {-0.3, 0, -0.3}, {0, 0, 0.6}, {0.6, 0, 0}, 1);
            addQuad(scene, {-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, 2);
            const glm::dmat4 turn = turnScene(scene, turnDeg);
            scene = finished(scene);
            const Settings settings = glossyAt({48, 48});
            // The camera looks through the back of the wall.
            const Camera camera = lookAt(glm::dvec3(turn * glm::dvec4(0, 1.5, 0.01, 1)),
                                         glm::dvec3(turn * glm::dvec4(0, 0, 0, 1)), 20);
            FrameInspector frame(context, scene, noLight(), settings, camera);
            const std::vector<SeenSurface> seen = frame.seen(Output::specularLight);
            ASSERT_GT(seen.size(), 500U);
            glm::dvec3 mean(0.0);
            for (const SeenSurface& pixel : seen)
                mean += pixel.value / static_cast<double>(seen.size());
            const glm::dvec3 right = headOnShare(copper, roughness);
            // A cone loses at most the transmittance at which it ends, rounding to 8 bits, and the gaps of a
            // turned wall (measured).
            const double missing = 0.1 + (turnDeg == 0.0 ? 0.02 : 0.08);
            for (int i = 0; i < 3; ++i) {
                EXPECT_LE(mean[i], right[i] * 1.05);
                EXPECT_GE(mean[i], right[i] * (1.0 - missing));
            }
        }
}

// The mirror itself is the only emitter.
TEST(Glossy, APlaneDoesNotReflectItself) {
    const Context context = openContext(Backend::egl);
    for (const float roughness : {0.0F, 0.6F})
        for (const double turnDeg : {0.0, 30.0}) {
            Scene scene = lonePlane(turnDeg);
            scene.materials[0] = metal(roughness);
            scene.materials[0].emissive = glm::vec3(1.0F);
            const Settings settings = glossyAt({48, 48});
            FrameInspector frame(context, scene, noLight(), settings,
                                 lookAt(glm::dvec3(0.3, 2, 1.5), {0, 0, 0}, 30));
            const Spread seen = frame.spreadOf(Output::specularLight);
            ASSERT_GT(seen.count, 500);
            EXPECT_LT(seen.mean, 0.02) << "roughness " << roughness << ", turned by " << turnDeg;
        }
}

// A coat of varnish on a colour, which reflects the rest of the Fresnel term diffusely.
Material varnish(float roughness) {
    Material material = metal(roughness);
    material.metallic = 0.0F;
    return material;
}

// The diffuse albedo, and the Fresnel term head-on.
struct Reflecting {
    glm::dvec3 diffuse, f0;
};
Reflecting reflecting(const Material& material) {
    return material.metallic == 1.0F ? Reflecting{glm::dvec3(0.0), copper}
                                     : Reflecting{copper, glm::dvec3(0.04)};
}

TEST(Glossy, TheSunIsReflectedAsGltfSays) {
    const Context context = openContext(Backend::egl);
    for (const Material& material :
         {metal(0.25F), metal(0.5F), metal(0.8F), metal(1.0F), varnish(0.3F), varnish(0.6F)}) {
        Scene scene = lonePlane(0.0);
        scene.materials[0] = material;
        const DirectionalLight light = lightFrom(glm::normalize(glm::dvec3(0.3, 1, -1.4)));
        const Settings settings = glossyAt({48, 48});
        const glm::dvec3 eye(0.1, 0.7, 1.9);
        FrameInspector frame(context, scene, light, settings, lookAt(eye, {0, 0, 0}, 40));
        const Reflecting of = reflecting(material);
        int count = 0;
        for (const auto& [surface, radiance] : frame.seen(Output::gi)) {
            const glm::dvec3& position = surface.positionWorld;
            if (std::max(std::abs(position.x), std::abs(position.z)) > 0.9)
                continue;  // the edge of the shadow map
            const glm::dvec3 right = gltfReflection(of.diffuse, of.f0, material.roughness, {0, 1, 0},
                                                    light.directionToLight, glm::normalize(eye - position));
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(radiance[c], right[c], 0.025 * right[c] + 0.01)
                    << position.x << " " << position.z << ", roughness " << material.roughness;
            ++count;
        }
        EXPECT_GT(count, 500);
    }
}

TEST(Glossy, UnderAnEvenSkyASurfaceHasItsBrdfsAlbedo) {
    const Context context = openContext(Backend::egl);
    for (const Material& material : {metal(0.2F), metal(0.5F), metal(1.0F), varnish(0.2F), varnish(0.8F)})
        for (const double cosEye : {0.25, 0.95}) {
            SCOPED_TRACE(testing::Message() << "metallic " << material.metallic << ", roughness "
                                            << material.roughness << ", cosine " << cosEye);
            Scene scene = lonePlane(0.0);
            scene.materials[0] = material;
            Settings settings = glossyAt({16, 16});
            settings.skyRadiance = glm::vec3(1.0F);
            const glm::dvec3 eye = 3.0 * glm::dvec3(0.0, cosEye, std::sqrt(1.0 - cosEye * cosEye));
            FrameInspector frame(context, scene, noLight(), settings, lookAt(eye, {0, 0, 0}, 2));
            const glm::dvec3 seen(frame.view(Output::gi).pixels[8 * 16 + 8]);
            const Reflecting of = reflecting(material);
            const glm::dvec3 right = gltfAlbedo(of.diffuse, of.f0, material.roughness, cosEye);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(seen[c], right[c], 0.03 * right[c] + 0.005);
        }
}

// A roughness of 254/255 in a texture must not look like another material than 255/255.
TEST(Glossy, RoughnessNearOneMakesNoJump) {
    const Context context = openContext(Backend::egl);
    for (const Material& material : {metal(1.0F), varnish(1.0F)}) {
        glm::dvec3 before(0.0);
        for (int step = 0; step <= 4; ++step) {
            Scene scene = lonePlane(0.0);
            scene.materials[0] = material;
            scene.materials[0].roughness = 0.98F + 0.005F * static_cast<float>(step);
            Settings settings = glossyAt({16, 16});
            settings.skyRadiance = glm::vec3(0.3F);
            FrameInspector frame(context, scene, lightFrom(glm::normalize(glm::dvec3(0.3, 1, -1.4))),
                                 settings, lookAt(glm::dvec3(0.1, 0.7, 1.9), {0, 0, 0}, 10));
            const glm::dvec3 seen(frame.view(Output::gi).pixels[8 * 16 + 8]);
            for (int c = 0; c < 3 && step > 0; ++c)
                EXPECT_NEAR(seen[c], before[c], 0.05 * before[c])
                    << "metallic " << material.metallic << ", step " << step;
            before = seen;
        }
    }
}

Image pictureOf(const Context& context, const Scene& scene, const Settings& settings) {
    Renderer renderer(scene, lightFrom(glm::normalize(glm::dvec3(0.3, 1, 0.5))), settings,
                      context.capabilities, testShaders());
    renderer.render({{Output::giConeShadow}, lookAt({0.4, 1.5, 2.5}, {0, 0, 0}, 50)});
    return renderer.radiance();
}

// A floor and a wall on it.
Scene corner() {
    Scene scene = emptyScene();
    scene.materials.push_back(varnish(1.0F));
    addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0}, 1);
    addQuad(scene, {-1, 0, -1}, {2, 0, 0}, {0, 1, 0});
    return finished(scene);
}

// Voxels reflect diffusely whatever the gloss.
TEST(Glossy, AGlossySurfaceChangesItsOwnPixelsAlone) {
    const Context context = openContext(Backend::egl);
    const Settings settings = glossyAt({64, 64});
    Scene scene = corner();
    scene.materials[1].roughness = 0.3F;
    const Image with = pictureOf(context, scene, settings);
    const Image without = pictureOf(context, corner(), settings);
    FrameInspector frame(context, scene, noLight(), settings, lookAt({0.4, 1.5, 2.5}, {0, 0, 0}, 50));
    const std::vector<SurfacePixel>& pixels = frame.pixels();
    int floor = 0, wall = 0, changed = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (pixels[i].surface && pixels[i].normal.y > 0.5) {
            ++floor;
            changed += with.pixels[i] != without.pixels[i] ? 1 : 0;
        } else {
            ++wall;
            ASSERT_TRUE(sameInHalves(with.pixels[i], without.pixels[i]));
        }
    }
    EXPECT_GT(wall, 500);
    EXPECT_GT(floor, 500);
    EXPECT_GT(changed, floor * 99 / 100);
}

// A box on a floor in front of a wall, under an emitting ceiling that covers a part of them. All are of one
// glossy material except for the ceiling.
Scene edges(float roughness) {
    Scene scene = emptyScene();
    scene.materials.push_back(metal(roughness));
    scene.materials.push_back(scene.materials[0]);
    scene.materials[1].baseColor = glm::vec4(0, 0, 0, 1);
    scene.materials[1].emissive = glm::vec3(1.0F);
    scene.materials[0] = metal(roughness);
    addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0});
    addQuad(scene, {-1, 0, -1}, {2, 0, 0}, {0, 1, 0});
    addBox(scene, {0.5, 0.5, 0.5}, {0.1, 0.35, 0.3});
    addQuad(scene, {-1, 1, -1}, {1.2, 0, 0}, {0, 0, 2}, 1);
    return finished(scene);
}

// A roughness of 0.194 is traced in each pixel, and one of 0.202 in every second. The two differ only by
// the noise of their rays, also next to the edges between surfaces that reflect other things.
TEST(Glossy, HalfTheResolutionDoesNotBleedOverEdges) {
    const Context context = openContext(Backend::egl);
    for (const glm::ivec2 size : {glm::ivec2(96, 96), glm::ivec2(95, 93)}) {
        const Settings settings = glossyAt(size);
        const Camera camera = lookAt({0.6, 1.1, 1.9}, {0.1, 0.2, 0}, 50);
        FrameInspector full(context, edges(0.194F), noLight(), settings, camera);
        FrameInspector half(context, edges(0.202F), noLight(), settings, camera);
        const Image expected = full.view(Output::specularLight), actual = half.view(Output::specularLight);
        const std::vector<SurfacePixel>& pixels = full.pixels();
        int bright = 0, dark = 0, bled = 0;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const SurfacePixel& pixel = pixels[y * size.x + x];
                if (!pixel.surface) continue;
                float least = 1e9F, most = 0.0F;
                for (int v = std::max(y - 2, 0); v <= std::min(y + 2, size.y - 1); ++v)
                    for (int u = std::max(x - 2, 0); u <= std::min(x + 2, size.x - 1); ++u) {
                        const SurfacePixel& other = pixels[v * size.x + u];
                        if (!other.surface || glm::dot(other.normal, pixel.normal) < 0.99) continue;
                        const glm::dvec3 apart = other.positionWorld - pixel.positionWorld;
                        if (std::abs(glm::dot(apart, pixel.normal)) > 0.02) continue;
                        least = std::min(least, expected.pixels[v * size.x + u].x);
                        most = std::max(most, expected.pixels[v * size.x + u].x);
                    }
                const float value = actual.pixels[y * size.x + x].x;
                bled += value < least - 0.15F || value > most + 0.15F ? 1 : 0;
                bright += most > 0.5F ? 1 : 0;
                dark += least < 0.1F ? 1 : 0;
            }
        EXPECT_GT(bright, 500);
        EXPECT_GT(dark, 500);
        EXPECT_LE(bled, 30);
    }
}

TEST(Glossy, AResizedPictureIsThatOfANewRenderer) {
    const Context context = openContext(Backend::egl);
    Scene scene = corner();
    scene.materials[1].roughness = 0.4F;
    const DirectionalLight light = lightFrom(glm::normalize(glm::dvec3(0.3, 1, 0.5)));
    const RenderRequest request{{Output::gi}, lookAt({0.4, 1.5, 2.5}, {0, 0, 0}, 50), LightSteps::all};
    Renderer resized = makeRenderer(context, scene, light, glossyAt({32, 32}));
    resized.render(request);
    resized.resize({47, 33});
    resized.render(request);
    Renderer fresh = makeRenderer(context, scene, light, glossyAt({47, 33}));
    fresh.render(request);
    float largest = 0.0F;
    const Image one = resized.radiance(), other = fresh.radiance();
    for (std::size_t i = 0; i < one.pixels.size(); ++i)
        largest = std::max(largest, glm::length(one.pixels[i] - other.pixels[i]));
    EXPECT_LT(largest, 0.01F);
}

}  // namespace
}  // namespace vct::test
