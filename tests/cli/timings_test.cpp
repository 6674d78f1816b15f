// timings.json has the fields that docs/timings.md describes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "cli/program_run.h"
#include "support/errors.h"

namespace vct::test {
namespace {

using nlohmann::json;

constexpr std::array stepNames{"shadow_map", "render_data", "voxelize", "inject",
                               "mipmap",     "irradiance",  "trace"};
constexpr std::size_t frameCount = 5;

// Each step and the total have a sample for each frame, and the total is the sum of the steps.
void expectSteps(const json& steps) {
    ASSERT_EQ(steps.size(), stepNames.size() + 1);
    std::vector<double> sums(frameCount);
    for (const auto& [name, step] : steps.items()) {
        std::vector<double> samples = step.at("samples");
        ASSERT_EQ(samples.size(), frameCount) << name;
        for (std::size_t frame = 0; frame < frameCount; ++frame)
            sums[frame] += name == "total" ? -samples[frame] : samples[frame];
        std::sort(samples.begin(), samples.end());
        EXPECT_EQ(step.at("min"), samples.front()) << name;
        EXPECT_EQ(step.at("max"), samples.back()) << name;
        EXPECT_EQ(step.at("median"), samples[frameCount / 2]) << name;
    }
    for (const double sum : sums)
        EXPECT_NEAR(sum, 0.0, 0.0035);  // each number is rounded to a microsecond
}

TEST(Timings, HaveTheFieldsThatDocsTimingsMdPromises) {
    ProgramRun program;
    program.expectSuccess(std::string("render ") + ProgramRun::cornell +
                          " --preset thesis --grid 64 --size 64x64 --out out --timings t.json --revoxelize"
                          " --mode gi-cone-shadow");
    const json timings = program.json("t.json");
    EXPECT_EQ(timings.at("version"), 4);
    EXPECT_TRUE(timings.at("program").is_string());
    EXPECT_TRUE(timings.at("scene").is_string());
    EXPECT_EQ(timings.at("triangles"), 1298);
    for (const char* text : {"backend", "vendor", "renderer", "version"})
        EXPECT_FALSE(timings.at("driver").at(text).get<std::string>().empty()) << text;
    for (const char* text : {"cpu", "system"})
        EXPECT_FALSE(timings.at("machine").at(text).get<std::string>().empty()) << text;
    EXPECT_GE(timings.at("machine").at("threads").get<int>(), 1);
    const json settings = {{"preset", "thesis"}, {"grid", 64},        {"width", 64},
                           {"height", 64},       {"shadow_map", 512}, {"cone_angle_deg", 5.0}};
    for (const auto& [key, value] : settings.items())
        EXPECT_EQ(timings.at("settings").at(key), value) << key;
    const json method = {{"warm_up_frames", 2}, {"frames", frameCount}, {"revoxelized_every_frame", true}};
    for (const auto& [key, value] : method.items())
        EXPECT_EQ(timings.at("method").at(key), value) << key;
    EXPECT_TRUE(timings.at("method").at("clock").is_string());
    ASSERT_FALSE(timings.at("resources").empty());
    for (const json& resource : timings.at("resources"))
        EXPECT_GT(resource.at("bytes").get<long long>(), 0) << resource.at("name");
    ASSERT_EQ(timings.at("modes").size(), 1U);
    const json& steps = timings.at("modes").at("gi-cone-shadow").at("steps");
    expectSteps(steps);
    for (const std::string step : stepNames) {
        const bool isOfThesis = step != "irradiance" && step != "inject";
        EXPECT_EQ(steps.at(step).at("min").get<double>() > 0.0, isOfThesis) << step;
    }
    // RGBA8, RG16UI and a 32-bit depth, as the scene has no emission.
    EXPECT_EQ(timings.at("g_buffer_bytes_per_pixel"), 12);
    const std::vector<long long> active = timings.at("active_voxels");
    ASSERT_EQ(active.size(), 7U);  // 64, 32, 16, 8, 4, 2, 1
    EXPECT_EQ(active.back(), 1);
}

TEST(Timings, StepsThatAFrameSkipsTakeNoTime) {
    ProgramRun program;
    program.expectSuccess(std::string("render ") + ProgramRun::cornell +
                          " --preset mobile --size 64x64 --light-frames 2 --out out --timings t.json");
    const json timings = program.json("t.json");
    EXPECT_EQ(timings.at("method").at("revoxelized_every_frame"), false);
    expectMentions(program.err, {"--revoxelize"});
    const json& steps = timings.at("modes").at("gi-cone-shadow").at("steps");
    expectSteps(steps);
    for (const std::string step : stepNames) {
        const bool isInEveryFrame = step == "render_data" || step == "trace";
        EXPECT_EQ(steps.at(step).at("max").get<double>() > 0.0, isInEveryFrame) << step;
    }
}

}  // namespace
}  // namespace vct::test
