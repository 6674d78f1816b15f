#include <gtest/gtest.h>

#include "support/errors.h"
#include "support/gltf_builder.h"

namespace vct::test {
namespace {

struct Lamp {
    const char* name;
    double height;   // above the triangle at z = 0
    double candela;  // lux of a directional light
    const char* type = "point";
    double range = 0.0;  // 0: none
};

Scene sceneLitBy(const std::vector<Lamp>& lamps) {
    GltfBuilder b;
    b.triangle();
    json& lights = b.document["extensions"]["KHR_lights_punctual"]["lights"];
    const auto add = [&](const Lamp& lamp) {
        lights.push_back({{"type", lamp.type}, {"name", lamp.name}, {"intensity", lamp.candela}});
        if (lights.back()["type"] == "spot") lights.back()["spot"] = json::object();
        if (lamp.range > 0.0) lights.back()["range"] = lamp.range;
        b.node({{"translation", {0.2, 0.2, lamp.height}},
                {"extensions", {{"KHR_lights_punctual", {{"light", lights.size() - 1}}}}}});
    };
    for (const Lamp& lamp : lamps)
        add(lamp);
    return load(b);
}

std::vector<Lamp> asManyAsFit() {
    return std::vector<Lamp>(64, {"strong", 1.0, 10.0, "spot"});
}

std::string leftOut(const Lamp& lamp, const std::vector<Lamp>& others = asManyAsFit()) {
    std::vector<Lamp> lamps = others;
    lamps.insert(lamps.begin() + 3, lamp);
    const Scene scene = sceneLitBy(lamps);
    EXPECT_EQ(scene.punctualLights.size(), 64U);
    std::string said;
    for (const std::string& warning : scene.warnings)
        said += warning;
    return said;
}

TEST(StrongestLights, AreKeptAndTheOthersAreNamedWithTheFile) {
    EXPECT_EQ(sceneLitBy(asManyAsFit()).warnings, std::vector<std::string>{});
    expectMentions(leftOut({"dim", 1.0, 9.0}),
                   {"test.glb has 65 lights besides the sun", "the limit is 64", "left out: \"dim\""});
    expectMentions(leftOut({"", 1.0, 9.0}), {"left out: number 4"});
    expectMentions(leftOut({"brighter", 1.0, 11.0}), {"left out: \"strong\""});
}

// The illuminance counts, which falls with the square of the distance.
TEST(StrongestLights, AreThoseWithTheMostIlluminanceAtTheNearestObject) {
    expectMentions(leftOut({"far", 2.0, 39.0}), {"left out: \"far\""});
    expectMentions(leftOut({"far and bright", 2.0, 41.0}), {"left out: \"strong\""});
    expectMentions(leftOut({"near", 0.5, 2.4}), {"left out: \"near\""});
    expectMentions(leftOut({"near enough", 0.5, 2.6}), {"left out: \"strong\""});
    // The nearest distance that counts is a tenth of the scene's side.
    expectMentions(leftOut({"touching", 0.001, 0.09}), {"left out: \"touching\""});
    expectMentions(leftOut({"short", 1.0, 20.0, "point", 0.9}), {"left out: \"short\""});
}

TEST(StrongestLights, CompareDirectionalLightsByTheirLux) {
    std::vector<Lamp> lamps = asManyAsFit();
    lamps.insert(lamps.begin(), {"sun", 1.0, 1.0, "directional"});
    expectMentions(leftOut({"weak", 1.0, 9.0, "directional"}, lamps), {"left out: \"weak\""});
    expectMentions(leftOut({"moon", 1.0, 11.0, "directional"}, lamps), {"left out: \"strong\""});
}

// Six maps for a point light, of 96.
TEST(StrongestLights, HaveTheShadowMapsAndTheOthersAreNamed) {
    std::vector<Lamp> lamps(15, {"strong", 1.0, 10.0});
    lamps.insert(lamps.begin() + 3, {"dim", 1.0, 9.0});
    EXPECT_EQ(sceneLitBy(lamps).warnings, std::vector<std::string>{});
    lamps.push_back({"brighter", 1.0, 11.0});
    const std::vector<std::string> warnings = sceneLitBy(lamps).warnings;
    ASSERT_EQ(warnings.size(), 1U);
    expectMentions(warnings[0], {"test.glb", "shadow maps (96", "cast no shadows: \"dim\""});
    EXPECT_EQ(sceneLitBy(lamps).punctualLights.size(), 17U);
}

}  // namespace
}  // namespace vct::test
