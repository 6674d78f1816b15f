// Includes, #line, and messages that point home; and every variant through glslang, as ES.
#include "gl/shader_source.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "app/app_programs.h"
#include "engine/programs.h"
#include "gl/program.h"
#include "lab/program_list.h"
#include "platform/platform.h"
#include "support/errors.h"
#include "support/renderers.h"

namespace vct::test {
namespace {

gl::ReadShader files(std::map<std::string, std::string> contents) {
    return [contents](const std::string& path) {
        const auto found = contents.find(path);
        if (found == contents.end()) throw Error("no " + path);
        return found->second;
    };
}

TEST(ShaderSource, IncludesEachFileOnceAndKeepsLineNumbers) {
    const auto read =
        files({{"a.frag", "one\n#include \"b.glsl\"\n#include \"b.glsl\"\ntwo\n"}, {"b.glsl", "three\n"}});
    const gl::AssembledShader source = gl::assembleShader(read, "a.frag", {"X 1"}, gl::Language::essl320);
    EXPECT_EQ(source.files, (std::vector<std::string>{"a.frag", "b.glsl"}));
    EXPECT_EQ(source.text.rfind("#version 320 es\n", 0), 0U);
    const std::string body = source.text.substr(source.text.find("#define X 1"));
    EXPECT_EQ(body, "#define X 1\n#line 1 0\none\n#line 1 1\nthree\n#line 3 0\n#line 4 0\ntwo\n");
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
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("vct_glslang_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    for (std::size_t i = 0; i < sources.size(); ++i)
        std::ofstream(folder /
                      (std::to_string(i) + "_" + std::filesystem::path(sources[i].path).filename().string()))
            << sources[i].text;
    FILE* pipe = popen(("glslangValidator " + folder.string() + "/* 2>&1").c_str(), "r");
    std::string output;
    char buffer[512];
    while (fgets(buffer, sizeof buffer, pipe) != nullptr)
        output += buffer;
    const int status = pclose(pipe);
    std::filesystem::remove_all(folder);
    return status == 0 ? "" : output + " (status " + std::to_string(status) + ")";
}

void expectAccepted(const std::vector<Source>& sources) {
    if (glslang(sources).empty()) return;
    for (const Source& source : sources)
        EXPECT_EQ(glslang({source}), "") << source.path << " for " << source.program;
}

// Every program of the renderer and of the app.
std::vector<gl::ProgramDescription> allPrograms() {
    std::vector<gl::ProgramDescription> programs = everyProgram();
    programs.insert(programs.end(), {app::presentProgram(), app::hudProgram()});
    return programs;
}

class Glslang : public testing::TestWithParam<gl::Language> {};
INSTANTIATE_TEST_SUITE_P(Versions, Glslang, testing::Values(gl::Language::essl310, gl::Language::essl320),
                         [](const auto& test) {
                             return test.param == gl::Language::essl320 ? "Es320" : "Es310";
                         });

TEST_P(Glslang, AcceptsEveryShaderInEveryVariant) {
    ASSERT_EQ(std::system("glslangValidator --version > /dev/null 2>&1"), 0)
        << "glslangValidator is missing; scripts/setup.sh installs it";
    std::set<std::string> seen;
    std::vector<Source> sources;
    for (const gl::ProgramDescription& program : allPrograms())
        for (const std::string& path : program.shaders) {
            const gl::AssembledShader source =
                gl::assembleShader(testShaders(), path, program.defines, GetParam());
            if (seen.insert(path + source.text).second) sources.push_back({path, source.text, program.name});
        }
    EXPECT_GT(sources.size(), 60U);
    expectAccepted(sources);
    // No file below shaders/ is left out.
    std::set<std::string> used;
    for (const gl::ProgramDescription& program : allPrograms())
        for (const std::string& path : program.shaders)
            used.insert(path);
    const std::filesystem::path folder(VCT_SOURCE_DIR "/shaders");
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string extension = entry.path().extension().string();
        if (!entry.is_regular_file() || extension.empty() || extension == ".glsl" || extension == ".h")
            continue;
        EXPECT_TRUE(used.count(std::filesystem::relative(entry.path(), folder).string())) << entry.path();
        ++files;
    }
    EXPECT_EQ(files, used.size());
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

TEST(Programs, EveryVariantLinksOnTheDriver) {
    const Context context = openContext(Backend::egl);
    for (const gl::ProgramDescription& description : allPrograms())
        EXPECT_NO_THROW(gl::Program({testShaders(), context.capabilities.language()}, description))
            << description.name;
}

}  // namespace
}  // namespace vct::test
