// Where EGL displays come from, and the words for what EGL says. Internal to this folder.
#pragma once

// No window system: without these EGL/eglplatform.h would include X11's headers.
#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>
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
std::string eglError();

std::string eglString(EGLDisplay display, EGLint name);
bool containsWord(const std::string& words, const std::string& word);

}  // namespace vct::detail
