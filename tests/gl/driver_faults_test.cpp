// Workarounds for faults of real phones, observed at the entry points of GL.
#include "gl/driver_faults.h"

#include <gtest/gtest.h>

#include "gl/objects.h"
#include "platform/platform.h"
#include "support/gl_spy.h"

namespace vct::test {
namespace {

TEST(DriverFaults, AreKnownByTheDriversNames) {
    const struct {
        const char *renderer, *version;
        bool timerQueries, derivatives, indirectDispatches = false;
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
        {"NVIDIA Tegra", "OpenGL ES 3.2 NVIDIA 495.00", false, false, true},
        {"NVIDIA H100 80GB HBM3/PCIe/SSE2", "OpenGL ES 3.2 NVIDIA 580.159.04", false, false, true},
        {"llvmpipe (LLVM 15.0.6, 256 bits)", "OpenGL ES 3.2 Mesa 22.3.6", false, false},
    };
    for (const auto& driver : drivers) {
        const gl::DriverFaults faults = gl::faultsOf(driver.renderer, driver.version);
        EXPECT_EQ(!faults.timerQueries.empty(), driver.timerQueries) << driver.renderer;
        EXPECT_EQ(!faults.derivatives.empty(), driver.derivatives) << driver.renderer << driver.version;
        EXPECT_EQ(!faults.indirectDispatches.empty(), driver.indirectDispatches) << driver.renderer;
    }
}

using Attached = std::vector<std::pair<GLenum, GLuint>>;

TEST(DriverFaults, AttachmentsAreAttachedAgainAfterTheStatusCheck) {
    const Context context = openContext(Backend::egl);
    const gl::Texture color = gl::Texture::make2d("color", GL_RGBA8, 8, 8);
    const gl::Texture other = gl::Texture::make2d("other", GL_RGBA8, 8, 8);
    const gl::Texture depth = gl::Texture::make2d("depth", GL_DEPTH_COMPONENT24, 8, 8);
    Attached before, after;
    bool isChecked = false;
    const GlSpy<&gl::CheckFramebufferStatus> checks([&](GLenum) { isChecked = true; });
    const GlSpy<&gl::FramebufferTexture2D> attachments(
        [&](GLenum, GLenum attachment, GLenum, GLuint texture, GLint) {
            (isChecked ? after : before).emplace_back(attachment, texture);
        });
    const gl::Framebuffer framebuffer("f", {&color, &other}, &depth);
    EXPECT_EQ(before.size(), 3U);
    EXPECT_EQ(after, before);
}

TEST(DriverFaults, AFramebufferIsUnboundBeforeItIsDeleted) {
    const Context context = openContext(Backend::egl);
    const gl::Texture color = gl::Texture::make2d("color", GL_RGBA8, 8, 8);
    const gl::Framebuffer other("other", {&color}, nullptr);
    const auto bound = [] {
        GLint name = 0;
        gl::GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &name);
        return static_cast<GLuint>(name);
    };
    int deletions = 0;
    const GlSpy<&gl::DeleteFramebuffers> deleted([&](GLsizei, const GLuint* name) {
        ++deletions;
        EXPECT_NE(bound(), *name);
    });
    {
        const gl::Framebuffer framebuffer("f", {&color}, nullptr);
    }
    gl::Framebuffer framebuffer("f", {&color}, nullptr);
    other.bind();
    const GLuint stays = bound();
    framebuffer = gl::Framebuffer();
    EXPECT_EQ(bound(), stays) << "another framebuffer was unbound";
    EXPECT_EQ(deletions, 2);
}

TEST(DriverFaults, ABarrierFollowsAClearThroughAFramebuffer) {
    const Context context = openContext(Backend::egl);
    const gl::Texture texture = gl::Texture::make3d("voxels", GL_R32UI, 4, 4, 4, 2);
    bool isClear = false, isBarred = false;
    const GlSpy<&gl::ClearBufferuiv> clears([&](GLenum, GLint, const GLuint*) { isClear = true; });
    const GlSpy<&gl::MemoryBarrier> barriers([&](GLbitfield bits) {
        isBarred |= isClear && bits == (GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    });
    gl::clearTexture3d(texture, 4);
    EXPECT_TRUE(isBarred);
}

}  // namespace
}  // namespace vct::test
