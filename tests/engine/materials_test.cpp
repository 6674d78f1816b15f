// Materials, compared with closed forms or with the same scene described in another way.
#include <gtest/gtest.h>

#include "scene/camera.h"
#include "support/frame_inspector.h"
#include "support/pictures.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

const DirectionalLight slantingSun = lightFrom(glm::normalize(glm::dvec3(0.3, 1.0, 0.2)));

Settings materialSettings() {
    return mobileAt(64);
}

Camera overhead() {
    return lookAt({0.1, 2.5, 0.9}, {0, 0, 0}, 50);
}

// A texture of one texel, or of two beside each other.
Texture texels(const std::vector<std::uint8_t>& rgba) {
    Texture texture;
    texture.width = static_cast<int>(rgba.size() / 4);
    texture.height = 1;
    texture.rgba = rgba;
    texture.wrapS = texture.wrapT = Texture::Wrap::clampToEdge;
    texture.linearFilter = false;
    return texture;
}

// Squares from x = -1 to 0 and from 0 to 1, of the materials 0 and 1, in the plane y = 0 under a wall.
Scene twoFloors() {
    Scene scene = emptyScene();
    scene.materials.resize(3);
    addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {1, 0, 0}, 0);
    addQuad(scene, {0, 0, -1}, {0, 0, 2}, {1, 0, 0}, 1);
    addQuad(scene, {-1, 0, -1}, {2, 0, 0}, {0, 1, 0}, 2);
    for (Mesh& mesh : scene.meshes)
        mesh.extras.resize(mesh.vertices.size());
    return finished(std::move(scene));
}

// The texture coordinates of the floors grow with x and z of the world; the floor is [0, 1]^2.
void setFloorUv(Scene& scene, glm::vec2 VertexExtras::* member, bool turned = false) {
    for (int m = 0; m < 2; ++m) {
        Mesh& mesh = scene.meshes[static_cast<std::size_t>(m)];
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
            const glm::vec3 p = glm::vec3(mesh.centre) + mesh.vertices[i].position;
            const glm::vec2 uv = 0.5F * glm::vec2(p.x + 1.0F, p.z + 1.0F);
            mesh.extras[i].*member = turned ? 1.0F - uv : uv;
        }
    }
}

Image drawn(const Context& context, const Scene& scene) {
    FrameInspector frame(context, scene, slantingSun, materialSettings(), overhead());
    return frame.view(Output::gi);
}

TEST(Materials, AGlossTextureOfTwoHalvesEqualsTwoMaterials) {
    const Context context = openContext(Backend::egl);
    Scene factors = twoFloors();
    for (int i = 0; i < 2; ++i)
        factors.materials[i].baseColor = glm::vec4(0.9, 0.6, 0.3, 1.0);
    Scene textured = factors;
    factors.materials[0].roughness = 51.0F / 255.0F;
    factors.materials[0].metallic = 1.0F;
    factors.materials[1].roughness = 153.0F / 255.0F;
    factors.materials[1].metallic = 102.0F / 255.0F;
    // Red and alpha have no meaning here.
    textured.textures.push_back(texels({255, 51, 255, 9, 0, 153, 102, 200}));
    textured.materials[0].glossTexture = textured.materials[1].glossTexture = 0;
    textured.materials[0].metallic = textured.materials[1].metallic = 1.0F;
    textured.materials[0].roughness = textured.materials[1].roughness = 1.0F;
    setFloorUv(textured, &VertexExtras::glossUv);
    const Image expected = drawn(context, factors);
    expectSameInHalves(drawn(context, textured), expected);
    EXPECT_GT(expected.pixels[40 * 64 + 20].x, 0.01F);
}

