#include "gl/capabilities.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>

#include "gl/requirements.h"
#include "support/errors.h"

namespace vct::gl {
namespace {

// A driver with exactly what is required: without any one thing, something is missing.
struct MadeUpDriver {
    std::string version = "OpenGL ES 3.1 made up";
    std::vector<std::string> extensions = {"GL_OES_shader_image_atomic", "GL_EXT_geometry_shader",
                                           "GL_EXT_color_buffer_half_float", "GL_KHR_debug",
                                           "GL_OES_sample_variables"};
    bool essl310 = true, essl320 = false;
    std::map<GLenum, GLint> limits = {
        {GL_MAX_FRAGMENT_IMAGE_UNIFORMS, 1},
        {GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, 3},
        {GL_MAX_COMBINED_SHADER_OUTPUT_RESOURCES, 6},
        {GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, 4},
        {GL_MAX_COMPUTE_IMAGE_UNIFORMS, 3},
        {GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS, 64},
        {GL_MAX_3D_TEXTURE_SIZE, 1536},
        {GL_MAX_TEXTURE_SIZE, 2048},
        {GL_MAX_COLOR_ATTACHMENTS, 4},
        {GL_MAX_VERTEX_TEXTURE_IMAGE_UNITS, 1},
        {GL_MAX_FRAMEBUFFER_WIDTH, 512},
        {GL_MAX_SHADER_STORAGE_BLOCK_SIZE, 1 << 24},
    };

    Capabilities evaluate() const {
        Capabilities result;
        result.renderer = "Made-up 9000";
        result.version = version;
        const auto limit = [this](GLenum name) {
            const auto found = limits.find(name);
            return found == limits.end() ? 0 : found->second;
        };
        result.requirements = evaluateRequirements({version, extensions, essl310, essl320, limit});
        return result;
    }
};

using Change = std::function<void(MadeUpDriver&)>;

Capabilities after(const Change& change) {
    MadeUpDriver driver;
    change(driver);
    return driver.evaluate();
}

std::string errorAfter(const Change& change) {
    return test::errorOf([&] { after(change).requireAll(); });
}

std::vector<std::string> unmetAfter(const Change& change) {
    std::vector<std::string> names;
    for (const Requirement& row : after(change).requirements)
        if (!row.met) names.push_back(row.name);
    return names;
}

TEST(Requirements, EachExtensionAndLimitIsNamedAlone) {
    const Change nothing = [](MadeUpDriver&) {};
    EXPECT_TRUE(unmetAfter(nothing).empty());
    EXPECT_EQ(errorAfter(nothing), "");
    for (const std::string& name : MadeUpDriver().extensions) {
        const auto missing = unmetAfter([&](MadeUpDriver& driver) {
            driver.extensions.erase(std::find(driver.extensions.begin(), driver.extensions.end(), name));
        });
        ASSERT_EQ(missing.size(), 1u) << name;
        test::expectMentions(missing[0], {name});
    }
    for (const auto& [limit, enough] : MadeUpDriver().limits) {
        const auto missing = unmetAfter([&](MadeUpDriver& driver) { driver.limits[limit] = enough - 1; });
        EXPECT_EQ(missing.size(), 1u) << std::hex << limit;
    }
}

TEST(Requirements, TheAndroidExtensionPackIsNotRequired) {
    const auto withoutPack = [](MadeUpDriver& driver) {
        driver.extensions = {"GL_OES_shader_image_atomic", "GL_EXT_color_buffer_half_float"};
    };
    EXPECT_EQ(errorAfter(withoutPack), "");
    EXPECT_EQ(unmetAfter(withoutPack), (std::vector<std::string>{"GL_EXT_geometry_shader",
                                                                 "GL_OES_sample_variables", "GL_KHR_debug"}));
}

TEST(Requirements, FloatTargetsMayReplaceHalfFloatOnes) {
    EXPECT_EQ(errorAfter([](MadeUpDriver& d) { d.extensions[2] = "GL_EXT_color_buffer_float"; }), "");
}

TEST(Requirements, LaterVersionsNeedNoExtensionsAndEarlierOnesAreRefused) {
    const auto unmetBy = [](const char* version, bool extensions, bool essl320 = true) {
        return unmetAfter([&](MadeUpDriver& driver) {
            driver.version = version;
            driver.essl320 = essl320;
            if (!extensions) driver.extensions.clear();
        });
    };
    for (const char* version : {"OpenGL ES 3.2 made up", "4.5 (Core Profile) made up"})
        EXPECT_TRUE(unmetBy(version, false).empty()) << version;
    for (const char* version : {"OpenGL ES 3.0 made up", "3.3 (Core Profile) made up", ""})
        EXPECT_EQ(unmetBy(version, true).size(), 1u) << version;
    EXPECT_EQ(unmetBy("4.6 made up", true, false), std::vector<std::string>{"GLSL ES 3.20"});
}

TEST(Requirements, SoftwareRenderersAreKnown) {
    EXPECT_TRUE(isSoftwareRenderer("llvmpipe (LLVM 15.0.6, 256 bits)"));
    EXPECT_TRUE(isSoftwareRenderer("zink (llvmpipe (LLVM 15.0.6, 256 bits))"));
    EXPECT_TRUE(isSoftwareRenderer("softpipe"));
    EXPECT_FALSE(isSoftwareRenderer("Mali-G78"));
    EXPECT_FALSE(isSoftwareRenderer("zink (NVIDIA H200)"));
}

}  // namespace
}  // namespace vct::gl
