#include "gl/capabilities.h"

#include <gtest/gtest.h>

#include <map>

#include "gl/debug.h"
#include "gl/requirements.h"
#include "platform/contexts.h"
#include "support/errors.h"

namespace vct::gl {
namespace {

// A driver with exactly what is required: without any one thing, something is missing.
struct MadeUpDriver {
    std::string version = "OpenGL ES 3.1 made up";
    std::vector<std::string> extensions = {"GL_OES_shader_image_atomic", "GL_EXT_geometry_shader",
                                           "GL_EXT_color_buffer_half_float", "GL_KHR_debug"};
    bool essl310 = true, essl320 = false;
    std::map<GLenum, GLint> limits = {
        {GL_MAX_FRAGMENT_IMAGE_UNIFORMS, 1},
        {GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, 3},
        {GL_MAX_COMBINED_SHADER_OUTPUT_RESOURCES, 5},
        {GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, 4},
        {GL_MAX_COMPUTE_IMAGE_UNIFORMS, 2},
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

std::string complaint(const Capabilities& capabilities) {
    return test::errorOf([&] { capabilities.requireAll(); });
}

std::vector<std::string> unmet(const Capabilities& capabilities) {
    std::vector<std::string> names;
    for (const Requirement& row : capabilities.requirements) {
        if (!row.met) names.push_back(row.name);
    }
    return names;
}

TEST(Requirements, JustEnoughIsEnough) {
    const Capabilities capabilities = MadeUpDriver().evaluate();
    EXPECT_TRUE(unmet(capabilities).empty());
    EXPECT_EQ(complaint(capabilities), "");
    test::expectMentions(describe(capabilities), {"Nothing is missing"});
}

TEST(Requirements, EachExtensionIsMissedOnItsOwn) {
    for (size_t i = 0; i < MadeUpDriver().extensions.size(); ++i) {
        MadeUpDriver driver;
        const std::string name = driver.extensions[i];
        driver.extensions.erase(driver.extensions.begin() + static_cast<std::ptrdiff_t>(i));
        const auto missing = unmet(driver.evaluate());
        ASSERT_EQ(missing.size(), 1u) << name;
        test::expectMentions(missing[0], {name});
    }
}

TEST(Requirements, EachLimitIsMissedByOne) {
    for (const auto& [limit, enough] : MadeUpDriver().limits) {
        MadeUpDriver driver;
        driver.limits[limit] = enough - 1;
        EXPECT_EQ(unmet(driver.evaluate()).size(), 1u) << std::hex << limit;
    }
}

TEST(Requirements, EverythingMissingIsNamedAtOnce) {
    MadeUpDriver driver;
    driver.extensions.clear();
    for (auto& [name, value] : driver.limits)
        value = 0;
    driver.essl310 = false;
    const Capabilities capabilities = driver.evaluate();
    const std::string text = complaint(capabilities);
    size_t required = 0;
    for (const Requirement& row : capabilities.requirements) {
        if (!row.required || row.met) continue;
        ++required;
        test::expectMentions(text, {row.name, row.neededBy});
    }
    EXPECT_EQ(required, 15u);  // all but the version itself
    test::expectMentions(text, {"Made-up 9000"});
}

TEST(Requirements, WhatIsOptionalIsDescribedAndDoesNotStopAnything) {
    MadeUpDriver driver;
    driver.extensions.pop_back();  // GL_KHR_debug
    driver.limits[GL_MAX_3D_TEXTURE_SIZE] = 256;
    const Capabilities capabilities = driver.evaluate();
    EXPECT_EQ(complaint(capabilities), "");
    test::expectMentions(describe(capabilities),
                         {"absent  GL_KHR_debug", "absent  GL_MAX_3D_TEXTURE_SIZE >= 1536", "512^3"});
}

TEST(Requirements, FullFloatTargetsDoInPlaceOfHalfFloatOnes) {
    MadeUpDriver driver;
    driver.extensions[2] = "GL_EXT_color_buffer_float";
    EXPECT_EQ(complaint(driver.evaluate()), "");
}

TEST(Requirements, LaterVersionsNeedNoExtensions) {
    for (const char* version : {"OpenGL ES 3.2 made up", "4.5 (Core Profile) made up"}) {
        MadeUpDriver driver;
        driver.version = version;
        driver.extensions.clear();
        driver.essl320 = true;
        EXPECT_TRUE(unmet(driver.evaluate()).empty()) << version;
    }
}

TEST(Requirements, TooOldAVersionIsMissedWhateverItsExtensions) {
    for (const char* version : {"OpenGL ES 3.0 made up", "3.3 (Core Profile) made up", ""}) {
        MadeUpDriver driver;
        driver.version = version;
        driver.essl320 = true;
        EXPECT_EQ(unmet(driver.evaluate()).size(), 1u) << version;
    }
}

TEST(Requirements, ADesktopContextMustCompileEssl320) {
    MadeUpDriver driver;
    driver.version = "4.6 made up";
    EXPECT_EQ(unmet(driver.evaluate()), std::vector<std::string>{"GLSL ES 3.20"});
}

TEST(Requirements, SoftwareRenderersAreKnown) {
    EXPECT_TRUE(isSoftwareRenderer("llvmpipe (LLVM 15.0.6, 256 bits)"));
    EXPECT_TRUE(isSoftwareRenderer("zink (llvmpipe (LLVM 15.0.6, 256 bits))"));
    EXPECT_TRUE(isSoftwareRenderer("softpipe"));
    EXPECT_FALSE(isSoftwareRenderer("Mali-G78"));
    EXPECT_FALSE(isSoftwareRenderer("zink (NVIDIA H200)"));
}

class CapabilitiesOf : public testing::TestWithParam<Backend> {};

TEST_P(CapabilitiesOf, TheDriverHereAreEnough) {
    VCT_SKIP_IF_ABSENT(GetParam());
    const auto platform = test::createContext(GetParam());
    installDebugCallback();
    const Capabilities capabilities = queryCapabilities();
    EXPECT_NO_THROW(checkErrors("queryCapabilities"));
    EXPECT_EQ(complaint(capabilities), "");
    EXPECT_EQ(capabilities.desktopContext, GetParam() == Backend::osmesa);
    EXPECT_TRUE(capabilities.debugOutput);
    EXPECT_GE(capabilities.uniformBufferOffsetAlignment, 1);
    EXPECT_EQ(capabilities.softwareDriver, isSoftwareRenderer(capabilities.renderer));
}

INSTANTIATE_TEST_SUITE_P(Capabilities, CapabilitiesOf,
                         testing::Values(Backend::egl, Backend::osmesa, Backend::zink),
                         [](const auto& test) { return std::string(backendName(test.param)); });

}  // namespace
}  // namespace vct::gl
