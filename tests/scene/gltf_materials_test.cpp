#include <gtest/gtest.h>

#include <array>
#include <functional>

#include "image/image.h"
#include "support/errors.h"
#include "support/gltf_builder.h"

namespace vct::test {
namespace {

// A triangle whose corners have the given texture coordinates, with one material.
GltfBuilder textured(json material) {
    GltfBuilder builder;
    const int positions = builder.floats({0, 0, 0, 1, 0, 0, 0, 1, 0});
    const int uv0 = builder.floats({0, 0, 1, 0, 0, 1}, "VEC2");
    const int uv1 = builder.floats({0.5F, 0.5F, 0.75F, 0.5F, 0.5F, 0.75F}, "VEC2");
    builder.add("materials", std::move(material));
    builder.node(
        {{"mesh",
          builder.mesh({{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", uv0}, {"TEXCOORD_1", uv1}}},
                        {"material", 0}})}});
    return builder;
}

void expectUv(const glm::vec2& actual, float u, float v) {
    EXPECT_NEAR(actual.x, u, 1e-6F);
    EXPECT_NEAR(actual.y, v, 1e-6F);
}

TEST(GltfMaterials, FactorsMaskAndEmissiveStrength) {
    const Scene scene =
        load(textured({{"pbrMetallicRoughness", {{"baseColorFactor", {0.1, 0.2, 0.3, 0.4}}}},
                       {"emissiveFactor", {1, 0.5, 0}},
                       {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 6}}}}},
                       {"alphaMode", "MASK"},
                       {"alphaCutoff", 0.25},
                       {"doubleSided", true}}));
    const Material& material = scene.materials.at(0);
    EXPECT_EQ(material.baseColor, glm::vec4(0.1F, 0.2F, 0.3F, 0.4F));
    EXPECT_EQ(material.emissive, glm::vec3(6.0F, 3.0F, 0.0F));
    EXPECT_EQ(material.alphaMode, Material::AlphaMode::mask);
    EXPECT_EQ(material.alphaCutoff, 0.25F);
    EXPECT_TRUE(material.doubleSided);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(GltfMaterials, MetallicAndRoughnessAreReadEachAlone) {
    const auto gloss = [](const json& surface) {
        const Material material = load(textured({{"pbrMetallicRoughness", surface}})).materials.at(0);
        return glm::vec2(material.metallic, material.roughness);
    };
    EXPECT_EQ(gloss({{"metallicFactor", 0.25}, {"roughnessFactor", 0.5}}), glm::vec2(0.25F, 0.5F));
    EXPECT_EQ(gloss({{"metallicFactor", 0}}), glm::vec2(0.0F, 1.0F));
    EXPECT_EQ(gloss({{"roughnessFactor", 0}}), glm::vec2(1.0F, 0.0F));
    EXPECT_EQ(gloss({{"metallicFactor", 7}, {"roughnessFactor", -3}}), glm::vec2(1.0F, 0.0F));
}

