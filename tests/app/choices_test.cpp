// Choices from the text of an intent.
#include "app/choices.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "lab/bench_run.h"

namespace vct::app {
namespace {

// The grid of another preset may be too large for a phone.
TEST(Choices, APresetBringsItsOwnGrid) {
    Choices choices;
    choosePreset(choices, "mobile");
    EXPECT_EQ(choices.preset, "mobile");
    EXPECT_EQ(choices.grid, presetSettings("mobile").grid);
    EXPECT_NE(choices.grid, presetSettings("thesis").grid);
    EXPECT_THROW(choosePreset(choices, "best"), Error);
    EXPECT_EQ(choices.preset, "mobile");
}

TEST(Choices, AGridInWordsStandsOverThePresets) {
    EXPECT_EQ(showRequestFromText("show preset=mobile").choices.grid, presetSettings("mobile").grid);
    EXPECT_EQ(showRequestFromText("show preset=mobile grid=128").choices.grid, 128);
    EXPECT_EQ(showRequestFromText("show grid=128 preset=mobile").choices.grid, 128);
    EXPECT_THROW(showRequestFromText("show grid=100"), Error);
}

// The number of cascades follows the scene unless it is given.
TEST(Choices, LargeScenesHaveCascadesForVoxelsAsNarrowAsWalls) {
    const auto cascadesOf = [](double metres, const std::string& preset) {
        Scene scene;
        scene.boundsWorld = {glm::dvec3(0.0), glm::dvec3(metres, 10.0, 5.0)};
        return cascadesFor(scene, presetSettings(preset));
    };
    EXPECT_EQ(cascadesOf(12.0, "mobile"), 1);
    EXPECT_EQ(cascadesOf(24.0, "mobile"), 2);
    EXPECT_EQ(cascadesOf(100.0, "mobile"), 4);
    EXPECT_EQ(cascadesOf(1e6, "mobile"), maxCascadesFor(presetSettings("mobile").grid));
    EXPECT_LT(cascadesOf(100.0, "quality"), 4);
    EXPECT_EQ(cascadesOf(100.0, "thesis"), 1);
    EXPECT_EQ(showRequestFromText("show cascades=3 preset=mobile").choices.cascades, 3);
    EXPECT_FALSE(showRequestFromText("show preset=mobile cascades=auto").choices.cascades);
    EXPECT_THROW(showRequestFromText("show preset=mobile cascades=0"), Error);
    EXPECT_THROW(showRequestFromText("show preset=mobile grid=256 cascades=4"), Error);
    Choices choices = showRequestFromText("show cascades=3 preset=mobile").choices;
    choosePreset(choices, "thesis");
    EXPECT_FALSE(choices.cascades);
}

TEST(Choices, ValuesMayContainSpaces) {
    const ShowRequest request = showRequestFromText("show scene=my new  room.glb  grid=64 ");
    EXPECT_EQ(request.scene, "my new  room.glb");
    EXPECT_EQ(request.choices.grid, 64);
    EXPECT_EQ(benchRequestFromText("bench grid=64 scene=my room.glb").scene, "my room.glb");
    EXPECT_THROW(showRequestFromText("show room grid=64"), Error);
    EXPECT_THROW(showRequestFromText("show grid=64 room"), Error);
}

}  // namespace
}  // namespace vct::app
