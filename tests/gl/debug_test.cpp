#include "gl/debug.h"

#include <gtest/gtest.h>

#include <memory>

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

class Debug : public testing::Test {
  protected:
    std::unique_ptr<Platform> platform = test::createContext(Backend::egl);

    void insert(GLenum type, GLenum severity, const char* text) const {
        const auto insertMessage =
            reinterpret_cast<PFNGLDEBUGMESSAGEINSERTPROC>(platform->getProcAddress("glDebugMessageInsert"));
        ASSERT_NE(insertMessage, nullptr);
        insertMessage(GL_DEBUG_SOURCE_APPLICATION, type, 7, severity, -1, text);
    }
    // Makes the driver one without KHR_debug.
    static void dropDebugEntryPoints() {
        DebugMessageCallback = nullptr;
        DebugMessageControl = nullptr;
        PushDebugGroup = nullptr;
        PopDebugGroup = nullptr;
        ObjectLabel = nullptr;
    }
};

TEST_F(Debug, WithoutKhrDebugTheErrorCodeIsReported) {
    dropDebugEntryPoints();
    installDebugCallback();
    {
        const DebugGroup group("voxelization");
        makeAnError();
    }
    label(GL_TEXTURE, 1, "albedo");
    EXPECT_EQ(messageOf("voxelization"), "voxelization: GL_INVALID_ENUM");
    EXPECT_EQ(messageOf("the next pass"), "");
}

TEST_F(Debug, KeepsErrorsAndHighSeverityAndDropsTheRest) {
    installDebugCallback();
    insert(GL_DEBUG_TYPE_ERROR, GL_DEBUG_SEVERITY_LOW, "an error");
    insert(GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR, GL_DEBUG_SEVERITY_HIGH, "undefined");
    insert(GL_DEBUG_TYPE_PERFORMANCE, GL_DEBUG_SEVERITY_HIGH, "slow");
    insert(GL_DEBUG_TYPE_OTHER, GL_DEBUG_SEVERITY_NOTIFICATION, "by the way");
    insert(GL_DEBUG_TYPE_OTHER, GL_DEBUG_SEVERITY_MEDIUM, "hm");
    EXPECT_EQ(messageOf("pass"), "pass: an error (message 7); undefined (message 7)");
}

}  // namespace
}  // namespace vct::gl
