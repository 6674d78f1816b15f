// Log, progress, times and compiled programs, through include/vct/vct.h.
#include <map>

#include "api/described_scene.h"
#include "gl/program_binary.h"
#include "image/compare.h"
#include "support/errors.h"

namespace vct::test {
namespace {

TEST_F(Embedded, TellsProgramsAndStepsOfLight) {
    std::vector<std::string> messages;
    std::vector<Progress> reports;
    Options options = optionsOf("mobile");
    options.log = [&](const std::string& message) { messages.push_back(message); };
    options.progress = [&](const Progress& progress) { reports.push_back(progress); };
    GlobalIllumination light(getProcAddress, described_.scene, options);
    ASSERT_GE(messages.size(), 2U);
    expectMentions(messages[0], {"OpenGL ES"});
    expectMentions(messages[1], {"grid 64: voxels of"});
    light.render(described_.view());
    EXPECT_GT(reports.size(), 10U);
    EXPECT_EQ(reports.front().part, "programs");
    EXPECT_EQ(reports.back().done, static_cast<int>(reports.size()));
    expectMentions(messages.back(), {"compiled the program ", " ms"});
    const Progress first = light.lightProgress();
    EXPECT_EQ(first.part, "light");
    EXPECT_EQ(first.done, 1);
    EXPECT_GT(first.total, 100);
    reports.clear();
    light.render(described_.view(), GlobalIllumination::Light::converged);
    ASSERT_GT(reports.size(), 100U);
    EXPECT_EQ(reports.back().part, "light");
    EXPECT_EQ(reports.back().done, reports.back().total);
    reports.clear();
    light.render(described_.view(), GlobalIllumination::Light::converged);
    EXPECT_TRUE(reports.empty()) << "nothing has changed";
    EXPECT_EQ(light.lightProgress().done, first.total);
    light.setSun({0.2, 1.0, 0.4});
    light.render(described_.view());
    EXPECT_EQ(light.lightProgress().done, 1);
}

TEST_F(Embedded, StartsWithProgramsThatWereStored) {
    if (!gl::hasProgramBinaries()) GTEST_SKIP() << "this driver cannot return compiled programs";
    std::map<std::string, std::vector<std::uint8_t>> stored;
    int compiled = 0, loaded = 0;
    Options options = optionsOf("mobile");
    options.loadProgram = [&](const std::string& key) { return stored[key]; };
    options.storeProgram = [&](const std::string& key, std::span<const std::uint8_t> program) {
        stored[key].assign(program.begin(), program.end());
    };
    options.log = [&](const std::string& message) {
        compiled += message.starts_with("compiled") ? 1 : 0;
        loaded += message.starts_with("loaded") ? 1 : 0;
    };
    const auto shown = [&] {
        compiled = loaded = 0;
        GlobalIllumination light(getProcAddress, described_.scene, options);
        return imageOf(light.render(described_.view()).radiance);
    };
    const Image first = shown();
    const int programs = compiled;
    EXPECT_EQ(loaded, 0);
    const Image second = shown();
    EXPECT_EQ(compiled, 0);
    EXPECT_EQ(loaded, programs);
    EXPECT_LE(compareImages(second, first, 0.04F).fraction, 0.01);
    // Cut off, changed and lost.
    stored.begin()->second.pop_back();
    std::next(stored.begin())->second.back() ^= 1U;
    std::next(stored.begin(), 2)->second.clear();
    const Image third = shown();
    EXPECT_EQ(compiled, 3);
    EXPECT_LE(compareImages(third, first, 0.04F).fraction, 0.01);
}

TEST_F(Embedded, MeasuresStepsAndKeepsTheLightForASecondView) {
    Options options = optionsOf("mobile");
    options.ambientVisibility = false;  // it takes turns with light in one texture
    GlobalIllumination light(getProcAddress, described_.scene, options);
    light.render(described_.view());
    EXPECT_TRUE(light.stepTimes().empty());
    light.measureSteps(true);
    const auto milliseconds = [&](const std::string& step) {
        for (const StepTime& time : light.stepTimes())
            if (time.step == step) return time.milliseconds;
        ADD_FAILURE() << "there is no step " << step;
        return 0.0;
    };
    using Light = GlobalIllumination::Light;
    const Image first = imageOf(light.render(described_.view()).radiance);
    EXPECT_GT(milliseconds("trace"), 0.0);
    EXPECT_GT(milliseconds("irradiance"), 0.0);
    View other = described_.view();
    other.cameraFromWorld.columns[12] += 0.05;
    light.render(other, Light::keep);
    EXPECT_GT(milliseconds("trace"), 0.0);
    EXPECT_EQ(milliseconds("irradiance"), 0.0);
    const Image again = imageOf(light.render(described_.view(), Light::keep).radiance);
    EXPECT_LE(compareImages(again, first, 0.001F).fraction, 0.0);
    light.measureSteps(false);
    light.render(described_.view());
    EXPECT_TRUE(light.stepTimes().empty());
    // Without light, it takes a step.
    GlobalIllumination fresh(getProcAddress, described_.scene, optionsOf("mobile"));
    EXPECT_GT(compareImages(imageOf(fresh.render(described_.view(), Light::keep).radiance),
                            Image(width, height), 0.04F)
                  .fraction,
              0.5);
}

}  // namespace
}  // namespace vct::test
