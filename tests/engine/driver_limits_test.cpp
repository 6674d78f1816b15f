// A resource that is larger than the driver allows is an error that names it and the limit.
#include <gtest/gtest.h>

#include "support/errors.h"
#include "support/renderers.h"

namespace vct::test {
namespace {

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

TEST(DriverLimits, AStorageBufferThatIsTooLargeIsNamed) {
    const Context context = openContext(Backend::egl);
    const auto most = static_cast<std::size_t>(limitOf(GL_MAX_SHADER_STORAGE_BLOCK_SIZE));
    const auto make = [&](GLenum target) {
        return errorOf([&] { gl::Buffer("list", target, most + 4, nullptr, GL_STATIC_DRAW); });
    };
    expectMentions(make(GL_SHADER_STORAGE_BUFFER),
                   {"list", "GL_MAX_SHADER_STORAGE_BLOCK_SIZE", "use a coarser grid"});
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
                   {"voxel faces' sums and lists", "GL_MAX_SHADER_STORAGE_BLOCK_SIZE", "use a coarser grid"});
    EXPECT_NO_THROW(renderer.render({{Output::gi}, scene.cameras.front()}))
        << "and nothing is left half made";
}

}  // namespace
}  // namespace vct::test
