// Where EGL displays come from. Internal to this folder.
#pragma once

#include "platform/egl_error.h"

#include <EGL/eglext.h>

#include <string>
#include <vector>

namespace vct::detail {

// One place where a display can come from.
struct EglSource {
    std::string name;
    EGLenum platform = EGL_NONE;  // none: eglGetDisplay
    void* native = nullptr;
};

// In the order in which they are to be tried; only the one device where an index is given.
std::vector<EglSource> eglSources(int device);

// Throws vct::Error where the source has none.
EGLDisplay openEglDisplay(const EglSource& source);

// The last error's name; clears it.
inline std::string eglError() {
    return eglErrorName(eglGetError());
}

std::string eglString(EGLDisplay display, EGLint name);
bool containsWord(const std::string& words, const std::string& word);

}  // namespace vct::detail
