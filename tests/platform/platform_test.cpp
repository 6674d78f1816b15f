#include "platform/platform.h"

#include <gtest/gtest.h>

#include "platform/contexts.h"
#include "support/errors.h"

namespace vct {
namespace {

using test::createContext;

class EveryBackend : public testing::TestWithParam<Backend> {
  protected:
    // A driver that whoever runs the tests has forced on Mesa would stand in for all of them.
    void SetUp() override { unsetenv("GALLIUM_DRIVER"); }
};

void expectItself(Backend backend) {
    const std::string renderer = gl::glString(GL_RENDERER), version = gl::glString(GL_VERSION);
    SCOPED_TRACE(renderer + ", " + version);
    EXPECT_EQ(renderer.find("zink") != std::string::npos, backend == Backend::zink);
    EXPECT_EQ(version.compare(0, 12, "OpenGL ES 3.") == 0, backend != Backend::osmesa);
    if (backend == Backend::osmesa) {
        EXPECT_EQ(version.compare(0, 3, "4.5"), 0);
    }
}

TEST_P(EveryBackend, GivesAContextOfItsOwnKind) {
    VCT_SKIP_IF_ABSENT(GetParam());
    const auto platform = createContext(GetParam());
    expectItself(GetParam());
    const std::string start = GetParam() == Backend::osmesa ? "OSMesa" : "EGL 1.";
    EXPECT_EQ(platform->description().compare(0, start.size(), start), 0) << platform->description();
}

TEST_P(EveryBackend, WorksAfterAFailedCreation) {
    VCT_SKIP_IF_ABSENT(GetParam());
    PlatformOptions options;
    options.backend = GetParam();
    options.device = 999;
    EXPECT_THROW(createPlatform(options), Error);
    const auto platform = createContext(GetParam());
    expectItself(GetParam());
}

TEST_P(EveryBackend, IsNotDisturbedByTheOthersBeforeIt) {
    VCT_SKIP_IF_ABSENT(GetParam());
    for (const Backend earlier : {Backend::zink, Backend::egl, Backend::osmesa}) {
        if (test::whyAbsent(earlier).empty()) createContext(earlier);
    }
    const auto platform = createContext(GetParam());
    expectItself(GetParam());
}

INSTANTIATE_TEST_SUITE_P(Platform, EveryBackend,
                         testing::Values(Backend::egl, Backend::osmesa, Backend::zink),
                         [](const auto& test) { return std::string(backendName(test.param)); });

TEST(Platform, NamesOfBackEndsGoBothWays) {
    for (const Backend backend : {Backend::egl, Backend::osmesa, Backend::zink})
        EXPECT_EQ(backendFromName(backendName(backend)), backend);
}

TEST(Platform, AMissingDeviceIsNamedWithTheNumberThereAre) {
    PlatformOptions options;
    options.device = 999;
    test::expectMentions(test::errorOf([&] { createPlatform(options); }),
                         {"999", std::to_string(eglDevices().size())});
}

TEST(Platform, EveryListedSoftwareDeviceGivesAContext) {
    const std::vector<std::string> names = eglDevices();
    if (names.empty()) GTEST_SKIP() << "EGL cannot enumerate devices here";
    for (size_t i = 0; i < names.size(); ++i) {
        // Of a GPU the node may be listed and not open to this user.
        if (names[i].find("software") == std::string::npos) continue;
        PlatformOptions options;
        options.device = static_cast<int>(i);
        const auto platform = createPlatform(options);
        test::expectMentions(platform->description(), {"device " + std::to_string(i)});
    }
}

TEST(Platform, ASecondEglContextOutlivesTheFirst) {
    auto first = createContext(Backend::egl);
    const auto second = createContext(Backend::egl);
    first.reset();
    EXPECT_NE(gl::glString(GL_RENDERER), "unknown");
    GLuint buffer = 0;
    gl::GenBuffers(1, &buffer);
    EXPECT_NE(buffer, 0u);
    EXPECT_EQ(gl::GetError(), GLenum{GL_NO_ERROR});
}

}  // namespace
}  // namespace vct
