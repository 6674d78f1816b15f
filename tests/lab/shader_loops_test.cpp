// The loops that are found in a shader's source, and the counters that are added to it.
#include "lab/shader_loops.h"

#include <gtest/gtest.h>

#include "gl/objects.h"
#include "gl/program.h"
#include "lab/shader_counters.h"
#include "platform/platform.h"

namespace vct::test {
namespace {

gl::AssembledShader sourceOf(const std::string& text, const std::vector<std::string>& defines = {}) {
    return gl::assembleShader([&](const std::string&) { return text; }, "a.comp", defines,
                              gl::Language::essl310);
}

// "a.comp:3" and the depth of each loop, "*" if its length is constant.
std::string loopsOf(const std::string& text, const std::vector<std::string>& defines = {}) {
    gl::AssembledShader source = sourceOf(text, defines);
    std::string found;
    for (const ShaderLoop& loop : countLoops(source, 0).loops)
        found += loop.place + " " + std::to_string(loop.depth) + (loop.constant ? "* " : " ");
    return found;
}

TEST(ShaderLoops, AreListedInTheOrderInWhichMainRunsThem) {
    EXPECT_EQ(loopsOf("const int n = 4;\n"
                      "int inner(int a) {\n"
                      "    for (int i = 0; i < n; ++i) a += i;\n"  // 3
                      "    return a;\n"
                      "}\n"
                      "int outer(int a) {\n"
                      "    do {\n"  // 7
                      "        a += inner(inner(a));\n"
                      "    } while (a < 8);\n"
                      "    return a;\n"
                      "}\n"
                      "void main() {\n"
                      "    int b = 1; // for (;;) in a comment\n"
                      "    while (b < outer(b)) ++b;\n"  // 14
                      "    if (b > 3) for (uint left = uint(b); left != 0u; left &= left - 1u) b += 1;\n"
                      "    else { for (int i = 0; i < VCT_TAPS / 2; ++i) for (int k = b; k < n; ++k) ++b; }\n"
                      "}\n"),
              "a.comp:14 0 a.comp:7 1 a.comp:3 2* a.comp:3 2* a.comp:15 0 a.comp:16 0* a.comp:16 1 ");
}

TEST(ShaderLoops, OfOtherVariantsAndOfUnusedFunctionsAreNotListed) {
    const std::string text =
        "void unused() {\n"
        "    for (int i = 0; i < 2; ++i) {}\n"
        "}\n"
        "void main() {\n"
        "#if defined(VCT_A) && VCT_N > 1\n"
        "    for (int i = 0; i < 2; ++i) {}\n"
        "#elif !defined(VCT_A)\n"
        "    for (int i = 0; i < 3; ++i) {}\n"
        "#else\n"
        "    for (int i = 0; i < 4; ++i) {}\n"
        "#endif\n"
        "}\n";
    EXPECT_EQ(loopsOf(text, {"VCT_A", "VCT_N 2"}), "a.comp:6 0* ");
    EXPECT_EQ(loopsOf(text), "a.comp:8 0* ");
    EXPECT_EQ(loopsOf(text, {"VCT_A", "VCT_N 1"}), "a.comp:10 0* ");
}

// A shader of known counts, on the driver.
TEST(ShaderLoops, AreCountedWhereTheyRun) {
    const Context context = openContext(Backend::egl);
    const std::string text =
        "layout(local_size_x = 2) in;\n"
        "void twice(int n) {\n"
        "    for (int i = 0; i < n; ++i) {\n"
        "        if (i == 1) continue;\n"
        "        for (int k = 0; k < 5; ++k)\n"
        "            if (k == 2) break;\n"
        "    }\n"
        "}\n"
        "void main() {\n"
        "    twice(1);\n"
        "    twice(3);\n"
        "}\n";
    const ShaderCounters counters;
    const gl::ShaderLibrary library{
        [&](const std::string&) { return text; }, context.capabilities.language(), {}, counters.programs()};
    const gl::Program program(library, {"test", {"a.comp"}, {}});
    const std::vector<ProgramCount> counts = counters.count([&] {
        program.use();
        gl::DispatchCompute(3, 1, 1);
    });
    ASSERT_EQ(counts.size(), 1U);
    EXPECT_EQ(counts[0].program.name, "test");
    const StageCount& stage = counts[0].stage;
    EXPECT_EQ(stage.invocations, 6U);
    ASSERT_EQ(stage.loops.size(), 4U);
    // By both calls together: 1 + 3 of the outer loop and 3 + 2 * 3 of the inner one.
    for (const int call : {0, 2}) {
        EXPECT_EQ(stage.loops[call].iterations, 6U * (1 + 3));
        EXPECT_EQ(stage.loops[call + 1].iterations, 6U * (3 + 2 * 3));
    }
    EXPECT_TRUE(counters.count([] {}).empty());
}

}  // namespace
}  // namespace vct::test
