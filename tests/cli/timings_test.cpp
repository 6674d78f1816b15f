// timings.json as docs/timings.md promises it.
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

std::string renderSmall(const std::string& options) {
    return std::string("render ") + ProgramRun::cornell +
           " --preset thesis --grid 64 --size 64x64 --out out --timings t.json --revoxelize " + options;
}

void expectSpread(const json& step) {
    ASSERT_EQ(step.at("samples").size(), frameCount);
    std::vector<double> samples = step.at("samples");
    std::sort(samples.begin(), samples.end());
    EXPECT_GE(samples.front(), 0.0);
    EXPECT_EQ(step.at("min"), samples.front());
    EXPECT_EQ(step.at("max"), samples.back());
    EXPECT_EQ(step.at("median"), samples[frameCount / 2]);
}

void expectSteps(const json& object) {
    ASSERT_EQ(object.size(), stepNames.size() + 1);
    for (const char* step : stepNames)
        expectSpread(object.at(step));
    expectSpread(object.at("total"));
    for (std::size_t frame = 0; frame < frameCount; ++frame) {
        double sum = 0.0;
        for (const char* step : stepNames)
            sum += object.at(step).at("samples").at(frame).get<double>();
        // Each number is rounded to a microsecond.
        EXPECT_NEAR(object.at("total").at("samples").at(frame).get<double>(), sum, 0.0035);
    }
}

void expectCommonFields(const json& timings) {
    EXPECT_EQ(timings.at("version"), 4);
    for (const char* text : {"program", "scene"})
        EXPECT_TRUE(timings.at(text).is_string()) << text;
    EXPECT_EQ(timings.at("triangles"), 1298);
    for (const char* text : {"backend", "vendor", "renderer", "version"})
        EXPECT_FALSE(timings.at("driver").at(text).get<std::string>().empty()) << text;
    for (const char* text : {"cpu", "system"})
        EXPECT_FALSE(timings.at("machine").at(text).get<std::string>().empty()) << text;
    EXPECT_GE(timings.at("machine").at("threads").get<int>(), 1);
    const json& settings = timings.at("settings");
    EXPECT_EQ(settings.at("preset"), "thesis");
    EXPECT_EQ(settings.at("grid"), 64);
    EXPECT_EQ(settings.at("width"), 64);
    EXPECT_EQ(settings.at("height"), 64);
    EXPECT_EQ(settings.at("shadow_map"), 512);
    EXPECT_EQ(settings.at("cone_angle_deg"), 5.0);
    EXPECT_EQ(settings.at("shadow"), "cone");
    EXPECT_NEAR(settings.at("ao_distance").get<double>(), 0.045, 1e-6);
    const json& method = timings.at("method");
    EXPECT_TRUE(method.at("clock").is_string());
    EXPECT_EQ(method.at("warm_up_frames"), 2);
    EXPECT_EQ(method.at("frames"), frameCount);
    EXPECT_EQ(method.at("revoxelized_every_frame"), true);
    ASSERT_FALSE(timings.at("resources").empty());
    for (const json& resource : timings.at("resources")) {
        EXPECT_TRUE(resource.at("name").is_string());
        EXPECT_GT(resource.at("bytes").get<long long>(), 0) << resource.at("name");
    }
}

TEST(Timings, HaveTheFieldsThatDocsTimingsMdPromises) {
    ProgramRun program;
    program.expectSuccess(renderSmall("--mode gi-cone-shadow"));
    const json timings = program.json("t.json");
    expectCommonFields(timings);
    ASSERT_EQ(timings.at("modes").size(), 1U);
    const json& steps = timings.at("modes").at("gi-cone-shadow").at("steps");
    expectSteps(steps);
    for (const std::string step : stepNames)
        if (step == "irradiance" || step == "inject")  // the preset thesis has neither
            EXPECT_EQ(steps.at(step).at("max").get<double>(), 0.0);
        else
            EXPECT_GT(steps.at(step).at("min").get<double>(), 0.0) << step;

    // RGBA8, RG16UI, a 32-bit depth; the scene does not emit.
    EXPECT_EQ(timings.at("g_buffer_bytes_per_pixel"), 12);
    const std::vector<long long> active = timings.at("active_voxels");
    ASSERT_EQ(active.size(), 7U);  // 64, 32, 16, 8, 4, 2, 1
    for (std::size_t level = 1; level < active.size(); ++level)
        EXPECT_LT(active[level], active[level - 1]);
    EXPECT_EQ(active.back(), 1);
}

TEST(Timings, StepsThatAFrameSkipsTakeNoTime) {
    ProgramRun program;
    program.expectSuccess(std::string("render ") + ProgramRun::cornell +
                          " --preset mobile --size 64x64 --out out --timings t.json");
    const json timings = program.json("t.json");
    EXPECT_EQ(timings.at("method").at("revoxelized_every_frame"), false);
    expectMentions(program.err, {"--revoxelize times them too"});
    const json& steps = timings.at("modes").at("gi-cone-shadow").at("steps");
    expectSteps(steps);
    for (const std::string step : stepNames) {
        const bool everyFrame = step == "render_data" || step == "trace";
        EXPECT_EQ(steps.at(step).at("max").get<double>() > 0.0, everyFrame) << step;
    }
}

}  // namespace
}  // namespace vct::test
