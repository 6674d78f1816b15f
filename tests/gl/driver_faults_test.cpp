// The ways around faults that real phones have, seen in what is asked of GL.
#include "gl/driver_faults.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "gl/call_log.h"
#include "gl/objects.h"
#include "platform/platform.h"

namespace vct::test {
namespace {

TEST(DriverFaults, AreKnownByTheDriversNames) {
    const struct {
        const char *renderer, *version;
        bool timerQueries, derivatives;
    } drivers[] = {
        {"Mali-T880", "OpenGL ES 3.2 v1.r22p0-01rel0.7da04ff5b89c24125ad1a1f482090070", true, false},
        {"Mali-G715", "OpenGL ES 3.2 v1.r46p0-01eac1.2441b76d7cdc99fdd0c43c87a4964b7d", true, false},
        {"Adreno (TM) 418", "OpenGL ES 3.1 V@139.0 (GIT@I8a1ccf9ecb)", true, false},
        {"Adreno (TM) 530", "OpenGL ES 3.2 V@415.0 (GIT@7331a27, Ieeb4a86f7b)", true, false},
        {"Adreno (TM) 642L", "OpenGL ES 3.2 V@0530.0 (GIT@f3aa497c33)", false, false},
        {"PowerVR Rogue GE8320", "OpenGL ES 3.2 build 1.15@6070602", false, true},
        {"PowerVR Rogue G6200", "OpenGL ES 3.1 build 1.4@3300288", false, true},
        {"PowerVR Rogue GE8320", "OpenGL ES 3.2 build 1.16@6400000", false, false},
        {"PowerVR Rogue GE8320", "OpenGL ES 3.2 build 2.0@7000000", false, false},
        {"PowerVR Rogue GE8320", "OpenGL ES 3.2", false, true},
        {"PowerVR B-Series BXM-8-256", "OpenGL ES 3.2 build 1.15@6133110", false, false},
        {"ANGLE (ARM, Vulkan 1.3.260 (Mali-G710 (0xA8620000)), Mali-G710-46.0.0)", "OpenGL ES 3.2.0", false,
         false},
        {"NVIDIA Tegra", "OpenGL ES 3.2 NVIDIA 495.00", false, false},
        {"llvmpipe (LLVM 15.0.6, 256 bits)", "OpenGL ES 3.2 Mesa 22.3.6", false, false},
    };
    for (const auto& driver : drivers) {
        const gl::DriverFaults faults = gl::faultsOf(driver.renderer, driver.version);
        EXPECT_EQ(!faults.timerQueries.empty(), driver.timerQueries) << driver.renderer;
        EXPECT_EQ(!faults.derivatives.empty(), driver.derivatives) << driver.renderer << driver.version;
    }
}

// The calls of some names while `work` is done, in order.
std::vector<gl::Call> callsOf(const std::vector<std::string>& names, const std::function<void()>& work) {
    gl::CallLog log;
    work();
    std::vector<gl::Call> calls;
    for (const gl::Call& call : log.calls())
        if (std::count(names.begin(), names.end(), call.name) > 0) calls.push_back(call);
    return calls;
}

TEST(DriverFaults, WhatIsAttachedIsAttachedAgainAfterTheStatus) {
    const Context context = openContext(Backend::egl);
    const gl::Texture color = gl::Texture::make2d("color", GL_RGBA8, 8, 8);
    const gl::Texture other = gl::Texture::make2d("other", GL_RGBA8, 8, 8);
    const gl::Texture depth = gl::Texture::make2d("depth", GL_DEPTH_COMPONENT24, 8, 8);
    const auto calls = callsOf({"FramebufferTexture2D", "CheckFramebufferStatus"},
                               [&] { const gl::Framebuffer framebuffer("f", {&color, &other}, &depth); });
    ASSERT_EQ(calls.size(), 7U);
    EXPECT_STREQ(calls[3].name, "CheckFramebufferStatus");
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_EQ(calls[i].arguments, calls[4 + i].arguments) << i;
}

TEST(DriverFaults, AFramebufferIsUnboundBeforeItIsDeleted) {
    const Context context = openContext(Backend::egl);
    const gl::Texture color = gl::Texture::make2d("color", GL_RGBA8, 8, 8);
    const auto calls = callsOf({"BindFramebuffer", "DeleteFramebuffers"},
                               [&] { const gl::Framebuffer framebuffer("f", {&color}, nullptr); });
    ASSERT_EQ(calls.size(), 3U);
    EXPECT_EQ(calls[1].arguments, (std::vector<std::int64_t>{GL_FRAMEBUFFER, 0}));
    EXPECT_STREQ(calls[2].name, "DeleteFramebuffers");

    // Another one that is bound stays.
    const gl::Framebuffer bound("bound", {&color}, nullptr);
    const auto others = callsOf({"BindFramebuffer", "DeleteFramebuffers"}, [&] {
        gl::Framebuffer framebuffer("f", {&color}, nullptr);
        bound.bind();
        framebuffer = gl::Framebuffer();
    });
    EXPECT_EQ(others.size(), 3U) << "both are bound, one is deleted";
}

TEST(DriverFaults, ABarrierStandsBetweenAClearByFramebufferAndWhatReadsIt) {
    const Context context = openContext(Backend::egl);
    const gl::Texture texture = gl::Texture::make3d("voxels", GL_R32UI, 4, 4, 4, 2);
    const auto calls = callsOf({"ClearBufferuiv", "BindFramebuffer", "MemoryBarrier"},
                               [&] { gl::clearTexture3d(texture, 4); });
    ASSERT_GE(calls.size(), 3U);
    EXPECT_EQ(calls[calls.size() - 2].arguments, (std::vector<std::int64_t>{GL_FRAMEBUFFER, 0}));
    EXPECT_STREQ(calls.back().name, "MemoryBarrier");
    EXPECT_EQ(calls.back().arguments[0], GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

}  // namespace
}  // namespace vct::test
