// Some 90 misuses of the library: each is an error of one line, with cause and remedy, and nothing crashes.
#include <limits>

#include "api/described_scene.h"
#include "support/errors.h"

namespace vct::test {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinite = std::numeric_limits<float>::infinity();

class Misuse : public Embedded {
  protected:
    void expectError(const std::string& says, const std::function<void()>& misuse) {
        const std::string error = errorOf(misuse);
        EXPECT_NE(error.find(says), std::string::npos) << "'" << says << "' is not in: " << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
        EXPECT_EQ(gl::GetError(), GLenum{GL_NO_ERROR}) << error;
        ++misuses_;
    }
    using Spoil = std::function<void(SceneDescription&, Options&)>;
    void expectRefused(const std::string& says, const Spoil& spoil) {
        SceneDescription scene = described_.scene;
        Options options = optionsOf("mobile");
        spoil(scene, options);
        expectError(says, [&] { GlobalIllumination(getProcAddress, scene, options); });
    }
    int misuses_ = 0;
};

TEST_F(Misuse, OfADescriptionIsAnError) {
    using Scene = SceneDescription;
    const std::vector<float> shorter(71), beyond(72, infinite), fewer(9);
    std::vector<float> sky(96, 0.5F);
    expectRefused("size", [](Scene&, Options& options) { options.width = 0; });
    expectRefused("size", [](Scene&, Options& options) { options.height = -5; });
    expectRefused("size", [](Scene&, Options& options) { options.width = 1 << 30; });
    expectRefused("64, 128, 256, 512", [](Scene&, Options& options) { options.grid = -64; });
    expectRefused("voxelSize must be", [](Scene&, Options& options) { options.voxelSize = nan; });
    expectRefused("voxelSize must be", [](Scene&, Options& options) { options.voxelSize = infinite; });
    expectRefused("voxel", [](Scene&, Options& options) { options.voxelSize = 1e-30F; });
    expectRefused("bounds", [](Scene& scene, Options&) { scene.bounds = Box{{1, 0, 0}, {0, 1, 1}}; });
    expectRefused("bounds", [](Scene& scene, Options&) { scene.bounds = Box{{nan, 0, 0}, {1, 1, 1}}; });
    expectRefused("bounds", [](Scene& scene, Options&) { scene.bounds = Box{{0, 0, 0}, {1, infinite, 1}}; });
    expectRefused("the limit is 64", [](Scene& scene, Options&) { scene.maxLights = 65; });
    expectRefused("the limit is 64", [](Scene& scene, Options&) { scene.maxLights = ~std::size_t{0}; });
    expectRefused("maxInstances", [](Scene& scene, Options&) { scene.maxInstances = ~std::size_t{0}; });
    expectRefused("three numbers for each", [](Scene& scene, Options&) { scene.sky = SkyPicture{}; });
    expectRefused("three numbers for each",
                  [&](Scene& scene, Options&) { scene.sky = SkyPicture{16, 8, sky}; });
    expectRefused("twice as wide as high", [&](Scene& scene, Options&) {
        scene.sky = SkyPicture{4, 4, std::span<const float>(sky).first(48)};
    });
    sky[7] = nan;
    expectRefused("pixel", [&](Scene& scene, Options&) { scene.sky = SkyPicture{8, 4, sky}; });
    expectRefused("radiance", [](Scene& scene, Options&) { scene.skyRadiance[2] = nan; });
    expectRefused("the sun", [](Scene& scene, Options&) { scene.sun.directionToSun = {nan, 1, 0}; });
    expectRefused("illuminance", [](Scene& scene, Options&) { scene.sun.illuminance = infinite; });
    expectRefused("illuminance", [](Scene& scene, Options&) { scene.sun.illuminance = -1; });
    expectRefused("cone angle", [](Scene& scene, Options&) { scene.sun.diameterDegrees = nan; });
    expectRefused("three numbers per position",
                  [&](Scene& scene, Options&) { scene.meshes[0].positions = shorter; });
    expectRefused("is not finite", [&](Scene& scene, Options&) { scene.meshes[0].positions = beyond; });
    expectRefused("as many normals", [&](Scene& scene, Options&) { scene.meshes[0].normals = fewer; });
    expectRefused("three per triangle",
                  [](Scene& scene, Options&) { scene.meshes[0].indices = scene.meshes[0].indices.first(4); });
    expectRefused("base colour", [](Scene& scene, Options&) { scene.materials[0].baseColor[1] = nan; });
    expectRefused("roughness", [](Scene& scene, Options&) { scene.materials[0].roughness = 2; });
    expectRefused("emission", [](Scene& scene, Options&) { scene.materials[0].emission[0] = infinite; });
    expectRefused("normalScale", [](Scene& scene, Options&) { scene.materials[0].normalScale = nan; });
    expectRefused("instance 1",
                  [](Scene& scene, Options&) { scene.instances[1].worldFromObject.columns[12] = nan; });
    expectRefused("deforms", [](Scene& scene, Options&) { scene.meshes[1].deforms = true; });
    expectRefused("light 0", [](Scene& scene, Options&) { scene.lights = {{.position = {infinite, 0, 0}}}; });
    expectRefused("light 0", [](Scene& scene, Options&) { scene.lights = {{.radius = nan}}; });
    expectRefused("light 0", [](Scene& scene, Options&) { scene.lights = {{.range = nan}}; });
    expectRefused("light 0", [](Scene& scene, Options&) { scene.lights = {{.diameterDegrees = 171}}; });
    expectRefused("the preset ''", [](Scene&, Options& options) { options.preset = ""; });
    expectRefused("maxInstances is 1", [](Scene& scene, Options&) { scene.maxInstances = 1; });
    expectRefused("the limit is 64", [](Scene& scene, Options&) { scene.lights.resize(65); });
    expectRefused("diameter", [](Scene& scene, Options&) { scene.sun.diameterDegrees = 171; });
    expectRefused("colour", [](Scene& scene, Options&) { scene.sun.color = {1, -1, 0}; });
    expectRefused("colour", [](Scene& scene, Options&) { scene.sun.color = {2, 1, 1}; });
    expectRefused("base colour", [](Scene& scene, Options&) { scene.materials[0].baseColor = {-1, 0, 0}; });
    expectRefused("metallic", [](Scene& scene, Options&) { scene.materials[0].metallic = nan; });
    expectRefused("emission", [](Scene& scene, Options&) { scene.materials[0].emission = {0, -1, 0}; });
    expectRefused("alpha cutoff", [](Scene& scene, Options&) { scene.materials[0].alphaCutoff = nan; });
    expectRefused("there is no mesh 0", [](Scene& scene, Options&) { scene.meshes.clear(); });
    expectRefused("triangle", [](Scene& scene, Options&) { scene.meshes[0].indices = {}; });
    expectRefused("position", [](Scene& scene, Options&) { scene.meshes[0].positions = {}; });
    expectRefused("light 0", [](Scene& scene, Options&) { scene.lights = {{.color = {0, nan, 0}}}; });
    expectRefused("light 0", [](Scene& scene, Options&) { scene.lights = {{.color = {0, 2, 0}}}; });
    expectRefused("light 0", [](Scene& scene, Options&) { scene.lights = {{.intensity = infinite}}; });
    expectRefused("light 0", [](Scene& scene, Options&) { scene.lights = {{.radius = -1}}; });
    sky[7] = -1;
    expectRefused("pixel", [&](Scene& scene, Options&) { scene.sky = SkyPicture{8, 4, sky}; });
    expectRefused("three numbers for each",
                  [&](Scene& scene, Options&) { scene.sky = SkyPicture{1 << 30, 1 << 29, sky}; });
    EXPECT_GE(misuses_, 54);
}

TEST_F(Misuse, OfAnObjectIsAnError) {
    described_.scene.instances[1].moves = described_.scene.meshes[1].deforms = true;
    GlobalIllumination light(getProcAddress, described_.scene, optionsOf("mobile"));
    const View view = described_.view();
    View wrong = view;
    expectError("the look-up has no light yet", [&] { light.bindLookUp(); });
    expectError("has not converged", [&] { light.bakeLight(); });
    expectError("useBakedLight: this is no baked light", [&] { light.useBakedLight({}); });
    wrong.clipFromCamera.columns[5] = nan;
    expectError("clipFromCamera", [&] { light.render(wrong); });
    wrong = view;
    wrong.cameraFromWorld.columns[0] = nan;
    expectError("cameraFromWorld", [&] { light.render(wrong); });
    wrong.cameraFromWorld.columns[0] = -view.cameraFromWorld.columns[0];
    expectError("cameraFromWorld", [&] { light.render(wrong); });
    wrong = view;
    wrong.reversedDepth = true;
    expectError("reversedDepth is set", [&] { light.render(wrong); });
    expectError("albedo", [&] { light.render(view, GBufferTextures{}); });
    expectError("albedo", [&] { light.render(view, {777, 778, 779}); });
    expectError("setTransform", [&] {
        Matrix matrix;
        matrix.columns[12] = infinite;
        light.setTransform(1, matrix);
    });
    expectError("does not exist or was not declared to deform", [&] { light.setVertices(0, {}, {}); });
    expectError("positions", [&] { light.setVertices(1, {}, {}); });
    expectError("scale between 0 and 1", [&] { light.setEmission(1, nan); });
    expectError("setSun", [&] { light.setSun({nan, 0, 0}); });
    expectError("illuminance", [&] { light.setSunlight({1, 1, 1}, nan); });
    expectError("radiance", [&] { light.setSky(std::array<float, 3>{0, -1, 0}); });
    expectError("raise SceneDescription::maxLights", [&] { light.addLight({}); });
    expectError("no light 0", [&] { light.setLight(0, {}); });
    expectError("no light 3", [&] { light.removeLight(3); });
    expectError("maxInstances", [&] { light.addMesh(described_.scene.meshes[0]); });
    expectError("size", [&] { light.resize(0, 10); });
    expectError("size", [&] { light.resize(1 << 20, 10); });
    expectError("setTransform", [&] { light.setTransform(~std::size_t{0}, {}); });
    expectError("not affine", [&] {
        Matrix matrix;
        matrix.columns[7] = 1;
        light.setTransform(1, matrix);
    });
    expectError("positions is 777", [&] { light.setVertices(1, {777, 777}, {{0, 0, 0}, {1, 1, 1}}); });
    expectError("illuminance", [&] { light.setSunlight({1, 1, 1}, -1); });
    expectError("sky's radiance", [&] { light.setSky({nan, 0, 0}); });
    expectError("no mesh 99", [&] { light.removeMesh(99); });
    expectError("material", [&] { light.setMaterial(0, {.roughness = nan}); });
    expectError("material", [&] { light.addMaterial({.emission = {infinite, 0, 0}}); });
    expectError("texture units 1000 to 1007", [&] { light.lookUpGlsl({1000, 0, 0}); });
    expectError("uniform buffers 4294967295 to 4294967296", [&] { light.lookUpGlsl({0, ~0U, 0}); });
    expectError("storage buffers 1000 to 1000", [&] { light.lookUpGlsl({0, 0, 1000}); });
    light.render(view);
    expectError("bindLookUp: LookUpBindings names texture", [&] { light.bindLookUp({1000, 0, 0}); });
    EXPECT_GE(misuses_, 34);
    // The errors have changed nothing.
    EXPECT_NE(light.render(view).radiance, 0U);
}

}  // namespace
}  // namespace vct::test
