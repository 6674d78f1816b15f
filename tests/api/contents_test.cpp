// Materials, meshes and instances that come, go and change, through include/vct/vct.h.
#include "api/described_scene.h"
#include "image/compare.h"
#include "support/errors.h"
#include "support/gl_spy.h"

namespace vct::test {
namespace {

constexpr std::size_t floorAt = 0, boxAt = 1, emitterAt = 2;

class Contents : public Embedded {
  protected:
    Contents() { scene_.maxInstances = 8; }
    Image picture(GlobalIllumination& light) const {
        return imageOf(afterBounces(light).radiance, light.radianceUnit());
    }
    // The same scene, all of it described.
    void expectAsDescribed(GlobalIllumination& light, const SceneDescription& scene, const char* what) {
        const Image shown = picture(light);
        GlobalIllumination fresh(getProcAddress, scene, optionsOf("mobile"));
        const Difference difference = compareImages(shown, picture(fresh), 0.04F);
        EXPECT_TRUE(difference.comparable) << what;
        EXPECT_LE(difference.fraction, 0.01) << what << ": largest difference " << difference.largest;
    }
    SceneDescription without(std::size_t instance) const {
        SceneDescription scene = scene_;
        scene.instances.erase(scene.instances.begin() + static_cast<std::ptrdiff_t>(instance));
        return scene;
    }
    SceneDescription& scene_ = described_.scene;
};

TEST_F(Contents, ThatAreAddedGiveThePictureOfADescribedScene) {
    scene_.instances[boxAt].moves = true;  // added instances have the rays of those that move
    const SceneDescription begin = without(boxAt);
    GlobalIllumination light(getProcAddress, begin, optionsOf("mobile"));
    picture(light);
    const std::size_t material = light.addMaterial(scene_.materials[boxAt]);
    MeshDescription box = scene_.meshes[boxAt];
    box.material = material;
    const std::size_t mesh = light.addMesh(box);
    InstanceDescription instance = scene_.instances[boxAt];
    instance.mesh = mesh;
    const std::size_t number = light.addInstance(instance);
    expectAsDescribed(light, scene_, "added");

    SceneDescription changed = scene_;
    changed.materials[boxAt].baseColor = {0.9F, 0.3F, 0.1F};
    light.setMaterial(material, changed.materials[boxAt]);
    expectAsDescribed(light, changed, "painted");
    changed.instances[boxAt].worldFromObject.columns[12] -= 0.5;
    light.setTransform(number, changed.instances[boxAt].worldFromObject);
    expectAsDescribed(light, changed, "moved");

    light.removeInstance(number);
    light.removeMesh(mesh);
    light.removeMaterial(material);
    expectAsDescribed(light, begin, "removed");
}

// The floor is static, and the emitter compact.
TEST_F(Contents, GetTheirMaterialsAsIfTheyWereDescribedWithThem) {
    GlobalIllumination light(getProcAddress, scene_, optionsOf("mobile"));
    const Image before = picture(light);
    SceneDescription changed = scene_;
    changed.materials[floorAt].baseColor = {0.1F, 0.6F, 0.1F};
    changed.materials[emitterAt].emission = {0, 0, 1};
    light.setMaterial(floorAt, changed.materials[floorAt]);
    light.setMaterial(emitterAt, changed.materials[emitterAt]);
    // The unit of radiance, and with it the scale of errors, is that of the first scene.
    EXPECT_GT(compareImages(picture(light), before, 0.04F).fraction, 0.3);
    expectAsDescribed(light, changed, "painted");
}

TEST_F(Contents, ThatStreamReuseTheirMemoryAndTheirNumbers) {
    scene_.maxInstances = 100;
    GlobalIllumination light(getProcAddress, scene_, optionsOf("mobile"));
    std::vector<std::size_t> meshes, instances;
    const auto stream = [&](std::size_t first) {
        for (std::size_t i = 0; i < 90; ++i) {
            if (meshes.size() == 90) {
                light.removeInstance(instances[i]);
                light.removeMesh(meshes[i]);
            }
            // The meshes have one triangle or more.
            MeshDescription mesh = scene_.meshes[boxAt];
            mesh.indices = mesh.indices.first(3 + (i * 7 + first) % 11 * 3);
            const std::size_t added = light.addMesh(mesh);
            const std::size_t shown = light.addInstance({added, scene_.instances[boxAt].worldFromObject});
            if (meshes.size() < 90) {
                meshes.push_back(added);
                instances.push_back(shown);
            }
            EXPECT_EQ(added, meshes[i]);
            EXPECT_EQ(shown, instances[i]);
        }
    };
    stream(0);
    stream(5);
    int allocations = 0;
    const GlSpy<&gl::BufferData> counts([&](GLenum, GLsizeiptr, const void*, GLenum) { ++allocations; });
    for (std::size_t i = 0; i < 5; ++i)
        stream(i);
    EXPECT_EQ(allocations, 0);
}

TEST_F(Contents, MisuseNamesCauseAndRemedy) {
    scene_.maxInstances = 5;
    const std::unique_ptr<GlobalIllumination> light =
        std::make_unique<GlobalIllumination>(getProcAddress, scene_, optionsOf("mobile"));
    const auto expectError = [&](const auto& call, std::initializer_list<std::string> parts) {
        expectMentions(errorOf([&] { call(*light); }), parts);
    };
    const MeshDescription box = scene_.meshes[boxAt];
    const std::size_t material = light->addMaterial(scene_.materials[boxAt]), mesh = [&] {
        MeshDescription own = box;
        own.material = material;
        return light->addMesh(own);
    }();
    const std::size_t instance = light->addInstance({mesh, {}});
    using Light = GlobalIllumination;
    expectError([&](Light& l) { l.addInstance({mesh, {}}); }, {"has 5 instances already", "maxInstances"});
    expectError([&](Light& l) { l.removeMesh(mesh); },
                {"is that of instance 4", "remove the instance first"});
    expectError([&](Light& l) { l.removeMaterial(material); },
                {"is that of mesh 4", "remove the mesh first"});
    expectError([](Light& l) { l.removeInstance(0); }, {"was described with the scene", "setVisible"});
    expectError([](Light& l) { l.removeInstance(9); }, {"there is no instance 9"});
    expectError([](Light& l) { l.removeMesh(0); }, {"was described with the scene"});
    expectError([](Light& l) { l.removeMesh(9); }, {"there is no mesh 9", "addMesh"});
    expectError([](Light& l) { l.removeMaterial(0); }, {"was described with the scene"});
    expectError([](Light& l) { l.setMaterial(9, {}); }, {"there is no material 9", "addMaterial"});
    expectError([](Light& l) { l.setMaterial(0, {{2, 0, 0}}); }, {"material 0", "between 0 and 1"});
    expectError([](Light& l) { l.addMaterial({.baseColorTexture = 77}); }, {"baseColorTexture is 77"});
    MaterialDescription masked = scene_.materials[boxAt];
    masked.alphaCutoff = 0.5F;
    expectError([&](Light& l) { l.addMaterial(masked); }, {"single-sided, an alpha cutoff", "describe one"});
    MaterialDescription bright = scene_.materials[emitterAt];
    bright.emission = {9, 0, 0};
    expectError([&](Light& l) { l.setMaterial(emitterAt, bright); }, {"emits 9", "brightest", "emits 4"});
    MeshDescription wrong = box;
    wrong.material = 9;
    expectError([&](Light& l) { l.addMesh(wrong); }, {"there is no material 9"});
    wrong = box;
    wrong.deforms = true;
    expectError([&](Light& l) { l.addMesh(wrong); }, {"deforms"});
    wrong = box;
    wrong.indices = {};
    expectError([&](Light& l) { l.addMesh(wrong); }, {"the mesh", "at least one triangle"});
    light->removeInstance(instance);
    expectError([&](Light& l) { l.setTransform(instance, {}); },
                {"there is no instance 4", "has 4 instances"});
    Matrix projective;
    projective.columns[3] = 1;
    expectError([&](Light& l) { l.addInstance({mesh, projective}); }, {"addInstance", "not affine"});
    expectError([](Light& l) { l.addInstance({9, {}}); }, {"there is no mesh 9"});

    scene_.maxInstances = 0;
    scene_.materials[3].roughness = 1;
    GlobalIllumination fixed(getProcAddress, scene_, optionsOf("mobile"));
    expectMentions(errorOf([&] { fixed.addMesh(box); }), {"no room for more instances", "maxInstances"});
    expectMentions(errorOf([&] { fixed.addInstance({0, {}}); }), {"has 4 instances already"});
    expectMentions(errorOf([&] { fixed.setMaterial(boxAt, {.metallic = 1}); }),
                   {"is glossy", "describe one"});
    // An error has changed nothing.
    fixed.setMaterial(boxAt, scene_.materials[boxAt]);
}

// A texture of one texel, as a factor.
TEST_F(Contents, GlossTexturesAndNormalMapsAreThoseOfGltf) {
    const auto texel = [](std::array<std::uint8_t, 4> rgba) {
        auto texture = gl::Texture::make2d("of the test", GL_RGBA8, 1, 1);
        texture.bind(gl::scratchTextureUnit);
        gl::TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
        return texture;
    };
    const gl::Texture half = texel({255, 102, 51, 255}), flat = texel({128, 128, 255, 255}),
                      tilted = texel({200, 128, 220, 255});
    std::vector<float> uv;
    for (std::size_t i = 0; i < described_.positions.size(); i += 3)
        uv.insert(uv.end(),
                  {described_.positions[i] + described_.positions[i + 1], described_.positions[i + 2]});
    constexpr std::size_t wall = 3;
    const auto shown = [&](const SceneDescription& scene) {
        GlobalIllumination light(getProcAddress, scene, optionsOf("mobile"));
        return imageOf(light.render(described_.view()).radiance, light.radianceUnit());
    };
    SceneDescription plain = scene_, textured = scene_;
    plain.materials[wall].roughness = 0.4F;
    plain.materials[wall].metallic = 0.2F;
    textured.meshes[wall].textureCoordinates = uv;
    textured.materials[wall].roughness = textured.materials[wall].metallic = 1.0F;
    textured.materials[wall].glossTexture = half.name();
    textured.materials[wall].normalTexture = flat.name();
    const Image expected = shown(plain);
    EXPECT_LE(compareImages(shown(textured), expected, 0.04F).fraction, 0.01);
    textured.materials[wall].normalTexture = tilted.name();
    EXPECT_GT(compareImages(shown(textured), expected, 0.04F).fraction, 0.02);
}

}  // namespace
}  // namespace vct::test
