// The library leaves GL's state as it found it, whatever that was.
#include <cstdlib>

#include "api/described_scene.h"
#include "api/gl_state.h"
#include "support/errors.h"
#include "vct/error.h"

namespace vct::test {
namespace {

// Textures, buffers and other objects of the embedding program, all of them bound, in every place.
class Bindings {
  public:
    Bindings() {
        for (int i = 0; i < 3; ++i)
            buffers_.emplace_back("of the test", GL_ARRAY_BUFFER, 4096, nullptr, GL_STATIC_DRAW);
        vertices_.bind();
        gl::EnableVertexAttribArray(1);
        gl::BindBuffer(GL_ARRAY_BUFFER, buffers_[2].name());
        gl::VertexAttribPointer(1, 2, GL_FLOAT, GL_FALSE, 24, nullptr);
        gl::VertexAttribDivisor(1, 3);
        buffers_[0].bind(GL_ELEMENT_ARRAY_BUFFER);
        GLuint feedback = 0;
        VCT_ENTRY_POINT(GenTransformFeedbacks)(1, &feedback);
        VCT_ENTRY_POINT(BindTransformFeedback)(GL_TRANSFORM_FEEDBACK, feedback);
        for (const IndexedTarget& target : indexedTargets()) {
            const GLuint limit = limitOf(target.limit);
            for (GLuint i = 0; i < limit; ++i)
                if (i % 2 == 0)
                    gl::BindBufferRange(target.target, i, buffers_[i % 3].name(), 256, 256 + 16 * (i % 4));
                else
                    gl::BindBufferBase(target.target, i, buffers_[i % 3].name());
        }
        for (const GLenum target :
             {GL_ARRAY_BUFFER, GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, GL_DRAW_INDIRECT_BUFFER,
              GL_DISPATCH_INDIRECT_BUFFER, GL_UNIFORM_BUFFER, GL_SHADER_STORAGE_BUFFER, GL_PIXEL_PACK_BUFFER,
              GL_PIXEL_UNPACK_BUFFER, GL_ATOMIC_COUNTER_BUFFER})
            gl::BindBuffer(target, buffers_[1].name());
        const GLuint units = limitOf(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
        for (GLuint unit = 0; unit < units; ++unit) {
            gl::ActiveTexture(GL_TEXTURE0 + unit);
            for (const TextureTarget& target : textureTargets()) {
                names_.push_back(gl::generate(gl::GenTextures));
                gl::BindTexture(target.target, names_.back());
            }
            samplers_.push_back(gl::generate(gl::GenSamplers));
            gl::BindSampler(unit, samplers_.back());
        }
        for (GLuint unit = 0; unit < limitOf(GL_MAX_IMAGE_UNITS); ++unit)
            gl::BindImageTexture(unit, image_.name(), static_cast<GLint>(unit % 2),
                                 unit % 2 == 0 ? GL_TRUE : GL_FALSE, static_cast<GLint>(unit % 3),
                                 GL_WRITE_ONLY, unit % 2 == 0 ? GL_R32UI : GL_R32F);
        drawn_.bind();
        gl::BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
        GLuint renderbuffer = 0;
        VCT_ENTRY_POINT(GenRenderbuffers)(1, &renderbuffer);
        VCT_ENTRY_POINT(BindRenderbuffer)(GL_RENDERBUFFER, renderbuffer);
        gl::ActiveTexture(GL_TEXTURE5);
    }
    ~Bindings() {
        for (const GLuint& name : names_)
            gl::DeleteTextures(1, &name);
        for (const GLuint& name : samplers_)
            gl::DeleteSamplers(1, &name);
    }
    static GLuint limitOf(GLenum name) {
        GLint value = 0;
        gl::GetIntegerv(name, &value);
        return static_cast<GLuint>(value);
    }

  private:
    gl::VertexArray vertices_;
    std::vector<gl::Buffer> buffers_;
    std::vector<GLuint> names_, samplers_;
    gl::Texture image_ = gl::Texture::make3d("image", GL_R32UI, 8, 8, 8, 2);
    gl::Texture target_ = gl::Texture::make2d("target", GL_RGBA8, 8, 8);
    gl::Framebuffer drawn_{"drawn", {&target_}, nullptr};
};

// Gives all other state a value that is not its initial one. Many of these would spoil a pass.
void changeParameters() {
    for (const auto& [name, value] : glSwitches()) {
        GLint on = 0;
        gl::GetIntegerv(value, &on);
        if (gl::GetError() == GL_NO_ERROR) (on != 0 ? gl::Disable : gl::Enable)(value);
    }
    gl::Viewport(3, 2, 5, 7);
    gl::Scissor(1, 2, 3, 4);
    gl::DepthRangef(0.25F, 0.5F);
    gl::ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
    gl::DepthMask(GL_FALSE);
    gl::DepthFunc(GL_GREATER);
    gl::CullFace(GL_FRONT);
    gl::FrontFace(GL_CW);
    gl::ClipControl(GL_UPPER_LEFT_EXT, GL_ZERO_TO_ONE_EXT);
    VCT_ENTRY_POINT(BlendColor)(0.1F, 0.2F, 0.3F, 0.4F);
    VCT_ENTRY_POINT(BlendFuncSeparate)(GL_ZERO, GL_ONE, GL_DST_ALPHA, GL_SRC_COLOR);
    VCT_ENTRY_POINT(BlendEquationSeparate)(GL_MIN, GL_FUNC_SUBTRACT);
    VCT_ENTRY_POINT(ClearColor)(0.5F, 0.6F, 0.7F, 0.8F);
    VCT_ENTRY_POINT(ClearDepthf)(0.75F);
    VCT_ENTRY_POINT(ClearStencil)(3);
    VCT_ENTRY_POINT(StencilFuncSeparate)(GL_FRONT, GL_NEVER, 1, 0xF0);
    VCT_ENTRY_POINT(StencilFuncSeparate)(GL_BACK, GL_LESS, 2, 0x0F);
    VCT_ENTRY_POINT(StencilOpSeparate)(GL_FRONT, GL_ZERO, GL_INCR, GL_DECR);
    VCT_ENTRY_POINT(StencilOpSeparate)(GL_BACK, GL_INVERT, GL_REPLACE, GL_ZERO);
    VCT_ENTRY_POINT(StencilMaskSeparate)(GL_FRONT, 0x3C);
    VCT_ENTRY_POINT(StencilMaskSeparate)(GL_BACK, 0xC3);
    VCT_ENTRY_POINT(LineWidth)(1.5F);
    VCT_ENTRY_POINT(PolygonOffset)(2.0F, 3.0F);
    VCT_ENTRY_POINT(SampleCoverage)(0.5F, GL_TRUE);
    VCT_ENTRY_POINT(SampleMaski)(0, 0x5U);
    VCT_ENTRY_POINT(Hint)(GL_GENERATE_MIPMAP_HINT, GL_FASTEST);
    for (const GLenum name : {GL_PACK_ALIGNMENT, GL_UNPACK_ALIGNMENT})
        gl::PixelStorei(name, 8);
    for (const GLenum name :
         {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS, GL_UNPACK_ROW_LENGTH,
          GL_UNPACK_IMAGE_HEIGHT, GL_UNPACK_SKIP_PIXELS, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_IMAGES})
        gl::PixelStorei(name, 7);
    ASSERT_EQ(gl::GetError(), GLenum{GL_NO_ERROR});
}

class State : public Embedded {
  protected:
    // A scene that uses all of the library.
    State() {
        described_.scene.instances[1].moves = true;
        described_.scene.meshes[1].deforms = true;
        described_.scene.skyRadiance = {0, 0, 0};
        LightDescription spot;
        spot.type = LightDescription::Type::spot;
        spot.position = {0, 2, 0};
        spot.radius = 0.1F;
        described_.scene.lights = {spot};
        described_.scene.maxLights = 2;
        described_.scene.sky = SkyPicture{16, 8, sky_};
    }
    // Half floats of the picture.
    std::vector<std::uint16_t> halves(unsigned texture) const {
        const gl::Framebuffer framebuffer = [&] {
            const gl::Texture wrapped = gl::Texture::wrapExternal(texture);
            return gl::Framebuffer("to be read", {&wrapped}, nullptr);
        }();
        framebuffer.bind();
        std::vector<std::uint16_t> values(static_cast<std::size_t>(4 * width * height));
        gl::ReadPixels(0, 0, width, height, GL_RGBA, GL_HALF_FLOAT, values.data());
        return values;
    }
    std::vector<float> sky_ = std::vector<float>(std::size_t{16} * 8 * 3, 0.3F);
};

TEST_F(State, IsTheSameAfterEachCallWhateverItWas) {
    const View view = described_.view();
    const std::size_t bytes = described_.positions.size() * sizeof(float);
    const gl::Buffer positions("positions", GL_ARRAY_BUFFER, bytes, described_.positions.data(),
                               GL_STATIC_DRAW),
        normals("normals", GL_ARRAY_BUFFER, bytes, described_.normals.data(), GL_STATIC_DRAW);
    std::vector<std::uint16_t> clean;
    {
        GlobalIllumination light(getProcAddress, described_.scene, optionsOf("mobile"));
        clean = halves(light.render(view).radiance);
    }
    const Bindings bindings;
    changeParameters();
    const GlState before = readGlState();
    EXPECT_GT(before.size(), 150U);
    const auto expectSame = [&](const char* after) {
        for (const auto& [name, values] : readGlState())
            EXPECT_EQ(values, before.at(name)) << name << " after " << after;
        EXPECT_EQ(gl::GetError(), GLenum{GL_NO_ERROR}) << after;
    };
    {
        GlobalIllumination light(getProcAddress, described_.scene, optionsOf("mobile"));
        expectSame("the constructor");
        light.resize(width + 1, height);
        light.resize(width, height);
        expectSame("resize()");
        light.render(view);
        expectSame("render()");
        light.setSun({1, 1, 1});
        light.setTransform(1, {});
        light.setEmission(1, 0.5F);
        light.setVertices(1, {positions.name(), normals.name()}, {{-1, -1, -1}, {1, 1, 1}});
        expectSame("setVertices()");
        light.render(view);
        expectSame("render() of a deformed mesh");
        light.setVisible(1, false);
        light.setSunlight({1, 1, 1}, 2);
        light.setSky(*described_.scene.sky);
        light.addLight({});
        light.setLight(1, described_.scene.lights[0]);
        light.removeLight(1);
        expectSame("a change of the scene");
        light.render(view, GlobalIllumination::Light::converged);
        expectSame("render() after a change");
        EXPECT_THROW(light.resize(0, 0), Error);
        EXPECT_THROW(light.render(view, GBufferTextures{}), Error);
        EXPECT_THROW(light.setVertices(1, {positions.name(), 0}, {}), Error);
        expectSame("an error");
        GlobalIllumination moved = std::move(light);
        expectSame("a move");
    }
    expectSame("the destructor");

    // The first picture is that of a context in its initial state.
    GlobalIllumination light(getProcAddress, described_.scene, optionsOf("mobile"));
    const unsigned radiance = light.render(view).radiance;
    expectSame("a second renderer");
    for (const GLenum name : {GL_PACK_ROW_LENGTH, GL_PACK_SKIP_PIXELS, GL_PACK_SKIP_ROWS})
        gl::PixelStorei(name, 0);
    gl::BindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    // Atomics decide the places of bricks, whose texel coordinates round differently: the last bits may
    // differ.
    const auto found = halves(radiance);
    ASSERT_EQ(found.size(), clean.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        ASSERT_LE(std::abs(static_cast<int>(found[i]) - static_cast<int>(clean[i])), 24) << i;
}

TEST_F(State, APictureThatIsBoundMayBeReplaced) {
    GlobalIllumination light(getProcAddress, described_.scene, optionsOf("mobile"));
    const unsigned radiance = light.render(described_.view()).radiance;
    gl::ActiveTexture(GL_TEXTURE3);
    gl::BindTexture(GL_TEXTURE_2D, radiance);
    light.resize(width / 2, height / 2);
    GLint bound = -1;
    gl::GetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
    EXPECT_TRUE(bound == 0 || gl::IsTexture(static_cast<GLuint>(bound))) << bound;
    EXPECT_EQ(gl::GetError(), GLenum{GL_NO_ERROR});
}

}  // namespace
}  // namespace vct::test
