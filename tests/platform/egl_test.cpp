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

}  // namespace
}  // namespace vct
