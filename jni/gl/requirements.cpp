#include "gl/requirements.h"

#include <algorithm>
#include <cctype>

#include "gl/version.h"

namespace vct::gl {
namespace {

// The first versions of OpenGL ES and of desktop OpenGL that include a feature.
struct Core {
    int esMajor, esMinor, desktopMajor, desktopMinor;
};

// A feature of later versions, which earlier ones may have as one of several extensions.
struct Feature {
    std::vector<const char*> extensions;
    Core core;
    bool required;
    const char* neededBy;
};

const Feature features[] = {
    {{"GL_OES_shader_image_atomic"},
     {3, 2, 4, 2},
     true,
     "voxelization and mip levels: image atomics merge fragments of the same voxel; no global illumination "
     "without them"},
    // GL_OES_geometry_shader alone is not enough, because the shaders enable the EXT extension, which the
    // Android Extension Pack requires.
    {{"GL_EXT_geometry_shader"},
     {3, 2, 3, 2},
     false,
     "voxelization in the preset thesis: projects each triangle along its dominant axis; without it the CPU "
     "sorts triangles by axis, which gives the same voxels"},
    {{"GL_OES_sample_variables"},
     {3, 2, 4, 5},
     false,
     "voxelization in the presets mobile and quality: a pixel counts its samples; without it each sample is "
     "a pixel, which takes longer"},
    {{"GL_EXT_color_buffer_half_float", "GL_EXT_color_buffer_float"},
     {3, 2, 3, 0},
     true,
     "G-buffer and output: normals and linear HDR light are drawn into half-float targets"},
    {{"GL_KHR_debug"},
     {3, 2, 4, 3},
     false,
     "debugging: without it passes have no names in RenderDoc, and errors are codes without the driver's "
     "message"},
};

struct Limit {
    GLenum name;
    const char* text;
    GLint minimum;
    bool required;
    const char* neededBy;
};

// The minima are the numbers that the passes use.
constexpr Limit limits[] = {
    {GL_MAX_FRAGMENT_IMAGE_UNIFORMS, "GL_MAX_FRAGMENT_IMAGE_UNIFORMS", 1, true,
     "voxelization: the fragment shader writes the voxel image; no global illumination without it"},
    {GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, "GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS", 2, true,
     "voxelization: the fragment shader appends to the active-voxel list and counts it in the indirect "
     "commands"},
    {GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, "GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS", 3, false,
     "the presets mobile and quality: the fragment shader also adds to the sums of faces"},
    {GL_MAX_COMBINED_SHADER_OUTPUT_RESOURCES, "GL_MAX_COMBINED_SHADER_OUTPUT_RESOURCES", 6, true,
     "placing bricks: three images and three storage buffers in one compute shader"},
    {GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, "GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS", 4, true,
     "mip levels and clearing: read and append the lists of voxels and faces, and write the indirect "
     "commands"},
    {GL_MAX_COMPUTE_IMAGE_UNIFORMS, "GL_MAX_COMPUTE_IMAGE_UNIFORMS", 3, true,
     "clearing: three textures are cleared in one compute shader"},
    {GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS, "GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS", 64, true,
     "mip levels and clearing: work groups of 64 invocations"},
    {GL_MAX_3D_TEXTURE_SIZE, "GL_MAX_3D_TEXTURE_SIZE", 256, true,
     "the voxel grid of 256^3 of the preset thesis"},
    {GL_MAX_3D_TEXTURE_SIZE, "GL_MAX_3D_TEXTURE_SIZE", 1536, false,
     "the voxel grid of 512^3 in the presets mobile and quality, whose texture is three times as wide as the "
     "grid; without it their grids are at most a third of the limit"},
    {GL_MAX_TEXTURE_SIZE, "GL_MAX_TEXTURE_SIZE", 2048, true,
     "material textures, the shadow map and the picture"},
    {GL_MAX_COLOR_ATTACHMENTS, "GL_MAX_COLOR_ATTACHMENTS", 4, true, "G-buffer: up to four colour targets"},
    {GL_MAX_VERTEX_TEXTURE_IMAGE_UNITS, "GL_MAX_VERTEX_TEXTURE_IMAGE_UNITS", 1, true,
     "voxel view: the vertex shader reads its voxel from the 3D texture"},
    {GL_MAX_FRAMEBUFFER_WIDTH, "GL_MAX_FRAMEBUFFER_WIDTH", 512, true,
     "voxelization: draws into a framebuffer without attachments that is as wide as the grid"},
    {GL_MAX_SHADER_STORAGE_BLOCK_SIZE, "GL_MAX_SHADER_STORAGE_BLOCK_SIZE", 1 << 24, true,
     "the active-voxel list: 4 bytes for each of four million occupied voxels"},
};

bool contains(const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

Requirement evaluate(const Feature& feature, const Version& version, const DriverReport& driver) {
    Requirement row;
    for (const char* extension : feature.extensions) {
        row.name += (row.name.empty() ? "" : " or ") + std::string(extension);
        if (!row.met && contains(driver.extensions, extension)) {
            row.met = true;
            row.found = extension;
        }
    }
    // A driver of a version with the feature need not list the extension.
    const Core& core = feature.core;
    if (version.atLeast(core.esMajor, core.esMinor, core.desktopMajor, core.desktopMinor)) {
        row.met = true;
        const int major = version.desktop ? core.desktopMajor : core.esMajor;
        const int minor = version.desktop ? core.desktopMinor : core.esMinor;
        row.found = std::string("core in OpenGL ") + (version.desktop ? "" : "ES ") + std::to_string(major) +
                    "." + std::to_string(minor);
    }
    if (!row.met) row.found = "missing";
    row.required = feature.required;
    row.neededBy = feature.neededBy;
    return row;
}

Requirement evaluate(const Limit& limit, const DriverReport& driver) {
    const GLint found = driver.limit(limit.name);
    return {std::string(limit.text) + " >= " + std::to_string(limit.minimum), std::to_string(found),
            limit.neededBy, limit.required, found >= limit.minimum};
}

Requirement evaluateVersion(const Version& version, const DriverReport& driver) {
    return {"OpenGL ES 3.1 or OpenGL 4.5", driver.version,
            "every pass: compute shaders, images, storage buffers", true, version.atLeast(3, 1, 4, 5)};
}

// ESSL 3.10 needs extensions that a desktop context has in its own language only. So a desktop context needs
// ESSL 3.20, which includes them.
Requirement evaluateLanguage(const Version& version, const DriverReport& driver) {
    const char* found = driver.essl320   ? "#version 320 es"
                        : driver.essl310 ? "#version 310 es"
                                         : "neither compiles";
    return {version.desktop ? "GLSL ES 3.20" : "GLSL ES 3.10", found,
            "every pass: the language of the shaders", true,
            driver.essl320 || (driver.essl310 && !version.desktop)};
}

}  // namespace

std::vector<Requirement> evaluateRequirements(const DriverReport& driver) {
    const Version version = parseVersion(driver.version);
    std::vector<Requirement> rows = {evaluateVersion(version, driver), evaluateLanguage(version, driver)};
    for (const Feature& feature : features)
        rows.push_back(evaluate(feature, version, driver));
    for (const Limit& limit : limits)
        rows.push_back(evaluate(limit, driver));
    return rows;
}

Limits limitsOf(const std::function<GLint(GLenum limit)>& limit) {
    return {limit(GL_MAX_TEXTURE_SIZE), limit(GL_MAX_3D_TEXTURE_SIZE), limit(GL_MAX_FRAMEBUFFER_WIDTH),
            limit(GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS)};
}

bool isSoftwareRenderer(const std::string& renderer) {
    std::string lower;
    for (const char c : renderer)
        lower += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    for (const char* name :
         {"llvmpipe", "softpipe", "lavapipe", "swrast", "software rasterizer", "swiftshader"}) {
        if (lower.find(name) != std::string::npos) return true;
    }
    return false;
}

}  // namespace vct::gl