TEST(GltfMaterials, TexturesOfGlossAndNormalsTakeTheirOwnCoordinates) {
    GltfBuilder builder =
        textured({{"pbrMetallicRoughness", {{"metallicRoughnessTexture", {{"index", 0}, {"texCoord", 1}}}}},
                  {"normalTexture", {{"index", 1}, {"scale", 0.5}}}});
    builder.texture(encodePng(4));
    builder.texture(encodePng(8));
    const Scene scene = load(builder);
    const Material& material = scene.materials.at(0);
    EXPECT_EQ(scene.textures.at(static_cast<std::size_t>(material.glossTexture)).width, 4);
    EXPECT_EQ(scene.textures.at(static_cast<std::size_t>(material.normalTexture)).width, 8);
    EXPECT_EQ(material.normalScale, 0.5F);
    const Mesh& mesh = scene.meshes.at(0);
    ASSERT_EQ(mesh.extras.size(), mesh.vertices.size());
    expectUv(mesh.extras[1].glossUv, 0.75F, 0.5F);
    expectUv(mesh.extras[1].normalUv, 1.0F, 0.0F);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(GltfMaterials, UnlitIsNothingButItsBaseColour) {
    GltfBuilder builder = textured({{"pbrMetallicRoughness", {{"roughnessFactor", 0.2}}},
                                    {"emissiveFactor", {1, 1, 1}},
                                    {"normalTexture", {{"index", 0}}},
                                    {"extensions", {{"KHR_materials_unlit", json::object()}}}});
    builder.document["extensionsUsed"] = {"KHR_materials_unlit"};
    builder.document["extensionsRequired"] = {"KHR_materials_unlit"};
    builder.texture(encodePng(4));
    const Scene scene = load(builder);
    const Material& material = scene.materials.at(0);
    EXPECT_TRUE(material.unlit);
    EXPECT_EQ(material.roughness, 1.0F);
    EXPECT_EQ(material.emissive, glm::vec3(0.0F));
    EXPECT_EQ(material.normalTexture, -1);
    EXPECT_TRUE(scene.warnings.empty());
}

Material ofSpecularGlossiness(const json& extension) {
    return load(textured({{"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 1, 1}}}},
                          {"extensions", {{"KHR_materials_pbrSpecularGlossiness", extension}}}}))
        .materials.at(0);
}

// A dielectric reflects 4 % specularly, and a metal nothing diffusely. In between, both brightnesses stay
// those of the file.
TEST(GltfMaterials, SpecularGlossinessBecomesMetallicRoughness) {
    const Material plaster = ofSpecularGlossiness({{"diffuseFactor", {0.5, 0.3, 0.2, 0.9}},
                                                   {"specularFactor", {0.04, 0.04, 0.04}},
                                                   {"glossinessFactor", 0.75}});
    EXPECT_EQ(plaster.metallic, 0.0F);
    EXPECT_EQ(plaster.roughness, 0.25F);
    for (int c = 0; c < 4; ++c)
        EXPECT_NEAR(plaster.baseColor[c], (std::array{0.5F, 0.3F, 0.2F, 0.9F})[c], 1e-6F);
    const Material copper =
        ofSpecularGlossiness({{"diffuseFactor", {0, 0, 0, 1}}, {"specularFactor", {0.95, 0.64, 0.54}}});
    EXPECT_NEAR(copper.metallic, 1.0F, 1e-5F);
    EXPECT_EQ(copper.roughness, 0.0F);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(copper.baseColor[c], (std::array{0.95F, 0.64F, 0.54F})[c], 1e-5F);
    // For a grey material: diffuse .3 (1 - .2) = base (1 - .04) (1 - metallic), and
    // specular .2 = .04 (1 - metallic) + base metallic.
    const Material between =
        ofSpecularGlossiness({{"diffuseFactor", {0.3, 0.3, 0.3, 1}}, {"specularFactor", {0.2, 0.2, 0.2}}});
    const float m = between.metallic;
    EXPECT_GT(m, 0.1F);
    EXPECT_LT(m, 0.9F);
    const float base = 0.3F * 0.8F / (0.96F * (1.0F - m));
    EXPECT_NEAR(0.04F * (1.0F - m) + base * m, 0.2F, 1e-5F);
    EXPECT_NEAR(between.baseColor.r, base, 1e-5F);
}

TEST(GltfMaterials, TexturesOfSpecularGlossinessAreConvertedTexelByTexel) {
    const auto file = [](const json& specularTexture) {
        GltfBuilder builder = textured({{"extensions",
                                         {{"KHR_materials_pbrSpecularGlossiness",
                                           {{"diffuseFactor", {0.5, 0.5, 0.5, 0.5}},
                                            {"diffuseTexture", {{"index", 0}, {"texCoord", 1}}},
                                            {"specularFactor", {0.04, 0.04, 0.04}},
                                            {"glossinessFactor", 0.5},
                                            {"specularGlossinessTexture", specularTexture}}}}}});
        builder.texture(encodePng(4));
        builder.texture(encodePng(8));
        return load(builder);
    };
    const Scene scene = file({{"index", 1}, {"texCoord", 1}});
    EXPECT_TRUE(scene.warnings.empty());
    const Material& material = scene.materials.at(0);
    const Texture& color = scene.textures.at(static_cast<std::size_t>(material.baseColorTexture));
    const Texture& gloss = scene.textures.at(static_cast<std::size_t>(material.glossTexture));
    ASSERT_EQ(glm::ivec2(color.width, color.height), glm::ivec2(8));  // the finer one's
    ASSERT_EQ(glm::ivec2(gloss.width, gloss.height), glm::ivec2(8));
    EXPECT_EQ(material.baseColor, glm::vec4(1.0F));
    EXPECT_EQ(glm::vec2(material.metallic, material.roughness), glm::vec2(1.0F));
    expectUv(scene.meshes.at(0).vertices[1].uv, 0.75F, 0.5F);
    expectUv(scene.meshes.at(0).extras[1].glossUv, 0.75F, 0.5F);
    // The diffuse texture is half as fine. A specular reflection of at most 4 % leaves the rest for diffuse
    // light.
    const float half = 0.5F * srgbDecode(static_cast<float>(3 * 255 / 4) / 255.0F);
    const float converted = srgbDecode(static_cast<float>(color.rgba[4 * 7]) / 255.0F);
    EXPECT_GE(converted, half - 0.003F);
    EXPECT_LE(converted, half / 0.96F + 0.003F);
    EXPECT_EQ(gloss.rgba[1], 128);  // 1 less a glossiness of .5
    EXPECT_EQ(gloss.rgba[2], 0);
    EXPECT_TRUE(hasWarning(file({{"index", 1}}), "lies elsewhere"));
}

// A triangle with these colours and one without. Both have the same material.
Scene colored(const std::function<int(GltfBuilder&)>& colors) {
    GltfBuilder builder;
    const int positions = builder.floats({0, 0, 0, 1, 0, 0, 0, 1, 0});
    builder.add("materials", {{"name", "painted"}});
    const int colorAccessor = colors(builder);
    builder.node(
        {{"mesh", builder.mesh({{"attributes", {{"POSITION", positions}, {"COLOR_0", colorAccessor}}},
                                {"material", 0}})}});
    builder.node({{"mesh", builder.mesh({{"attributes", {{"POSITION", positions}}}, {"material", 0}})}});
    return load(builder);
}

TEST(GltfMaterials, ColoursOfVerticesAreReadInEveryTypeThatGltfAllows) {
    const std::vector<Scene> scenes{
        colored([](GltfBuilder& b) { return b.floats({1, 0, 0, 0, 1, 0, 0, 0, 0.2F}); }),
        colored([](GltfBuilder& b) { return b.floats({1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 0.2F, 0.4F}, "VEC4"); }),
        colored([](GltfBuilder& b) {
            return b.accessor<std::uint8_t>({255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 51, 102}, uint8, "VEC4",
                                            true);
        }),
        colored([](GltfBuilder& b) {
            return b.accessor<std::uint16_t>({65535, 0, 0, 65535, 0, 65535, 0, 65535, 0, 0, 13107, 26214},
                                             uint16, "VEC4", true);
        })};
    for (const Scene& scene : scenes) {
        const Mesh& mesh = scene.meshes.at(0);
        ASSERT_EQ(mesh.extras.size(), 3U);
        const glm::vec4& last = mesh.extras[2].color;
        EXPECT_EQ(mesh.extras[0].color, glm::vec4(1, 0, 0, 1));
        EXPECT_NEAR(last.b, 0.2F, 1e-6F);
        EXPECT_NEAR(last.a, &scene == &scenes[0] ? 1.0F : 0.4F, 1e-6F);
        EXPECT_TRUE(scene.materials.at(static_cast<std::size_t>(mesh.material)).vertexColors);
        // The other mesh has no colours.
        const Mesh& plain = scene.meshes.at(1);
        EXPECT_TRUE(plain.extras.empty());
        EXPECT_FALSE(scene.materials.at(static_cast<std::size_t>(plain.material)).vertexColors);
        EXPECT_TRUE(scene.warnings.empty());
    }
}

TEST(GltfMaterials, BlendBecomesMaskWithAWarning) {
    const Scene scene = load(textured({{"alphaMode", "BLEND"}, {"alphaCutoff", 0.9}}));
    EXPECT_EQ(scene.materials.at(0).alphaMode, Material::AlphaMode::mask);
    EXPECT_EQ(scene.materials.at(0).alphaCutoff, 0.5F);
    EXPECT_TRUE(hasWarning(scene, "blended"));
}

TEST(GltfMaterials, WhatTransmitsHalfOfTheLightIsAHole) {
    for (const double factor : {0.49, 0.5}) {
        GltfBuilder builder =
            textured({{"extensions", {{"KHR_materials_transmission", {{"transmissionFactor", factor}}}}}});
        builder.triangle();  // a scene of holes alone would be drawn opaque
        const Scene scene = load(builder);
        const Material& material = scene.materials.at(0);
        const bool isHole = factor >= 0.5;
        EXPECT_EQ(
            material.alphaMode == Material::AlphaMode::mask && material.baseColor.a < material.alphaCutoff,
            isHole);
        EXPECT_TRUE(hasWarning(scene, isHole ? "are holes" : "are opaque"));
    }
}

TEST(GltfMaterials, EachTextureTakesTheCoordinatesItAsksFor) {
    GltfBuilder builder = textured({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                                    {"emissiveTexture", {{"index", 1}, {"texCoord", 1}}}});
    builder.texture(encodePng(4));
    builder.texture(encodeJpeg(16), {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}});
    const Scene scene = load(builder);
    ASSERT_EQ(scene.textures.size(), 2U);
    const Material& material = scene.materials.at(0);
    EXPECT_EQ(scene.textures.at(static_cast<std::size_t>(material.baseColorTexture)).width, 4);
    const Texture& emissive = scene.textures.at(static_cast<std::size_t>(material.emissiveTexture));
    EXPECT_EQ(emissive.height, 16);
    EXPECT_EQ(emissive.rgba.size(), 16U * 16U * 4U);
    EXPECT_EQ(emissive.wrapS, Texture::Wrap::clampToEdge);
    EXPECT_EQ(emissive.wrapT, Texture::Wrap::mirroredRepeat);
    EXPECT_FALSE(emissive.linearFilter);
    const Texture& png = scene.textures.at(static_cast<std::size_t>(material.baseColorTexture));
    EXPECT_EQ(png.wrapS, Texture::Wrap::repeat);
    EXPECT_EQ(png.rgba[4], 255 / 4);                  // x = 1, first row
    EXPECT_EQ(png.rgba[4 * 4 * 3 + 1], 3 * 255 / 4);  // y = 3 is the last row
    expectUv(scene.meshes[0].vertices[1].uv, 1.0F, 0.0F);
    expectUv(scene.meshes[0].vertices[1].emissiveUv, 0.75F, 0.5F);
}

TEST(GltfMaterials, TextureTransformIsBakedIntoItsOwnCoordinates) {
    // The example of the extension: the lower left quadrant (v points down), rotated clockwise by 90 degrees.
    const json transform = {
        {"KHR_texture_transform", {{"offset", {0, 1}}, {"rotation", 1.57079632679}, {"scale", {0.5, 0.5}}}}};
    const json override1 = {{"KHR_texture_transform", {{"texCoord", 1}, {"scale", {2, 4}}}}};
    GltfBuilder builder =
        textured({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}, {"extensions", transform}}}}},
                  {"emissiveTexture", {{"index", 0}, {"texCoord", 0}, {"extensions", override1}}}});
    builder.document["extensionsUsed"] = {"KHR_texture_transform"};
    builder.document["extensionsRequired"] = {"KHR_texture_transform"};
    builder.texture(encodePng(4));
    const Scene scene = load(builder);
    const std::vector<Vertex>& vertices = scene.meshes[0].vertices;
    expectUv(vertices[0].uv, 0.0F, 1.0F);
    expectUv(vertices[1].uv, 0.0F, 0.5F);
    expectUv(vertices[2].uv, 0.5F, 1.0F);
    expectUv(vertices[0].emissiveUv, 1.0F, 2.0F);
    expectUv(vertices[2].emissiveUv, 1.0F, 3.0F);
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(GltfMaterials, ASceneOfNothingButGlassIsDrawnOpaque) {
    GltfBuilder glass =
        textured({{"alphaMode", "BLEND"}, {"pbrMetallicRoughness", {{"baseColorFactor", {1, 1, 1, 0.1}}}}});
    EXPECT_EQ(load(glass).materials.at(0).alphaMode, Material::AlphaMode::opaque);
    EXPECT_TRUE(hasWarning(load(glass), "drawn opaque"));
    // Beside an opaque object light passes through the glass.
    glass.triangle();
    EXPECT_EQ(load(glass).materials.at(0).alphaMode, Material::AlphaMode::mask);
    EXPECT_FALSE(hasWarning(load(glass), "drawn opaque"));
}

TEST(GltfMaterials, AnExtensionThatIsNotKnownIsAWarningUnlessItHoldsTheGeometry) {
    GltfBuilder builder;
    builder.triangle();
    builder.document["extensionsUsed"] = {"EXT_of_tomorrow"};
    EXPECT_TRUE(hasWarning(load(builder), "EXT_of_tomorrow"));
    builder.document["extensionsRequired"] = {"EXT_of_tomorrow"};
    const Scene scene = load(builder);
    ASSERT_EQ(scene.warnings.size(), 1U);
    expectMentions(scene.warnings[0], {"requires", "EXT_of_tomorrow"});
    builder.document["accessors"][0].erase("bufferView");
    expectMentions(loadError(builder), {"accessor 0", "no data", "EXT_of_tomorrow"});
    builder.document["meshes"][0]["primitives"][0]["mode"] = 0;
    expectMentions(loadError(builder), {"no triangles", "EXT_of_tomorrow"});
}

}  // namespace
}  // namespace vct::test
