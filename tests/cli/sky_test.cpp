// The options --environment and --background, and the light of scenes that have none.
#include <gtest/gtest.h>

#include "cli/program_run.h"
#include "core/files.h"
#include "image/compare.h"
#include "image/image.h"
#include "lab/options.h"
#include "support/errors.h"
#include "support/gltf_builder.h"
#include "support/pictures.h"

namespace vct::test {
namespace {

const std::string patio = VCT_SOURCE_DIR "/assets/patio";

std::string renderPatio(const std::string& options) {
    return "render " + patio + ".glb --out out --mode gi --preset mobile --light-frames 2 --size 16x16 " +
           options;
}

void write(const ProgramRun& program, const std::string& name, const std::string& text) {
    replaceFile(program.folder.file(name), text);
}

TEST(SkyOption, ABadFileIsOneErrorThatNamesFileCauseAndRemedy) {
    const std::string good = readBytes(patio + ".hdr");
    const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";
    Image negative(4, 2, glm::vec3(1.0F));
    negative.at(1, 0).g = -1.0F;
    struct Case {
        std::string name, bytes, cause, remedy;
    };
    const Case cases[] = {
        {"truncated.hdr", good.substr(0, good.size() - 100), "it is incomplete", "make it again"},
        {"header.hdr", good.substr(0, 20), "its header is incomplete", "make it again"},
        // The end of a run-length row is missing: stb_image would search for it for ever.
        {"endless.hdr", header + "-Y 4 +X 8\n" + std::string("\2\2\0\x08\x88\1", 6), "it is incomplete",
         "make it again"},
        {"run.hdr", header + "-Y 4 +X 8\n" + std::string("\2\2\0\x08\xff\1", 6) + std::string(99, '\1'),
         "a row of it is damaged", "make it again"},
        {"square.hdr", header + "-Y 2 +X 2\n" + std::string(16, '\x80'), "it is 2 x 2 pixels",
         "twice as wide as high"},
        {"huge.hdr", header + "-Y 100000 +X 200000\n", "200000 x 100000", "make it again"},
        {"empty.hdr", "", "the file is empty", "make it again"},
    };
    for (const Case& bad : cases) {
        ProgramRun program;
        write(program, bad.name, bad.bytes);
        EXPECT_EQ(program.run(renderPatio("--environment " + bad.name)), 1) << bad.name;
        EXPECT_EQ(lineCount(program.err), 1) << program.err;
        expectMentions(program.err, {"error: ", bad.name, bad.cause, bad.remedy});
    }
    ProgramRun program;
    writeExr(program.folder.file("negative.exr"), negative);
    EXPECT_EQ(program.run(renderPatio("--environment negative.exr")), 1);
    expectMentions(program.err, {"negative.exr", "pixel 1,0", "give radiance from 0 on"});
    EXPECT_NE(program.run(renderPatio("--sky 1,1,1 --environment " + patio + ".hdr")), 0);
    expectMentions(program.err, {"--sky", "--environment"});
}

TEST(SkyOption, ASceneWithoutLightGetsASunAndASkyThatOptionsRepeat) {
    ProgramRun program;
    ASSERT_EQ(program.run(renderPatio("")), 0) << program.err;
    const std::size_t at = program.err.find("--light direction=");
    ASSERT_NE(at, std::string::npos) << program.err;
    const std::string given = program.err.substr(at, program.err.find('\n', at) - at);
    const Image byDefault = readImage(program.folder.file("out/gi.exr"));
    ASSERT_EQ(program.run(renderPatio(given)), 0) << program.err;
    EXPECT_EQ(program.err.find("the scene has no light of its own"), std::string::npos);
    expectSameInHalves(readImage(program.folder.file("out/gi.exr")), byDefault);
    // A given sky is light, and no sun is added.
    ASSERT_EQ(program.run(renderPatio("--environment " + patio + ".hdr")), 0) << program.err;
    EXPECT_EQ(program.err.find("the scene has no light of its own"), std::string::npos);
    EXPECT_GT(compareImages(readImage(program.folder.file("out/gi.exr")), byDefault, 0.01F).fraction, 0.5);
}

// Writes a room of 4 x 2 x 3 m with single-sided walls that face inwards.
void writeClosedRoom(const ProgramRun& program, const std::string& name, GltfBuilder builder = {}) {
    const float x = 2.0F, y = 1.0F, z = 1.5F;
    std::vector<float> corners;
    for (int i = 0; i < 8; ++i)
        corners.insert(corners.end(), {(i & 1) != 0 ? x : -x, (i & 2) != 0 ? y : -y, (i & 4) != 0 ? z : -z});
    const std::vector<std::uint16_t> indices{0, 4, 5, 0, 5, 1, 2, 3, 7, 2, 7, 6, 0, 1, 3, 0, 3, 2,
                                             4, 6, 7, 4, 7, 5, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3};
    const int mesh = builder.mesh({{"attributes", {{"POSITION", builder.floats(corners)}}},
                                   {"indices", builder.accessor(indices, uint16, "SCALAR")}});
    builder.node({{"mesh", mesh}});
    writeBytes(program.folder.file(name), builder.glb());
}

constexpr const char* renderRoom =
    "render room.glb --out out --mode gi --preset mobile --grid 64 --light-frames 2 --size 16x16 ";

TEST(SkyOption, AClosedRoomWithoutALightGetsALampAndSaysSo) {
    ProgramRun program;
    writeClosedRoom(program, "room.glb");
    program.expectSuccess(renderRoom);
    expectMentions(program.err,
                   {"a closed room without a light", "adds a point light of", "--light or --sky"});
    EXPECT_EQ(program.err.find("--sky 0.2"), std::string::npos) << program.err;
    EXPECT_EQ(program.err.find("warning"), std::string::npos) << program.err;
    program.expectSuccess(std::string(renderRoom) + "--exposure 1");
    const Image lit = readImage(program.folder.file("out/gi.exr"));
    for (const glm::vec3& pixel : lit.pixels)
        EXPECT_GT(pixel.g, 0.1F);
}

TEST(SkyOption, ARoomThatNoLightReachesIsWarnedAbout) {
    ProgramRun program;
    writeClosedRoom(program, "room.glb");
    program.expectSuccess(std::string(renderRoom) + "--light intensity=3.14 --sky 0.2,0.25,0.35");
    EXPECT_EQ(program.err.find("adds a point light"), std::string::npos) << program.err;
    expectMentions(program.err, {"warning: the picture is black", "--camera"});
}

// A triangle from (0,0,0) to (1,1,0) that faces +Z, of this colour.
GltfBuilder triangleOf(float grey) {
    GltfBuilder builder;
    builder.triangle();
    const int material = builder.add(
        "materials",
        {{"pbrMetallicRoughness", {{"baseColorFactor", {grey, grey, grey, 1}}, {"metallicFactor", 0}}}});
    builder.document["meshes"][0]["primitives"][0]["material"] = material;
    return builder;
}

void addPointLight(GltfBuilder& builder, float candela) {
    builder.document["extensionsUsed"].push_back("KHR_lights_punctual");
    builder.document["extensions"]["KHR_lights_punctual"]["lights"].push_back(
        {{"type", "point"}, {"intensity", candela}});
    builder.node({{"translation", {0.3, 0.3, 1}}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
}

Image rendered(ProgramRun& program, const GltfBuilder& scene, const std::string& options = "") {
    writeBytes(program.folder.file("scene.glb"), scene.glb());
    program.expectSuccess(
        "render scene.glb --out out --mode gi --preset mobile --grid 64 --light-frames 2 "
        "--size 32x32 --samples 1 " +
        options);
    return readImage(program.folder.file("out/gi.exr"));
}

// Adds a directional light of this illuminance, which travels towards the triangle's front.
void addSun(GltfBuilder& builder, float lux) {
    builder.document["extensionsUsed"].push_back("KHR_lights_punctual");
    builder.document["extensions"]["KHR_lights_punctual"]["lights"].push_back(
        {{"type", "directional"}, {"intensity", lux}});
    builder.node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
}

// Exporters write a sun without a sky.
TEST(SkyOption, ASunWithoutASkyGetsAPlainOneAndSaysSo) {
    ProgramRun program;
    GltfBuilder scene = triangleOf(0.5F);
    addSun(scene, 2.0F * 3.14159265F);
    const Image byDefault = rendered(program, scene);
    expectMentions(program.err, {"note: the sun comes without a sky", "--sky 0.4,0.5,0.7", "--sky 0,0,0"});
    expectSameInHalves(rendered(program, scene, "--sky 0.4,0.5,0.7"), byDefault);
    EXPECT_EQ(program.err.find("note: the sun"), std::string::npos) << program.err;
    // In the middle of the triangle, which sees the sun and half of the sky: albedo times (E / pi + L).
    EXPECT_NEAR(byDefault.at(16, 16).b, 0.5F * (2.0F + 0.7F), 0.05F);
    EXPECT_NEAR(rendered(program, scene, "--sky 0,0,0").at(16, 16).b, 0.5F * 2.0F, 0.02F);
}

TEST(SkyOption, ARadianceHasSeveralForms) {
    EXPECT_EQ(colorFromText("--sky", "0.1, 2,3"), glm::vec3(0.1F, 2.0F, 3.0F));
    EXPECT_EQ(colorFromText("--sky", "0.5"), glm::vec3(0.5F));
    EXPECT_EQ(colorFromText("--sky", "white"), glm::vec3(1.0F));
    EXPECT_EQ(colorFromText("--sky", "black"), glm::vec3(0.0F));
    const glm::vec3 coded = colorFromText("--sky", "#ff80bC");  // by the formula of IEC 61966-2-1
    EXPECT_NEAR(coded.r, 1.0F, 1e-6F);
    EXPECT_NEAR(coded.g, 0.2158605F, 1e-6F);
    EXPECT_NEAR(coded.b, 0.5028865F, 1e-6F);
    for (const char* bad : {"1,2", "1,2,x", "-1", "#ff80b", "#ff80bg", "sunset", ""})
        expectMentions(errorOf([&] { colorFromText("--sky", bad); }), {"--sky"});
}

TEST(SkyOption, ALightOfAnOptionDoesNotTakeTheSkyAway) {
    ProgramRun program;
    const Image lit = rendered(program, triangleOf(0.5F), "--light direction=0,0,-1,intensity=6.2831853");
    expectMentions(program.err, {"note: the sun comes without a sky", "--sky 1.00531,1.00531,1.00531"});
    EXPECT_NEAR(lit.at(16, 16).b, 0.5F * (2.0F + 1.00531F), 0.05F);
}

TEST(Background, ContrastsWithWhiteUnlessASkyIsGiven) {
    ProgramRun program;
    const glm::vec3 sky(0.376991F);
    const Image white = rendered(program, triangleOf(1.0F));
    expectMentions(program.err, {"vct adds a studio",
                                 "--sky 0.376991,0.376991,0.376991 --background 0.113097,0.113097,0.113097"});
    EXPECT_LT(white.at(0, 0).b, 0.35F * sky.b);
    const Image dark = rendered(program, triangleOf(0.1F));
    EXPECT_EQ(program.err.find("--background"), std::string::npos) << program.err;
    EXPECT_NEAR(dark.at(0, 0).b, sky.b, 1e-3F);
    EXPECT_NEAR(rendered(program, triangleOf(1.0F), "--sky 0.2,0.25,0.35").at(0, 0).b, 0.35F, 1e-3F);
    EXPECT_NEAR(rendered(program, triangleOf(1.0F), "--background 0,1,0").at(0, 0).g, 1.0F, 1e-3F);
}

TEST(Background, ContrastsWithAnObjectThatNearlyFillsThePicture) {
    ProgramRun program;
    rendered(program, triangleOf(1.0F), "--camera eye=0.25,0.3,0.8,target=0.25,0.3,0,fov=40");
    expectMentions(program.err, {"--background 0.113097,0.113097,0.113097"});
    // An edge that shows surfaces only is that of a room, whose windows show the sky.
    rendered(program, triangleOf(1.0F), "--camera eye=0.25,0.3,0.8,target=0.25,0.3,0,fov=10");
    EXPECT_EQ(program.err.find("--background"), std::string::npos) << program.err;
}

TEST(Background, ChangesNoSurface) {
    ProgramRun program;
    const Image plain = rendered(program, triangleOf(0.5F), "--sky 0.2,0.25,0.35");
    const Image red = rendered(program, triangleOf(0.5F), "--sky 0.2,0.25,0.35 --background 1,0,0");
    EXPECT_EQ(red.at(0, 0), glm::vec3(1, 0, 0));
    int surfaces = 0;
    for (std::size_t i = 0; i < plain.pixels.size(); ++i) {
        if (red.pixels[i] == glm::vec3(1, 0, 0)) continue;
        ++surfaces;
        EXPECT_EQ(red.pixels[i], plain.pixels[i]);
    }
    EXPECT_GT(surfaces, 50);
    EXPECT_NE(program.run("render scene.glb --out out --background 1,0,0 --environment " + patio + ".hdr"),
              0);
    expectMentions(program.err, {"--background", "--environment"});
}

TEST(Background, OfPointLightsAloneIsDimAndTheNoteHasTheOtherChoice) {
    ProgramRun program;
    GltfBuilder scene = triangleOf(0.5F);
    addPointLight(scene, 5.0F);
    const Image lit = rendered(program, scene);
    expectMentions(program.err, {"note: the lights of the file are the scene's only light",
                                 "--light direction=", "--sky ", "adds both"});
    EXPECT_GT(lit.at(0, 0).b, 0.0F);
    EXPECT_EQ(rendered(program, scene, "--sky 0,0,0").at(0, 0), glm::vec3(0.0F));
    EXPECT_EQ(program.err.find("note: the lights"), std::string::npos) << program.err;
}

TEST(EmptyPicture, SaysWhy) {
    ProgramRun program;
    rendered(program, triangleOf(0.5F));
    EXPECT_EQ(program.err.find("warning"), std::string::npos) << program.err;
    rendered(program, triangleOf(0.5F), "--camera eye=0.3,0.3,2,target=0.3,0.3,9");
    expectMentions(program.err, {"warning: the picture is empty", "nothing of the scene", "--camera eye="});
    rendered(program, triangleOf(0.5F), "--camera eye=0.3,0.3,-2,target=0.3,0.3,0");
    expectMentions(program.err, {"warning: the picture is empty", "only the backs of single-sided surfaces"});
    rendered(program, triangleOf(0.5F), "--camera eye=0.3,0.3,1e7,target=0.3,0.3,0");
    expectMentions(program.err, {"warning: the picture is empty", "larger than a pixel", "1 x 1 x 0 m"});
    rendered(program, triangleOf(0.5F), "--light intensity=0 --exposure 1");
    expectMentions(program.err,
                   {"warning: the picture is black", "there is no light", "--light intensity=3"});
    rendered(program, triangleOf(0.0F), "--sky 0,0,0 --light intensity=3");
    expectMentions(program.err, {"warning: the picture is black", "or they are black"});
    rendered(program, triangleOf(0.0F), "--sky 1,1,1 --camera eye=0.25,0.3,0.8,target=0.25,0.3,0,fov=10");
    expectMentions(program.err, {"warning: the picture is black", "or they are black"});
    rendered(program, triangleOf(0.002F), "--sky 0,0,0 --light intensity=3");
    expectMentions(program.err, {"warning: little of the scene's light reaches the picture", "--camera"});
    GltfBuilder scene = triangleOf(0.5F);
    scene.document["extensionsUsed"].push_back("KHR_lights_punctual");
    scene.document["extensions"]["KHR_lights_punctual"]["lights"].push_back(
        {{"type", "directional"}, {"intensity", 0}});
    scene.node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    rendered(program, scene);
    expectMentions(program.err, {"warning: the picture is black", "intensity of 0", "--light intensity=3"});
}

}  // namespace
}  // namespace vct::test
