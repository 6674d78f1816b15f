// Names of EGL errors, for the contexts of the command line and of the app.
#pragma once

// These keep EGL/eglplatform.h from including X11's headers.
#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>

#include <iterator>
#include <string>

namespace vct {

inline std::string eglErrorName(EGLint error) {
    // The names are in the order of their values, from EGL_SUCCESS on.
    constexpr const char* names[] = {"EGL_SUCCESS",       "EGL_NOT_INITIALIZED",     "EGL_BAD_ACCESS",
                                     "EGL_BAD_ALLOC",     "EGL_BAD_ATTRIBUTE",       "EGL_BAD_CONFIG",
                                     "EGL_BAD_CONTEXT",   "EGL_BAD_CURRENT_SURFACE", "EGL_BAD_DISPLAY",
                                     "EGL_BAD_MATCH",     "EGL_BAD_NATIVE_PIXMAP",   "EGL_BAD_NATIVE_WINDOW",
                                     "EGL_BAD_PARAMETER", "EGL_BAD_SURFACE",         "EGL_CONTEXT_LOST"};
    const auto index = static_cast<unsigned>(error - EGL_SUCCESS);
    return index < std::size(names) ? names[index] : "EGL error " + std::to_string(error);
}

}  // namespace vct
