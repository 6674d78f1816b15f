// Includes, #line, and messages that point home; and every variant through glslang, as ES.
#include "gl/shader_source.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>

#include "app/app_programs.h"
#include "engine/programs.h"
#include "gl/program.h"
#include "lab/program_list.h"
#include "platform/platform.h"
#include "support/errors.h"
#include "support/renderers.h"
#include "support/temporary_folder.h"

namespace vct::test {
namespace {

gl::ReadShader files(std::map<std::string, std::string> contents) {
    return [contents](const std::string& path) {
        const auto found = contents.find(path);
        if (found == contents.end()) throw Error("no " + path);
        return found->second;
    };
}

TEST(ShaderSource, MissingIncludeNamesTheFileAndLineThatAsksForIt) {
    const auto read = files({{"a.frag", "one\n#include \"missing.glsl\"\n"}});
    expectMentions(errorOf([&] { gl::assembleShader(read, "a.frag", {}, gl::Language::essl320); }),
                   {"a.frag:2", "missing.glsl"});
}

TEST(ShaderSource, PointsMessagesOfThreeVendorsHome) {
    const std::vector<std::string> names{"a.frag", "shared/b.glsl"};
    EXPECT_EQ(gl::locateInFiles("1:35(12): error: x", names), "shaders/shared/b.glsl:35: error: x\n");
    EXPECT_EQ(gl::locateInFiles("1(35) : error C1: x", names), "shaders/shared/b.glsl:35: error C1: x\n");
    EXPECT_EQ(gl::locateInFiles("ERROR: 0:7: 'x' : y", names), "ERROR: shaders/a.frag:7: 'x' : y\n");
    EXPECT_EQ(gl::locateInFiles("9:1: unknown file", names), "9:1: unknown file\n");
}

TEST(ShaderSource, CompilerErrorPointsIntoTheIncludedFile) {
    const Context context = openContext(Backend::egl);
    const auto read =
        files({{"a.vert", "#include \"b.glsl\"\nvoid main() { gl_Position = vec4(broken()); }\n"},
               {"b.glsl", "float good() { return 1.0; }\nfloat broken() { return nonsense; }\n"},
               {"a.frag", "void main() {}\n"}});
    const gl::ShaderLibrary library{read, context.capabilities.language()};
    expectMentions(errorOf([&] { gl::Program(library, {"test", {"a.vert", "a.frag"}, {}}); }),
                   {"shaders/b.glsl:2"});
}

struct Source {
    std::string path, text, program;
};

// Runs glslangValidator once over all of them, as it takes longer to start than to check one; returns its
// output where it refuses any.
std::string glslang(const std::vector<Source>& sources) {
    const TemporaryFolder folder, said;
    for (std::size_t i = 0; i < sources.size(); ++i)
        writeBytes(
            folder.file(std::to_string(i) + "_" + std::filesystem::path(sources[i].path).filename().string()),
            sources[i].text);
    const std::string command = "glslangValidator " + folder.path() + "/* > " + said.file("out") + " 2>&1";
    return std::system(command.c_str()) == 0 ? "" : readBytes(said.file("out"));
}

void expectAccepted(const std::vector<Source>& sources) {
    if (glslang(sources).empty()) return;
    for (const Source& source : sources)
        EXPECT_EQ(glslang({source}), "") << source.path << " for " << source.program;
}

// Every program of the renderer and of the app.
std::vector<gl::ProgramDescription> allPrograms() {
    std::vector<gl::ProgramDescription> programs = everyProgram();
    programs.insert(programs.end(),
                    {app::toneMapProgram(), app::smoothProgram(), app::scaleProgram(), app::hudProgram()});
    return programs;
}

class Glslang : public testing::TestWithParam<gl::Language> {};
INSTANTIATE_TEST_SUITE_P(Versions, Glslang, testing::Values(gl::Language::essl310, gl::Language::essl320),
                         [](const auto& test) {
                             return test.param == gl::Language::essl320 ? "Es320" : "Es310";
                         });

TEST_P(Glslang, AcceptsEveryShader) {
    ASSERT_EQ(std::system("glslangValidator --version > /dev/null 2>&1"), 0)
        << "glslangValidator is missing; scripts/setup.sh installs it";
    // The versions differ at the head of a file, so one variant of each file serves the other version.
    const bool isEveryVariant = GetParam() == gl::Language::essl310;
    std::set<std::string> seen;
    std::vector<Source> sources;
    bool hasCascades = false, hasSoftLights = false;
    const auto add = [&](const gl::ProgramDescription& program, std::vector<std::string> defines) {
        defines.insert(defines.end(), program.defines.begin(), program.defines.end());
        for (const std::string& path : program.shaders) {
            const gl::AssembledShader source = gl::assembleShader(testShaders(), path, defines, GetParam());
            if (seen.insert(isEveryVariant ? path + source.text : path).second)
                sources.push_back({path, source.text, program.name});
        }
    };
    for (const gl::ProgramDescription& program : allPrograms()) {
        add(program, {});
        hasSoftLights |= std::count(program.defines.begin(), program.defines.end(), "VCT_SOFT_LIGHTS") > 0;
        // Programs of directional voxels differ with cascades.
        const std::string& last = program.shaders.back();
        if (!isEveryVariant || last.rfind("directional/", 0) != 0) continue;
        add(program, {"VCT_CASCADES 3"});
        hasCascades = true;
    }
    EXPECT_TRUE(hasSoftLights);
    EXPECT_EQ(hasCascades, isEveryVariant);
    EXPECT_GT(sources.size(), 60U);
    expectAccepted(sources);
}

// The head-up display says what is missing on drivers that have no more than ES 3.0.
TEST(ShaderSource, GlslangAcceptsTheDisplaysShadersInEs300) {
    for (const std::string& path : app::hudProgram().shaders) {
        const gl::AssembledShader source =
            gl::assembleShader(testShaders(), path, app::hudProgram().defines, gl::Language::essl300);
        EXPECT_EQ(source.text.rfind("#version 300 es\n", 0), 0U);
        expectAccepted({{path, source.text, app::hudProgram().name}});
    }
}

}  // namespace
}  // namespace vct::test
