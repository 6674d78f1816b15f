// `vct bench` at a size that takes seconds: its file as docs/timings.md promises it, and what it leaves
// behind.
#include <gtest/gtest.h>

#include <numeric>
#include <stdexcept>

#include "cli/program_run.h"

namespace vct::test {
namespace {

using nlohmann::json;

const json& row(const json& table, const std::string& platform) {
    for (const json& candidate : table.at("rows"))
        if (candidate.at("platform") == platform) return candidate;
    throw std::runtime_error("no row " + platform);
}

double value(const json& table, const std::string& platform, std::size_t column) {
    return row(table, platform).at("values").at(column);
}

TEST(Bench, MeasuresEveryTableBesideTheThesis) {
    ProgramRun program;
    ASSERT_EQ(program.run(std::string("bench ") + ProgramRun::cornell +
                          " --repeat 1 --size 16x16 --shadow-map 64 --out out"),
              0)
        << program.err;
    const json bench = program.json("out/bench.json");
    EXPECT_EQ(bench.at("version"), 1);
    for (const char* key : {"program", "scene", "triangles", "driver", "machine", "settings", "method"})
        EXPECT_TRUE(bench.contains(key)) << key;
    EXPECT_EQ(bench.at("method").at("processes"), 1);
    EXPECT_EQ(bench.at("measurements").size(), 11U);  // 5 modes, 3 at the smaller grid, 3 more angles

    const json& tables = bench.at("tables");
    ASSERT_EQ(tables.size(), 4U);
    for (const auto& [number, table] : tables.items())
        for (const json& entry : table.at("rows")) {
            const bool measured = entry.at("source") == "measured";
            EXPECT_EQ(entry.at("platform").get<std::string>().rfind("Here", 0) == 0, measured);
            for (const char* key : {"values", "min", "max"}) {
                if (!measured && std::string(key) != "values") continue;
                ASSERT_EQ(entry.at(key).size(), table.at("columns").size()) << number << " " << entry;
                for (const json& ms : entry.at(key))
                    EXPECT_GE(ms.get<double>(), 0.0) << number << " " << entry;
            }
        }

    // Tot is the row's sum, and (*) what is left of it without V and M.
    const std::vector<double> stepsMs = row(tables.at("5.3"), "Here").at("values");
    EXPECT_NEAR(std::accumulate(stepsMs.begin(), stepsMs.end() - 1, 0.0), stepsMs.back(), 0.005);
    EXPECT_NEAR(value(tables.at("5.2"), "Here", 4), stepsMs.back(), 0.002);
    EXPECT_NEAR(value(tables.at("5.2"), "Here(*)", 4), stepsMs.back() - stepsMs[2] - stepsMs[3], 0.005);
    EXPECT_EQ(value(tables.at("5.2"), "Here(*)", 0), value(tables.at("5.2"), "Here", 0));
    EXPECT_EQ(value(tables.at("5.4"), "Here", 2), value(tables.at("5.2"), "Here(*)", 4));
    EXPECT_EQ(value(tables.at("5.5"), "Here", 9), stepsMs[4]);

    // The thesis's printed tables are consistent too: a misprint here would show.
    for (const char* platform : {"Mobile", "Laptop", "Desktop"}) {
        const std::vector<double> printed = row(tables.at("5.3"), platform).at("values");
        EXPECT_NEAR(std::accumulate(printed.begin(), printed.end() - 1, 0.0), printed.back(), 0.011)
            << platform;
        EXPECT_EQ(value(tables.at("5.2"), platform, 4), printed.back());
        EXPECT_NEAR(value(tables.at("5.2"), platform + std::string("(*)"), 4),
                    printed.back() - printed[2] - printed[3], 0.011);
    }

    EXPECT_EQ(readBytes(program.folder.file("out/bench.txt")), program.out);
    for (const char* text : {"Table 5.2", "Table 5.3", "Table 5.4", "Table 5.5", "Here(*)", "1076.49"})
        EXPECT_NE(program.out.find(text), std::string::npos) << text;
    EXPECT_EQ(program.temporary.list(), std::vector<std::string>{});
}

TEST(Bench, AFailedProcessIsNamedWithWhatItSaid) {
    ProgramRun program;
    EXPECT_EQ(program.run("bench none.glb --out out"), 1);
    const std::string error = program.err.substr(program.err.find("vct: error: "));
    EXPECT_EQ(lineCount(error), 1) << error;
    for (const char* text : {"scenes 1 to 5, 256^3, 5 degrees, run 1 of 3", "none.glb", "no such file"})
        EXPECT_NE(error.find(text), std::string::npos) << error;
    EXPECT_EQ(program.folder.list(), std::vector<std::string>{});
    EXPECT_EQ(program.temporary.list(), std::vector<std::string>{});
}

}  // namespace
}  // namespace vct::test
