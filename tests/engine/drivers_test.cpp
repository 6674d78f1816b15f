// Workarounds for faults of real phones, observed in frames and in the shaders, and limits of drivers.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <utility>

#include "engine/material_texture.h"
#include "support/element_buffers.h"
#include "support/errors.h"
#include "support/playing_scene.h"
#include "support/temporary_folder.h"
#include "support/voxel_kinds.h"

namespace vct::test {
namespace {

// Frames in which something moves.
void drawMovingFrames(PlayingScene& stage) {
    for (const double seconds : {0.2, 0.4})
        stage.frameAt(seconds, Output::giConeShadow);
}

class DriverFaultsOfFrames : public testing::TestWithParam<const char*> {
  protected:
    const Context context_ = openContext(Backend::egl);
    const Scene scene_ = load(twoThatMove());
    PlayingScene stage_{context_, scene_, smallPreset(GetParam())};
};
INSTANTIATE_TEST_SUITE_P(Voxels, DriverFaultsOfFrames, everyVoxelKind(), nameOfPreset);

TEST_P(DriverFaultsOfFrames, ElementsAreBoundAfterTheirVertexArray) {
    stage_.frameAt(0.0);
    const ElementBufferCheck elements;
    drawMovingFrames(stage_);
    EXPECT_GT(elements.uses, 0);
}

TEST_P(DriverFaultsOfFrames, NoBufferIsCopiedToAfterAShaderUsedIt) {
    stage_.frameAt(0.0);
    std::set<GLuint> used;
    GLuint target = 0;
    const GlSpy<&gl::BindBufferBase> bindings([&](GLenum, GLuint, GLuint buffer) { used.insert(buffer); });
    const GlSpy<&gl::BindBuffer> targets([&](GLenum kind, GLuint buffer) {
        if (kind == GL_COPY_WRITE_BUFFER) target = buffer;
    });
    const GlSpy<&gl::CopyBufferSubData> copies(
        [&](GLenum, GLenum, GLintptr, GLintptr, GLsizeiptr) { EXPECT_EQ(used.count(target), 0U); });
    drawMovingFrames(stage_);
    EXPECT_FALSE(used.empty());
}

// The texels of a level as sRGB codes.
std::vector<std::uint8_t> levelOf(const gl::Texture& texture, int level) {
    const gl::Framebuffer framebuffer("read", {&texture}, nullptr, level);
    const int width = std::max(texture.width() >> level, 1), height = std::max(texture.height() >> level, 1);
    framebuffer.bind();
    gl::ReadBuffer(GL_COLOR_ATTACHMENT0);
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) * height * 4);
    gl::PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl::ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    return rgba;
}

// The driver makes the mip levels of the same texture lying on its side.
TEST(DriverFaultsOfTextures, MipsOfPortraitTexturesAreMadeWithoutTheDriver) {
    const Context context = openContext(Backend::egl);
    int mipsByDriver = 0;
    const GlSpy<&gl::GenerateMipmap> mips([&](GLenum) { ++mipsByDriver; });
    vct::Texture upright, lying;
    upright.width = lying.height = 16;
    upright.height = lying.width = 64;
    std::vector<std::uint8_t> standing(16 * 64 * 4), turned(standing);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 16; ++x)
            for (int c = 0; c < 4; ++c)
                standing[(y * 16 + x) * 4 + c] = turned[(x * 64 + y) * 4 + c] =
                    static_cast<std::uint8_t>((x * 37 + y * 101 + c * 59 + x * y * 13) & 255);
    upright.rgba = standing;
    lying.rgba = turned;
    const gl::Texture made = materialTexture(upright);
    EXPECT_EQ(mipsByDriver, 0);
    const gl::Texture driversOwn = materialTexture(lying);
    EXPECT_EQ(mipsByDriver, 1);
    ASSERT_EQ(made.levels(), 7);
    for (int level = 0; level < made.levels(); ++level) {
        const int width = std::max(16 >> level, 1), height = std::max(64 >> level, 1);
        const std::vector<std::uint8_t> ours = levelOf(made, level), theirs = levelOf(driversOwn, level);
        int worst = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                for (int c = 0; c < 4; ++c)
                    worst = std::max(
                        worst, std::abs(ours[(y * width + x) * 4 + c] - theirs[(x * height + y) * 4 + c]));
        EXPECT_LE(worst, level == 0 ? 0 : 2) << "level " << level;
    }
}

