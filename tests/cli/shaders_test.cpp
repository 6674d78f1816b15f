// `vct shaders` writes the source of every program, in the form that glslang accepts for a phone, and a
// manifest.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/program_run.h"

namespace vct::test {
namespace {

TEST(Shaders, AreWrittenAndCountedForEveryPreset) {
    ProgramRun program;
    program.expectSuccess(std::string("shaders ") + ProgramRun::cornell + " --out out --size 32x32");
    const std::filesystem::path out = program.folder.file("out");
    const auto manifest = nlohmann::json::parse(readBytes((out / "manifest.json").string()));
    EXPECT_EQ(manifest.at("width"), 32);
    for (const auto& preset : manifest.at("presets")) {
        EXPECT_GT(preset.at("programs").size(), 10U);
        bool traced = false;
        for (const auto& entry : preset.at("programs")) {
            for (const auto& stage : entry.at("stages")) {
                const std::string text = readBytes((out / stage.at("file").get<std::string>()).string());
                EXPECT_EQ(text.rfind("#version 310 es\n", 0), 0U) << stage.at("file");
                EXPECT_EQ(text.find("#define mediump"), std::string::npos) << stage.at("file");
                EXPECT_EQ(text.find("#include \""), std::string::npos) << stage.at("file");
            }
            const auto& modes = entry.at("modes");
            traced |= entry.at("pass") == "trace" &&
                      std::find(modes.begin(), modes.end(), "gi-cone-shadow") != modes.end();
        }
        EXPECT_TRUE(traced) << preset.at("name");
        const auto& counts = preset.at("counts");
        EXPECT_EQ(counts.at("gi-cone-shadow").at("passes/shade.frag").at("invocations"), 32 * 32);
        EXPECT_FALSE(counts.at("phong").contains("packed/mipmapper.comp"));
    }
}

}  // namespace
}  // namespace vct::test
