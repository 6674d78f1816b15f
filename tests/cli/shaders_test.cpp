// vct shaders: every source of the manifest is there and is what glslang takes for a phone.
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/program_run.h"

namespace vct::test {
namespace {

TEST(Shaders, OfEveryPresetAreWrittenAndCounted) {
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

TEST(Shaders, CameraAndGridAreThoseThatAreAskedFor) {
    const auto counts = [](const std::string& options) {
        ProgramRun program;
        program.expectSuccess(std::string("shaders ") + ProgramRun::cornell +
                              " --out out --size 16x16 --preset mobile" + options);
        return nlohmann::json::parse(readBytes(program.folder.file("out/manifest.json"))).at("presets").at(0);
    };
    const auto usual = counts(""), asked = counts(" --grid 128 --camera eye=0,0,3,target=0,9,3");
    EXPECT_EQ(usual.at("grid"), 64);
    EXPECT_EQ(asked.at("grid"), 128);
    const auto seesSomething = [](const auto& preset) {
        return preset.at("counts").at("gi").contains("passes/g_buffer.frag");
    };
    EXPECT_TRUE(seesSomething(usual));
    EXPECT_FALSE(seesSomething(asked)) << "it looks away from the scene";
}

}  // namespace
}  // namespace vct::test
