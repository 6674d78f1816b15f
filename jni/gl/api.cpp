#include "gl/api.h"

#include <algorithm>

#include "core/error.h"
#include "gl/version.h"

namespace vct::gl {

#define VCT_GL_DEFINE(NAME) decltype(&::gl##NAME) NAME = nullptr;
VCT_GL_FUNCTIONS(VCT_GL_DEFINE)
VCT_GL_OPTIONAL_FUNCTIONS(VCT_GL_DEFINE)
#undef VCT_GL_DEFINE
PFNGLGETQUERYOBJECTUI64VEXTPROC GetQueryObjectui64v = nullptr;
PFNGLCLIPCONTROLEXTPROC ClipControl = nullptr;

std::string glString(GLenum name) {
    const GLubyte* text = GetString(name);
    return text ? reinterpret_cast<const char*>(text) : "unknown";
}

std::vector<std::string> extensionNames() {
    GLint count = 0;
    GetIntegerv(GL_NUM_EXTENSIONS, &count);
    std::vector<std::string> names;
    for (GLint i = 0; i < count; ++i) {
        const GLubyte* name = GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
        if (name) names.emplace_back(reinterpret_cast<const char*>(name));
    }
    return names;
}

void load(Proc (*getProcAddress)(const char* name, const void* user), const void* user) {
    std::string missing;
#define VCT_GL_LOAD(NAME)                                                      \
    NAME = reinterpret_cast<decltype(NAME)>(getProcAddress("gl" #NAME, user)); \
    if (!NAME) missing += missing.empty() ? "gl" #NAME : ", gl" #NAME;
    VCT_GL_FUNCTIONS(VCT_GL_LOAD)
#undef VCT_GL_LOAD
    if (!missing.empty())
        throw Error("the GL driver lacks " + missing + "; use one with OpenGL ES 3.1 or desktop OpenGL 4.5");

    if (!GetString(GL_VERSION))
        throw Error(
            "no GL context is current in this thread (glGetString(GL_VERSION) is null); make one current "
            "first, of OpenGL ES 3.1 or desktop OpenGL 4.5, and give the getProcAddress that belongs to it");

    // Drivers return stubs for entry points that the context does not have, so a pointer that is not null
    // does not mean that KHR_debug exists. In ES 3.1 it is an extension with a suffix.
    const Version version = parseVersion(glString(GL_VERSION));
    const std::vector<std::string> extensions = extensionNames();
    const auto hasExtension = [&](const char* name) {
        return std::find(extensions.begin(), extensions.end(), name) != extensions.end();
    };
    const bool core = version.atLeast(3, 2, 4, 3);
    const bool extension = !core && hasExtension("GL_KHR_debug");
    const std::string suffix = extension && !version.desktop ? "KHR" : "";
#define VCT_GL_LOAD_OPTIONAL(NAME)                                                                     \
    NAME = core || extension                                                                           \
               ? reinterpret_cast<decltype(NAME)>(getProcAddress(("gl" #NAME + suffix).c_str(), user)) \
               : nullptr;
    VCT_GL_OPTIONAL_FUNCTIONS(VCT_GL_LOAD_OPTIONAL)
#undef VCT_GL_LOAD_OPTIONAL

    GetQueryObjectui64v = nullptr;
    if (hasExtension("GL_EXT_disjoint_timer_query"))
        GetQueryObjectui64v =
            reinterpret_cast<decltype(GetQueryObjectui64v)>(getProcAddress("glGetQueryObjectui64vEXT", user));
    ClipControl = nullptr;
    if (version.desktop || hasExtension("GL_EXT_clip_control"))
        ClipControl = reinterpret_cast<decltype(ClipControl)>(
            getProcAddress(version.desktop ? "glClipControl" : "glClipControlEXT", user));
}

}  // namespace vct::gl
