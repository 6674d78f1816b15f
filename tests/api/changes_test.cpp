// Changes at run time through include/vct/vct.h, against a fresh scene that is described as changed.
#include "api/described_scene.h"
#include "image/compare.h"
#include "support/errors.h"

namespace vct::test {
namespace {

class Changes : public Embedded {
  protected:
    Changes() {
        for (const std::size_t i : {std::size_t{1}, std::size_t{2}})
            described_.scene.instances[i].moves = true;
    }
    Image picture(GlobalIllumination& light, double unit = 1.0) const {
        const Pictures pictures = refines_
                                      ? light.render(described_.view(), GlobalIllumination::Light::converged)
                                      : afterBounces(light);
        return imageOf(pictures.radiance, unit);
    }
    // `fresh`: a renderer of the changed scene. Returns the difference of `light`, in the scene's unit.
    void expectAsFresh(GlobalIllumination& light, GlobalIllumination& fresh, const char* what) {
        const Difference difference =
            compareImages(picture(light, light.radianceUnit()), picture(fresh, fresh.radianceUnit()), 0.04F);
        EXPECT_TRUE(difference.comparable) << what;
        EXPECT_LE(difference.fraction, 0.01) << what << ": largest difference " << difference.largest;
    }
    void expectOther(GlobalIllumination& light, const Image& before, const char* what) {
        const Difference difference = compareImages(picture(light), before, 0.04F);
        EXPECT_GT(difference.fraction, 0.015) << what;
    }
    SceneDescription changed_;
    bool refines_ = false;
};

TEST_F(Changes, OfSunAndSkyGiveThePictureOfAFreshScene) {
    GlobalIllumination light(getProcAddress, described_.scene, optionsOf("mobile"));
    Image before = picture(light);
    SceneDescription changed = described_.scene;
    light.setSunlight(changed.sun.color = {1, 0.5F, 0.2F}, changed.sun.illuminance = 1.5F);
    expectOther(light, before, "the sun");
    {
        GlobalIllumination fresh(getProcAddress, changed, optionsOf("mobile"));
        expectAsFresh(light, fresh, "the sun");
    }
    before = picture(light);
    light.setSky(changed.skyRadiance = {0.5F, 0.1F, 0.1F});
    expectOther(light, before, "the sky");
    GlobalIllumination fresh(getProcAddress, changed, optionsOf("mobile"));
    expectAsFresh(light, fresh, "the sky");
}

TEST_F(Changes, OfTheSkysPictureGiveThePictureOfAFreshScene) {
    SceneDescription& scene = described_.scene;
    scene.skyRadiance = {0, 0, 0};
    const std::vector<float> dim(std::size_t{16} * 8 * 3, 0.1F);
    std::vector<float> half(std::size_t{16} * 8 * 3, 0.1F);
    std::fill_n(half.begin(), half.size() / 2, 0.8F);
    scene.sky = SkyPicture{16, 8, dim};
    GlobalIllumination light(getProcAddress, scene, optionsOf("mobile"));
    const Image before = picture(light);
    light.setSky(SkyPicture{16, 8, half});
    expectOther(light, before, "the picture");
    scene.sky = SkyPicture{16, 8, half};
    GlobalIllumination fresh(getProcAddress, scene, optionsOf("mobile"));
    expectAsFresh(light, fresh, "the picture");
    expectMentions(errorOf([&] { light.setSky({1, 1, 1}); }), {"give a picture"});
}

TEST_F(Changes, HiddenInstancesAreAsIfTheyWereNotThere) {
    SceneDescription& scene = described_.scene;
    SceneDescription without = scene;
    without.instances.erase(without.instances.begin() + 1);
    scene.instances[1].isVisible = false;
    GlobalIllumination light(getProcAddress, scene, optionsOf("mobile"));
    GlobalIllumination fresh(getProcAddress, without, optionsOf("mobile"));
    expectAsFresh(light, fresh, "hidden from the start");
    const Image before = picture(light);
    light.setVisible(1, true);
    expectOther(light, before, "shown");
    scene.instances[1].isVisible = true;
    {
        GlobalIllumination shown(getProcAddress, scene, optionsOf("mobile"));
        expectAsFresh(light, shown, "shown");
    }
    light.setVisible(1, false);
    expectAsFresh(light, fresh, "hidden");
}

// The box moves towards the sun, far behind the camera.
TEST_F(Changes, OutsideOfTheVoxelsAreThoseOfAHiddenInstance) {
    SceneDescription& scene = described_.scene;
    scene.bounds.reset();
    GlobalIllumination light(getProcAddress, scene, optionsOf("mobile"));
    const Image before = picture(light);
    EXPECT_NEAR(light.voxelBounds().max[0], 1.6, 0.1);
    Matrix away = scene.instances[1].worldFromObject;
    for (std::size_t axis = 0; axis < 3; ++axis)
        away.columns[12 + axis] += 10.0 * scene.sun.directionToSun[axis];
    light.setTransform(1, away);
    scene.instances[1].isVisible = false;
    GlobalIllumination hidden(getProcAddress, scene, optionsOf("mobile"));
    expectAsFresh(light, hidden, "outside");
    light.setTransform(1, scene.instances[1].worldFromObject);
    const Difference back = compareImages(picture(light), before, 0.04F);
    EXPECT_LE(back.fraction, 0.01) << "moved back: largest difference " << back.largest;
}

// The box moves beside the floor and out of the picture. Its shadow still falls onto the floor.
TEST_F(Changes, InsideOfTheBoundsGiveThePictureOfAFreshScene) {
    SceneDescription& scene = described_.scene;
    scene.bounds = Box{{-1.5, -0.2, -1.5}, {2.25, 1.5, 1.5}};
    GlobalIllumination light(getProcAddress, scene, optionsOf("mobile"));
    const Box voxels = light.voxelBounds();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_LT(voxels.min[axis], scene.bounds->min[axis]);
        EXPECT_GT(voxels.max[axis], scene.bounds->max[axis]);
        EXPECT_NEAR(voxels.max[axis] - voxels.min[axis], 3.75 * 64 / 59, 1e-9);
    }
    picture(light);
    scene.instances[1].worldFromObject.columns[12] = 1.95;
    light.setTransform(1, scene.instances[1].worldFromObject);
    GlobalIllumination fresh(getProcAddress, scene, optionsOf("mobile"));
    expectAsFresh(light, fresh, "inside");
    light.setVisible(1, false);
    EXPECT_GT(compareImages(picture(light), picture(fresh), 0.04F).fraction, 0.005) << "hidden";
}

// The emitter is compact as it is, and its emission is in the voxels if it is large.
TEST_F(Changes, OfEmissionGiveThePictureOfAFreshScene) {
    for (const bool isLarge : {false, true}) {
        SceneDescription scene = described_.scene;
        if (isLarge) scene.instances[2].worldFromObject.columns[10] = 1.2;
        GlobalIllumination light(getProcAddress, scene, optionsOf("mobile"));
        const Image before = picture(light);
        const float scale = isLarge ? 0.0F : 0.25F;
        light.setEmission(2, scale);
        expectOther(light, before, "emission");
        for (std::size_t i = 0; i < 3; ++i)
            scene.materials[2].emission[i] *= scale;
        GlobalIllumination fresh(getProcAddress, scene, optionsOf("mobile"));
        expectAsFresh(light, fresh, isLarge ? "large" : "compact");
    }
}

// The box is sheared and made larger, and moves.
TEST_F(Changes, OfVerticesGiveThePictureOfAFreshScene) {
    SceneDescription& scene = described_.scene;
    scene.meshes[1].deforms = true;
    std::vector<float> positions = described_.positions, both;
    for (std::size_t i = 0; i < positions.size(); i += 3) {
        positions[i] += 0.6F * positions[i + 1];
        positions[i + 1] *= 1.5F;
        // Interleaved, after a float that is not read.
        both.insert(both.end(), {0, positions[i], positions[i + 1], positions[i + 2], described_.normals[i],
                                 described_.normals[i + 1], described_.normals[i + 2]});
    }
    const gl::Buffer buffer("of the test", GL_ARRAY_BUFFER, both.size() * sizeof both[0], both.data(),
                            GL_STATIC_DRAW);
    const VertexBuffers vertices{buffer.name(), buffer.name(), 4, 28, 16, 28};
    const Box bounds{{-1.6, -1.5, -1}, {1.6, 1.5, 1}};
    GlobalIllumination light(getProcAddress, scene, optionsOf("mobile"));
    const Image before = picture(light);
    light.setVertices(1, vertices, bounds);
    expectOther(light, before, "vertices");
    SceneDescription changed = scene;
    changed.meshes[1].positions = positions;
    changed.instances[1].worldFromObject.columns[12] -= 0.4;
    light.setTransform(1, changed.instances[1].worldFromObject);
    refines_ = true;  // the faces of a moving object have other rays than those of a fresh scene
    GlobalIllumination fresh(getProcAddress, changed, optionsOf("mobile"));
    expectAsFresh(light, fresh, "vertices, and moved");

    expectMentions(errorOf([&] { light.setVertices(0, vertices, bounds); }), {"mesh 0", "deforms"});
    expectMentions(errorOf([&] { light.setVertices(1, {buffer.name(), 0}, bounds); }),
                   {"VertexBuffers::normals is 0", "24 vertices need 288"});
    expectMentions(errorOf([&] { light.setVertices(1, {buffer.name(), buffer.name(), 2}, bounds); }),
                   {"multiples of 4"});
    scene.instances[1].moves = false;
    expectMentions(errorOf([&] { GlobalIllumination(getProcAddress, scene); }),
                   {"mesh 1", "exactly one instance, with `moves`"});
}

TEST_F(Changes, ErrorsNameTheInstance) {
    GlobalIllumination light(getProcAddress, described_.scene, optionsOf("mobile"));
    expectMentions(errorOf([&] { light.setVisible(0, false); }), {"instance 0 was not declared to move"});
    expectMentions(errorOf([&] { light.setEmission(9, 1); }), {"setEmission: there is no instance 9"});
    expectMentions(errorOf([&] { light.setEmission(2, 2); }), {"scale between 0 and 1"});
    expectMentions(errorOf([&] { light.setSunlight({0.5F, 0, 0}, 1); }), {"sun's colour"});
    expectMentions(errorOf([&] { light.setSky(SkyPicture{}); }), {"without a picture of the sky"});
    described_.scene.instances[0].isVisible = false;
    expectMentions(errorOf([&] { GlobalIllumination(getProcAddress, described_.scene); }),
                   {"instance 0 was not declared to move"});
}

}  // namespace
}  // namespace vct::test
