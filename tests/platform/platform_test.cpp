#include "platform/platform.h"

#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>
#include <gtest/gtest.h>

#include "platform/contexts.h"
#include "support/errors.h"

namespace vct {
namespace {

using test::createContext;

class EveryBackend : public testing::TestWithParam<Backend> {
  protected:
    // The environment may force one driver of Mesa on all tests.
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

INSTANTIATE_TEST_SUITE_P(Platform, EveryBackend,
                         testing::Values(Backend::egl, Backend::osmesa, Backend::zink),
                         [](const auto& test) { return std::string(backendName(test.param)); });

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
        // This user may not open the node of a listed GPU.
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

TEST(Platform, ZinkIsRefusedBesideAnotherEglContext) {
    VCT_SKIP_IF_ABSENT(Backend::zink);
    auto egl = createContext(Backend::egl);
    EXPECT_THROW(createContext(Backend::zink), Error);
    egl.reset();
    EXPECT_NO_THROW(createContext(Backend::zink));
}

}  // namespace
}  // namespace vct
