#include "gl/api.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "gl/version.h"
#include "support/errors.h"

namespace vct::gl {
namespace {

void stub() {}

TEST(Load, NamesEveryMissingEntryPointAtOnce) {
    const auto lacking = [](const char* name, const void*) -> Proc {
        const bool missing =
            !std::strcmp(name, "glDispatchCompute") || !std::strcmp(name, "glBindImageTexture");
        return missing ? nullptr : stub;
    };
    const std::string text = test::errorOf([&] { load(lacking, nullptr); });
    test::expectMentions(text, {"glDispatchCompute", "glBindImageTexture"});
    EXPECT_EQ(text.find("glViewport"), std::string::npos) << text;
}

// Entry points are there without a context, but each query of theirs gives nothing.
TEST(Load, NamesAMissingContext) {
    const auto withoutContext = [](const char* name, const void*) -> Proc {
        if (std::strcmp(name, "glGetString") != 0) return stub;
        return reinterpret_cast<Proc>(+[](GLenum) -> const GLubyte* { return nullptr; });
    };
    const std::string text = test::errorOf([&] { load(withoutContext, nullptr); });
    test::expectMentions(text, {"no GL context is current", "make one"});
}

TEST(VersionText, IsUnderstoodForEsAndDesktop) {
    const Version es = parseVersion("OpenGL ES 3.2 Mesa 22.3.6");
    EXPECT_FALSE(es.desktop);
    EXPECT_TRUE(es.atLeast(3, 2, 9, 9));
    EXPECT_FALSE(es.atLeast(4, 0, 1, 0));
    const Version desktop = parseVersion("4.5 (Core Profile) Mesa 22.3.6");
    EXPECT_TRUE(desktop.desktop);
    EXPECT_TRUE(desktop.atLeast(9, 9, 4, 3));
    EXPECT_FALSE(desktop.atLeast(3, 1, 4, 6));
    EXPECT_FALSE(parseVersion("nonsense").atLeast(1, 0, 1, 0));
    EXPECT_FALSE(parseVersion("").atLeast(1, 0, 1, 0));
}

}  // namespace
}  // namespace vct::gl
