#include "gl/debug.h"

#include <gtest/gtest.h>

#include "gl/api.h"
#include "platform/contexts.h"
#include "support/errors.h"

namespace vct::gl {
namespace {

std::string messageOf(const std::string& where) {
    return test::errorOf([&] { checkErrors(where); });
}

void makeAnError() {
    Enable(0x1234);
}

class DebugOn : public testing::TestWithParam<Backend> {};

TEST_P(DebugOn, AnErrorNamesThePassAndIsReportedOnce) {
    VCT_SKIP_IF_ABSENT(GetParam());
    const auto platform = test::createContext(GetParam());
    installDebugCallback();
    EXPECT_EQ(messageOf("nothing"), "");
    makeAnError();
    const std::string text = messageOf("voxelization");
    EXPECT_EQ(text.compare(0, 14, "voxelization: "), 0) << text;
    test::expectMentions(text, {"GL_INVALID_ENUM", "glEnable"});  // the code and the driver's words
    EXPECT_EQ(messageOf("the next pass"), "");
}

INSTANTIATE_TEST_SUITE_P(Debug, DebugOn, testing::Values(Backend::egl, Backend::osmesa, Backend::zink),
                         [](const auto& test) { return std::string(backendName(test.param)); });

TEST(Debug, WithoutKhrDebugTheErrorCodeIsReported) {
    const auto platform = test::createContext(Backend::egl);
    DebugMessageCallback = nullptr;
    DebugMessageControl = nullptr;
    PushDebugGroup = nullptr;
    PopDebugGroup = nullptr;
    ObjectLabel = nullptr;
    installDebugCallback();
    {
        const DebugGroup group("voxelization");
        makeAnError();
    }
    label(GL_TEXTURE, 1, "albedo");
    EXPECT_EQ(messageOf("voxelization"), "voxelization: GL_INVALID_ENUM");
    EXPECT_EQ(messageOf("the next pass"), "");
}

}  // namespace
}  // namespace vct::gl
