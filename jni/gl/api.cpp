#include "gl/api.h"

#include <cstring>
#include <string>

#include "core/error.h"
#include "gl/version.h"

namespace vct::gl {

#define VCT_GL_DEFINE(NAME) decltype(&::gl##NAME) NAME = nullptr;
VCT_GL_FUNCTIONS(VCT_GL_DEFINE)
VCT_GL_OPTIONAL_FUNCTIONS(VCT_GL_DEFINE)
#undef VCT_GL_DEFINE
PFNGLGETQUERYOBJECTUI64VEXTPROC GetQueryObjectui64v = nullptr;

namespace {

std::string currentVersion() {
    const GLubyte* text = GetString(GL_VERSION);
    return text ? reinterpret_cast<const char*>(text) : "";
}

bool hasExtension(const char* name) {
    GLint count = 0;
    GetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const GLubyte* extension = GetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
        if (extension && std::strcmp(reinterpret_cast<const char*>(extension), name) == 0) return true;
    }
    return false;
}

}  // namespace

void load(Proc (*getProcAddress)(const char* name, const void* user), const void* user) {
    std::string missing;
#define VCT_GL_LOAD(NAME)                                                      \
    NAME = reinterpret_cast<decltype(NAME)>(getProcAddress("gl" #NAME, user)); \
    if (!NAME) missing += missing.empty() ? "gl" #NAME : ", gl" #NAME;
    VCT_GL_FUNCTIONS(VCT_GL_LOAD)
#undef VCT_GL_LOAD
    if (!missing.empty())
        throw Error("the GL driver lacks " + missing + ": OpenGL ES 3.1 or desktop OpenGL 4.5 is needed");

    // Drivers hand out stubs for entry points that the context does not have, so whether KHR_debug is there
    // is asked of the context and not read from a null pointer. In ES 3.1 it is an extension with a suffix.
    const Version version = parseVersion(currentVersion());
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
}

}  // namespace vct::gl
