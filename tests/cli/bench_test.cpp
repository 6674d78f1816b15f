// `vct bench` at a size that takes seconds writes the files that docs/timings.md describes.
#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

#include "cli/program_run.h"
#include "support/errors.h"

namespace vct::test {
namespace {

using nlohmann::json;

std::string benchOf(const std::string& scene, const std::string& options) {
    return "bench " + scene + " --size 16x16 --shadow-map 64 " + options;
}

std::vector<double> valuesOf(const json& table, const std::string& platform) {
    for (const json& row : table.at("rows"))
        if (row.at("platform") == platform) return row.at("values");
    throw std::runtime_error("no row " + platform);
}

TEST(Bench, PrintsEveryTableBesideThatOfTheThesis) {
    ProgramRun program;
    program.expectSuccess(benchOf(ProgramRun::cornell, "--repeat 1 --out out"));
    const json bench = program.json("out/bench.json");
    EXPECT_EQ(bench.at("version"), 1);
    for (const char* key : {"program", "scene", "triangles", "driver", "machine", "settings", "method"})
        EXPECT_TRUE(bench.contains(key)) << key;
    EXPECT_EQ(bench.at("measurements").size(), 11U);  // 5 modes, 3 at the smaller grid, 3 more angles
    const json& tables = bench.at("tables");
    ASSERT_EQ(tables.size(), 4U);
    for (const auto& [number, table] : tables.items())
        for (const json& row : table.at("rows"))
            EXPECT_EQ(row.at("values").size(), table.at("columns").size()) << number << " " << row;
    // Tot is the sum of the row, and (*) the same without V and M.
    const std::vector<double> stepsMs = valuesOf(tables.at("5.3"), "Here");
    EXPECT_NEAR(std::accumulate(stepsMs.begin(), stepsMs.end() - 1, 0.0), stepsMs.back(), 0.005);
    EXPECT_NEAR(valuesOf(tables.at("5.2"), "Here")[4], stepsMs.back(), 0.002);
    EXPECT_NEAR(valuesOf(tables.at("5.2"), "Here(*)")[4], stepsMs.back() - stepsMs[2] - stepsMs[3], 0.005);
    EXPECT_EQ(readBytes(program.folder.file("out/bench.txt")), program.out);
    expectMentions(program.out, {"Table 5.2", "Table 5.3", "Table 5.4", "Table 5.5", "Here(*)", "1076.49"});
}

TEST(Bench, ComparesPresetsAtTheirOwnGridsInTurns) {
    ProgramRun program;
    program.expectSuccess(benchOf(ProgramRun::cornell, "--preset thesis,mobile --repeat 2 --out out"));
    const json comparison = program.json("out/presets.json");
    EXPECT_EQ(comparison.at("version"), 1);
    EXPECT_EQ(comparison.at("method").at("processes"), 2);
    const json& thesis = comparison.at("presets").at(0);
    const json& mobile = comparison.at("presets").at(1);
    EXPECT_EQ(thesis.at("settings").at("grid"), 256);
    EXPECT_EQ(mobile.at("settings").at("grid"), 64);
    const json& ratios = comparison.at("ratios").at(0);
    EXPECT_EQ(ratios.at("of"), "thesis");
    EXPECT_EQ(ratios.at("over"), "mobile");
    EXPECT_NEAR(ratios.at("bytes"), thesis.at("bytes").get<double>() / mobile.at("bytes").get<double>(),
                5e-4);
    EXPECT_EQ(thesis.at("modes").size(), 5U);
    for (const auto& [mode, steps] : thesis.at("modes").items())
        for (const auto& [step, times] : steps.items()) {
            ASSERT_EQ(times.at("processes").size(), 2U);
            EXPECT_LE(times.at("min"), times.at("median"));
            EXPECT_LE(times.at("median"), times.at("max"));
            const double ms = mobile.at("modes").at(mode).at(step).at("median");
            const json& ratio = ratios.at("modes").at(mode).at(step);
            if (ms > 0.1 && times.at("median") > 0.1) {
                // Times and ratio are rounded to thousandths.
                EXPECT_NEAR(ratio, times.at("median").get<double>() / ms, 0.02 * ratio.get<double>() + 0.001)
                    << mode << " " << step;
            }
        }
    // The preset thesis has no irradiance, so there is no ratio.
    EXPECT_TRUE(ratios.at("modes").at("gi").at("irradiance").is_null());
    const std::size_t first = program.err.find("thesis, scenes 1 to 5, 256^3, run 1 of 2");
    const std::size_t second = program.err.find("mobile, scenes 1 to 5, 64^3, run 1 of 2");
    EXPECT_LT(first, second);
    EXPECT_LT(second, program.err.find("thesis, scenes 1 to 5, 256^3, run 2 of 2"));
    EXPECT_EQ(readBytes(program.folder.file("out/presets.txt")), program.out);
}

TEST(Bench, UsesTheGridThatIsAskedFor) {
    ProgramRun program;
    // The preset's own grid is 256.
    program.expectSuccess(benchOf(ProgramRun::cornell, "--preset thesis --grid 64 --repeat 1 --json b.json"));
    EXPECT_EQ(program.json("b.json").at("presets").at(0).at("settings").at("grid"), 64);
}

TEST(Bench, MeasuresUnderTheSameSkyAsRender) {
    ProgramRun program;
    const std::string patio = VCT_SOURCE_DIR "/assets/patio";
    const std::string sky = " --preset mobile --environment " + patio + ".hdr ";
    program.expectSuccess(benchOf(patio + ".glb", sky + "--repeat 1 --out under"));
    EXPECT_EQ(program.json("under/presets.json").at("presets")[0].at("settings").at("sky"), "picture");
    program.expectSuccess(
        "render " + patio + ".glb" + sky +
        "--size 16x16 --samples 1 --shadow-map 64 --mode phong --out render --tone-map none --exposure 1");
    EXPECT_EQ(readBytes(program.folder.file("under/phong.png")),
              readBytes(program.folder.file("render/phong.png")));
}

}  // namespace
}  // namespace vct::test