TEST(Materials, VertexColoursEqualMaterialsOfThoseColours) {
    const Context context = openContext(Backend::egl);
    const glm::vec4 red(0.8, 0.1, 0.05, 1.0), blue(0.1, 0.2, 0.7, 1.0);
    for (const char* preset : {"mobile", "thesis"}) {
        Settings settings = unrefinedPreset(preset);
        settings.size = glm::ivec2(64);
        settings.grid = 64;
        Scene ofMaterials = twoFloors();
        Scene vertexValues = ofMaterials;
        ofMaterials.materials[0].baseColor = red;
        ofMaterials.materials[1].baseColor = blue;
        for (int i = 0; i < 2; ++i) {
            vertexValues.materials[i].vertexColors = true;
            for (VertexExtras& extras : vertexValues.meshes[i].extras)
                extras.color = i == 0 ? red : blue;
        }
        FrameInspector expected(context, ofMaterials, slantingSun, settings, overhead());
        FrameInspector frame(context, vertexValues, slantingSun, settings, overhead());
        // The white wall receives their light, too.
        for (const Output view : {Output::gi, Output::indirectLight})
            expectSameInHalves(frame.view(view), expected.view(view));
    }
}

TEST(Materials, AnUnlitSurfaceShowsItsBaseColourAndLightsNothing) {
    const Context context = openContext(Backend::egl);
    Scene scene = twoFloors();
    const glm::vec4 color(0.25, 0.5, 0.75, 1.0);
    scene.materials[0].unlit = scene.materials[1].unlit = true;
    scene.materials[0].baseColor = scene.materials[1].baseColor = color;
    FrameInspector frame(context, scene, slantingSun, materialSettings(), overhead());
    int count = 0;
    for (const auto& [surface, shown] : frame.seen(Output::gi)) {
        if (surface.normal.y < 0.5) continue;
        ++count;
        for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(shown[c], color[c], 0.001);
    }
    EXPECT_GT(count, 500);
    // The wall receives as much as from black floors.
    scene.materials[0].unlit = scene.materials[1].unlit = false;
    scene.materials[0].baseColor = scene.materials[1].baseColor = {0, 0, 0, 1};
    FrameInspector black(context, scene, slantingSun, materialSettings(), overhead());
    expectSameInHalves(frame.view(Output::indirectLight), black.view(Output::indirectLight));
}

// +X of the map is where the first texture coordinate grows and +Y where the second one falls. From behind
// the normal is reversed.
TEST(Materials, ANormalMapTurnsTheNormal) {
    const Context context = openContext(Backend::egl);
    for (const bool turned : {false, true})
        for (const bool fromBehind : {false, true})
            for (const float scale : {1.0F, 0.5F}) {
                Scene scene = twoFloors();
                scene.textures.push_back(texels({191, 166, 230, 255}));
                for (int i = 0; i < 2; ++i) {
                    scene.materials[i].normalTexture = 0;
                    scene.materials[i].normalScale = scale;
                    scene.materials[i].doubleSided = true;
                }
                setFloorUv(scene, &VertexExtras::normalUv, turned);
                const glm::dvec3 eye(0.1, fromBehind ? -2.5 : 2.5, 0.9);
                FrameInspector frame(context, scene, slantingSun, materialSettings(),
                                     lookAt(eye, {0, 0, 0}, 50));
                const glm::dvec3 stored = glm::dvec3(191, 166, 230) / 127.5 - 1.0;
                // Texture coordinates grow with x and z of the world, or against them if turned.
                const double sign = turned ? -1.0 : 1.0;
                glm::dvec3 right =
                    glm::normalize(glm::dvec3(sign * scale * stored.x, stored.z, -sign * scale * stored.y));
                if (fromBehind) right = -right;
                int count = 0;
                for (const SurfacePixel& pixel : frame.pixels()) {
                    // The foot of the wall does not belong to the floor.
                    if (!pixel.surface || std::abs(pixel.positionWorld.y) > 1e-3 ||
                        pixel.positionWorld.z < -0.95)
                        continue;
                    ++count;
                    ASSERT_LT(glm::length(pixel.normal - right), 2e-3)
                        << turned << fromBehind << scale << ": " << pixel.normal.x << " " << pixel.normal.y
                        << " " << pixel.normal.z;
                }
                EXPECT_GT(count, 500);
            }
}

// Masks keep the share of their area that is covered, however far away they are: in the picture, in the
// shadow map and in the voxels.
constexpr int leafTexels = 32;
constexpr double leafRadius = 0.36;  // in widths of the texture

