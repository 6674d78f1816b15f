#include "gl/render_pass.h"

#include <gtest/gtest.h>

#include "gl/debug.h"
#include "platform/platform.h"
#include "support/gl_spy.h"

namespace vct::test {
namespace {

class RenderPass : public testing::Test {
  protected:
    Context context_ = openContext(Backend::egl);
    gl::Texture color_ = gl::Texture::make2d("color", GL_RGBA8, 4, 4);
    gl::Texture codes_ = gl::Texture::make2d("codes", GL_RG16UI, 4, 4);
    gl::Texture depth_ = gl::Texture::make2d("depth", GL_DEPTH_COMPONENT24, 4, 4);
    gl::Framebuffer framebuffer_{"f", {&color_, &codes_}, &depth_};
};

TEST_F(RenderPass, ClearsEveryAttachmentAsItsFormatDemands) {
    const std::array<GLfloat, 4> orange{1.0F, 0.4F, 0.0F, 1.0F};
    {
        const gl::RenderPass pass(framebuffer_, gl::Load::clear, gl::Store::all, orange);
    }
    std::array<std::uint8_t, 4> texel{};
    gl::ReadBuffer(GL_COLOR_ATTACHMENT0);
    gl::ReadPixels(3, 3, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, texel.data());
    EXPECT_EQ(texel, (std::array<std::uint8_t, 4>{255, 102, 0, 255}));
    std::array<GLuint, 4> codes{9, 9, 9, 9};
    gl::ReadBuffer(GL_COLOR_ATTACHMENT1);
    gl::ReadPixels(3, 3, 1, 1, GL_RGBA_INTEGER, GL_UNSIGNED_INT, codes.data());
    EXPECT_EQ(codes[0] + codes[1], 0U);
    EXPECT_NO_THROW(gl::checkErrors("pass"));
}

// A tile-based GPU reads what is neither cleared nor invalidated, and writes what is not invalidated.
TEST_F(RenderPass, InvalidatesWhatIsNeitherLoadedNorStored) {
    std::vector<std::vector<GLenum>> invalidated;
    const GlSpy<&gl::InvalidateFramebuffer> invalidations(
        [&](GLenum, GLsizei count, const GLenum* names) { invalidated.emplace_back(names, names + count); });
    {
        const gl::RenderPass pass(framebuffer_, gl::Load::invalidate, gl::Store::colors);
    }
    const std::vector<GLenum> all{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_DEPTH_ATTACHMENT};
    EXPECT_EQ(invalidated, (std::vector<std::vector<GLenum>>{all, {GL_DEPTH_ATTACHMENT}}));
    EXPECT_NO_THROW(gl::checkErrors("pass"));
}

}  // namespace
}  // namespace vct::test