// Some drivers compute a wrong result for the bitwise and of a vector.
TEST(DriverFaultsOfShaders, NoShaderMasksAVector) {
    // A swizzle of several components or a constructor of a vector stands before the operator.
    const std::regex mask(R"((\.[xyzwrgba]{2,4}|[iu]vec[234]\([^()]*(\([^()]*\)[^()]*)*\))\)* & )");
    for (const char* wrong :
         {"(uvec3(word) >> uvec3(16, 8, 0)) & 255u", "(axis == 0 ? voxel.yz : voxel.xy) & 3", "steps.yz & 3",
          "uvec3(f(h), 0, 0) & 1u"})
        EXPECT_TRUE(std::regex_search(wrong, mask)) << wrong;
    for (const char* right : {"listed.face & 1", "uvec3(h & 1023u, 0, 0)", "voxel[axis] & 3"})
        EXPECT_FALSE(std::regex_search(right, mask)) << right;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(VCT_SOURCE_DIR "/shaders")) {
        if (!entry.is_regular_file()) continue;
        const std::string text = readBytes(entry.path().string());
        std::smatch found;
        EXPECT_FALSE(std::regex_search(text, found, mask)) << entry.path() << ": " << found.str();
    }
}

GLint limitOf(GLenum name) {
    GLint limit = 0;
    gl::GetIntegerv(name, &limit);
    return limit;
}

TEST(DriverLimits, ATextureThatIsTooLargeIsNamed) {
    const Context context = openContext(Backend::egl);
    const int side2d = limitOf(GL_MAX_TEXTURE_SIZE), side3d = limitOf(GL_MAX_3D_TEXTURE_SIZE);
    expectMentions(errorOf([&] { gl::Texture::make2d("wide", GL_RGBA8, side2d + 1, 1); }),
                   {"wide", std::to_string(side2d + 1), std::to_string(side2d), "smaller"});
    expectMentions(errorOf([&] { gl::Texture::make3d("deep", GL_RGBA8, 1, 1, side3d + 1, 1); }),
                   {"deep", std::to_string(side3d + 1), std::to_string(side3d), "coarser grid"});
    EXPECT_NO_THROW(gl::Texture::make2d("as wide as can be", GL_RGBA8, side2d, 1));
    EXPECT_EQ(gl::GetError(), static_cast<GLenum>(GL_NO_ERROR));
}

GLenum GL_APIENTRY outOfMemory() {
    return GL_OUT_OF_MEMORY;
}

// Many drivers limit the size of a texture in bytes, and tell it by no query.
TEST(DriverLimits, ATextureThatTheDriverRefusesIsNotBlamedOnTheMemory) {
    const Context context = openContext(Backend::egl);
    const auto getError = std::exchange(gl::GetError, outOfMemory);
    const std::string error = errorOf([&] { gl::Texture::make3d("voxel faces", GL_RGBA8, 8, 8, 8, 1); });
    gl::GetError = getError;
    expectMentions(error, {"the driver refuses voxel faces (1 MB)", "MB of main memory are free",
                           "more than the driver allows in one piece", "coarser grid"});
}

TEST(DriverLimits, AStorageBufferThatIsTooLargeIsNamed) {
    const Context context = openContext(Backend::egl);
    const auto most = static_cast<std::size_t>(limitOf(GL_MAX_SHADER_STORAGE_BLOCK_SIZE));
    const std::string error =
        errorOf([&] { gl::Buffer("list", GL_SHADER_STORAGE_BUFFER, most + 4, nullptr, GL_STATIC_DRAW); });
    expectMentions(error, {"list", "GL_MAX_SHADER_STORAGE_BLOCK_SIZE", "use a coarser grid"});
}

// The driver with smaller storage blocks.
decltype(gl::GetIntegerv) driversOwn = nullptr;
void GL_APIENTRY withSmallBlocks(GLenum name, GLint* value) {
    driversOwn(name, value);
    if (name == GL_MAX_SHADER_STORAGE_BLOCK_SIZE) *value = 1 << 18;
}

TEST(DriverLimits, MoreFacesThanAStorageBlockHoldsAreRefused) {
    const Context context = openContext(Backend::egl);
    const Scene scene = loadGltf(asset("cornell.glb"));
    Settings settings = mobileAt(16);
    settings.activeVoxelLimit = 25000;
    Renderer renderer = makeRenderer(context, scene, scene.lights.front(), settings);
    driversOwn = gl::GetIntegerv;
    gl::GetIntegerv = withSmallBlocks;
    const std::string error = errorOf([&] { renderer.render({{Output::gi}, scene.cameras.front()}); });
    gl::GetIntegerv = driversOwn;
    expectMentions(error,
                   {"voxel faces and lists", "GL_MAX_SHADER_STORAGE_BLOCK_SIZE", "use a coarser grid"});
    EXPECT_NO_THROW(renderer.render({{Output::gi}, scene.cameras.front()}))
        << "and nothing is left half made";
}

}  // namespace
}  // namespace vct::test
