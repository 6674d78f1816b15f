#include "gl/api.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "core/error.h"
#include "gl/version.h"
#include "platform/contexts.h"

namespace vct::gl {
namespace {

void stub() {}

TEST(Load, NamesEveryMissingEntryPointAtOnce) {
    const auto lacking = [](const char* name, const void*) -> Proc {
        const bool missing =
            !std::strcmp(name, "glDispatchCompute") || !std::strcmp(name, "glBindImageTexture");
        return missing ? nullptr : stub;
    };
    try {
        load(lacking, nullptr);
        FAIL() << "accepted";
    } catch (const Error& error) {
        const std::string text = error.what();
        EXPECT_NE(text.find("glDispatchCompute"), std::string::npos) << text;
        EXPECT_NE(text.find("glBindImageTexture"), std::string::npos) << text;
        EXPECT_EQ(text.find("glViewport"), std::string::npos) << text;
    }
}

class LoadOn : public testing::TestWithParam<Backend> {};

TEST_P(LoadOn, FindsEverythingIncludingKhrDebug) {
    VCT_SKIP_IF_ABSENT(GetParam());
    const auto platform = test::createContext(GetParam());
    EXPECT_NE(DebugMessageCallback, nullptr);
    EXPECT_NE(PushDebugGroup, nullptr);
    GLint size = 0;
    GetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &size);
    EXPECT_GE(size, 256);
}

INSTANTIATE_TEST_SUITE_P(Api, LoadOn, testing::Values(Backend::egl, Backend::osmesa, Backend::zink),
                         [](const auto& test) { return std::string(backendName(test.param)); });

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
