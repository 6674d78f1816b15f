// `vct shaders` writes the source of every program, in the form that glslang accepts for a phone, and a
// manifest.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/program_run.h"
#include "support/errors.h"

namespace vct::test {
namespace {

TEST(Shaders, AreWrittenAndCountedForEveryPreset) {
    ProgramRun program;
    program.expectSuccess(std::string("shaders ") + ProgramRun::cornell +
                          " --out out --size 32x32 --grid 64");
    const std::filesystem::path out = program.folder.file("out");
    const auto manifest = nlohmann::json::parse(readBytes((out / "manifest.json").string()));
    EXPECT_EQ(manifest.at("width"), 32);
    for (const auto& preset : manifest.at("presets")) {
        EXPECT_GT(preset.at("programs").size(), 9U);
        bool traced = false;
        const std::string name = preset.at("name");
        EXPECT_NE(program.err.find(" programs into out/" + name + "\n"), std::string::npos) << program.err;
        for (const auto& entry : preset.at("programs")) {
            for (const auto& stage : entry.at("stages")) {
                // The folder has the program's name; what is no letter or digit there is a dash.
                const std::string file = stage.at("file"), called = entry.at("name");
                const std::string last = called.substr(called.find_last_of('/') + 1);
                EXPECT_NE(file.find("-" + last.substr(0, last.find_first_of(" ,"))), std::string::npos)
                    << file;
                const std::string text = readBytes((out / stage.at("file").get<std::string>()).string());
                EXPECT_EQ(text.rfind("#version 310 es\n", 0), 0U) << stage.at("file");
                EXPECT_EQ(text.find("#define mediump"), std::string::npos) << stage.at("file");
                EXPECT_EQ(text.find("#include \""), std::string::npos) << stage.at("file");
                // `eval.py mali` needs the count of each fragment and compute shader that a mode runs.
                const std::string shader = stage.at("shader");
                if (stage.at("stage") == "vertex" || stage.at("stage") == "geometry") continue;
                for (const std::string mode : entry.at("modes")) {
                    const auto& count = entry.at("counts").at(mode);
                    EXPECT_EQ(count.at("shader"), shader);
                    EXPECT_GT(count.at("invocations"), 0);
                    if (shader == "passes/shade.frag" || shader == "packed/shade.frag") {
                        EXPECT_EQ(count.at("invocations"), 32 * 32);
                    }
                }
                const auto& run = entry.at("modes");
                if (shader == "packed/mipmapper.comp") {
                    EXPECT_EQ(std::count(run.begin(), run.end(), "phong"), 0);
                }
            }
            const auto& modes = entry.at("modes");
            traced |= entry.at("pass") == "trace" &&
                      std::find(modes.begin(), modes.end(), "gi-cone-shadow") != modes.end();
        }
        EXPECT_TRUE(traced) << preset.at("name");
    }
}

// Lights, reflections, a figure that bends and cascades run programs of their own. A program that the list of
// a frame lacks is an error.
TEST(Shaders, OfEveryKindOfSceneAreInTheList) {
    ProgramRun program;
    for (const std::string arguments : {"glossy.glb' --cascades 2", "walker.glb'"})
        program.expectSuccess("shaders '" VCT_SOURCE_DIR "/assets/" + arguments +
                              " --out out --size 24x24 --grid 64 --preset mobile");
}

// The passes of the programs that the frames of a mode run.
std::set<std::string> passes(const std::string& manifest, const std::string& mode) {
    std::set<std::string> found;
    const nlohmann::json document = nlohmann::json::parse(readBytes(manifest));
    for (const auto& entry : document.at("presets").at(0).at("programs")) {
        const auto& modes = entry.at("modes");
        if (std::find(modes.begin(), modes.end(), mode) != modes.end()) found.insert(entry.at("pass"));
    }
    return found;
}

TEST(Shaders, OfAFrameInWhichOnlyTheLightOrObjectsChange) {
    ProgramRun program;
    const std::string scene =
        "shaders '" VCT_SOURCE_DIR "/assets/moving.glb' --out out --size 24x24 --grid 64 --preset mobile";
    const std::set<std::string> light{"render_data", "shadow_map", "inject", "irradiance", "trace"};
    program.expectSuccess(scene + " --changes light");
    EXPECT_EQ(passes(program.folder.file("out/manifest.json"), "gi"), light);
    program.expectSuccess(scene + " --changes objects");
    std::set<std::string> objects = light;
    objects.insert("voxelize");
    EXPECT_EQ(passes(program.folder.file("out/manifest.json"), "gi"), objects);
    EXPECT_NE(program.run(std::string("shaders ") + ProgramRun::cornell + " --out out --changes objects"), 0);
    expectMentions(program.err, {"--changes objects", "no animation moves an object"});
}

}  // namespace
}  // namespace vct::test