// A round leaf, opaque green, on transparent red.
Texture leaf() {
    std::vector<std::uint8_t> rgba;
    for (int y = 0; y < leafTexels; ++y)
        for (int x = 0; x < leafTexels; ++x) {
            const glm::dvec2 fromMiddle = (glm::dvec2(x, y) + 0.5) / double{leafTexels} - 0.5;
            const bool covered = glm::length(fromMiddle) < leafRadius;
            const std::uint8_t green = covered ? 255 : 0, red = covered ? 0 : 255;
            rgba.insert(rgba.end(), {red, green, 0, green});
        }
    Texture texture;
    texture.width = texture.height = leafTexels;
    texture.rgba = rgba;
    return texture;
}
const double leafShare = pi * leafRadius * leafRadius;

// A floor of side 2 in the plane y = 0, and `leavesAcross` squared leaves in a square of the same size above.
Scene leavesOverFloor(int leavesAcross) {
    Scene scene = emptyScene();
    scene.textures.push_back(leaf());
    Material mask;
    mask.metallic = 0.0F;
    mask.baseColorTexture = 0;
    mask.alphaMode = Material::AlphaMode::mask;
    mask.doubleSided = true;
    scene.materials.push_back(mask);
    addQuad(scene, {-1, 0, -1}, {0, 0, 2}, {2, 0, 0});
    addQuad(scene, {-1, 1, -1}, {0, 0, 2}, {2, 0, 0}, 1);
    Mesh& leaves = scene.meshes.back();
    for (Vertex& vertex : leaves.vertices)
        vertex.uv = 0.5F * float(leavesAcross) * (glm::vec2(vertex.position.x, vertex.position.z) + 1.0F);
    return finished(std::move(scene));
}

Settings settingsOfLeaves() {
    Settings settings = mobileAt(128);
    settings.shadowMapSize = 128;
    return settings;
}

class Leaves : public testing::TestWithParam<int> {
  protected:
    const Context context_ = openContext(Backend::egl);
    const Scene scene_ = leavesOverFloor(GetParam());
};
INSTANTIATE_TEST_SUITE_P(Masks, Leaves, testing::Values(8, 24, 50, 100));

TEST_P(Leaves, CoverTheSameShareOfThePicture) {
    FrameInspector frame(context_, scene_, slantingSun, settingsOfLeaves(),
                         lookAt({0, 9, 0.001}, {0, 0, 0}, 12));
    int covered = 0, all = 0;
    double red = 0.0;
    for (const SurfacePixel& pixel : frame.pixels()) {
        ++all;
        if (pixel.positionWorld.y < 0.5) continue;
        ++covered;
        red += pixel.albedo.r;
    }
    EXPECT_NEAR(static_cast<double>(covered) / all, leafShare, 0.03);
    EXPECT_LE(red / covered, 0.05);  // holes have no colour
}

TEST_P(Leaves, ShadeTheSameShareOfTheFloor) {
    FrameInspector frame(context_, scene_, slantingSun, settingsOfLeaves(),
                         lookAt({0, 0.9, 0.001}, {0, 0, 0}, 70));
    double sum = 0.0;
    const std::vector<float> light = frame.hardShadow();
    for (const float share : light)
        sum += share;
    EXPECT_NEAR(sum / static_cast<double>(light.size()), 1.0 - leafShare, 0.03);
}

TEST_P(Leaves, CoverTheSameShareOfTheirVoxels) {
    FrameInspector frame(context_, scene_, slantingSun, settingsOfLeaves(),
                         lookAt({0, 9, 0.001}, {0, 0, 0}, 12));
    double covered = 0.0, ofFloor = 0.0;
    const unsigned upwards = 2;
    for (const auto& [entry, face] : frame.faces())
        if (shared::unpackFace(entry) == upwards)
            (static_cast<int>(shared::unpackFaceVoxel(entry).y) > settingsOfLeaves().grid / 2 ? covered
                                                                                              : ofFloor) +=
                face.coverage;
    EXPECT_NEAR(covered / ofFloor, leafShare, 0.04);
}

}  // namespace
}  // namespace vct::test
