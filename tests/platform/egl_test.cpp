#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "platform/contexts.h"
#include "support/errors.h"

namespace vct {
namespace {

using test::createContext;

TEST(Egl, DestructionLeavesNoContextBehind) {
    auto platform = createContext(Backend::egl);
    EXPECT_NE(eglGetCurrentContext(), EGL_NO_CONTEXT);
    platform.reset();
    EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
}

TEST(Zink, RefusesToStandBesideAnotherEglContext) {
    VCT_SKIP_IF_ABSENT(Backend::zink);
    auto egl = createContext(Backend::egl);
    EXPECT_THROW(createContext(Backend::zink), Error);
    egl.reset();
    EXPECT_NO_THROW(createContext(Backend::zink));
}

TEST(Zink, NamesThePackageWhereThereIsNoVulkanAndWorksAgainOnceThereIs) {
    VCT_SKIP_IF_ABSENT(Backend::zink);
    const char* chosen = std::getenv("VK_ICD_FILENAMES");
    const std::string before = chosen ? chosen : "";
    setenv("VK_ICD_FILENAMES", "/nonexistent/icd.json", 1);
    unsetenv("VK_DRIVER_FILES");
    test::expectMentions(test::errorOf([] { createContext(Backend::zink); }), {"mesa-vulkan-drivers"});
    if (chosen)
        setenv("VK_ICD_FILENAMES", before.c_str(), 1);
    else
        unsetenv("VK_ICD_FILENAMES");
    const std::string again = test::errorOf([] { createContext(Backend::zink); });
    if (!again.empty())
        GTEST_SKIP() << "this Mesa does not look for Vulkan again in the same process (25.2 does not): "
                     << again;
    EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
}

}  // namespace
}  // namespace vct
