#include "app/android/egl.h"

#include <algorithm>
#include <array>

#include "core/error.h"
#include "gl/debug.h"
#include "platform/egl_error.h"

namespace vct::app {

namespace {

constexpr const char* remedy = "; restart the device, or try another one";

}  // namespace

Display::Display() : display_(eglGetDisplay(EGL_DEFAULT_DISPLAY)) {
    if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr))
        throw Error("cannot open the EGL display: " + eglErrorName(eglGetError()) + remedy);
    // The window needs no depth buffer, because the passes have depth targets of their own.
    const EGLint attributes[][2] = {{EGL_SURFACE_TYPE, EGL_WINDOW_BIT | EGL_PBUFFER_BIT},
                                    {EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT},
                                    {EGL_RED_SIZE, 8},
                                    {EGL_GREEN_SIZE, 8},
                                    {EGL_BLUE_SIZE, 8},
                                    {EGL_ALPHA_SIZE, 0},
                                    {EGL_NONE, 0}};
    std::array<EGLConfig, 64> configs{};
    EGLint count = 0;
    if (!eglChooseConfig(display_, attributes[0], configs.data(), static_cast<EGLint>(configs.size()),
                         &count))
        count = 0;
    // EGL takes the sizes as minimums and sorts configurations with more bits first, so 8 bits must be
    // searched for.
    const auto end = configs.begin() + count;
    const auto found = std::find_if(configs.begin(), end, [this](EGLConfig config) {
        EGLint red = 0;
        return eglGetConfigAttrib(display_, config, EGL_RED_SIZE, &red) && red == 8;
    });
    if (found == end) {
        const EGLint error = eglGetError();
        eglTerminate(display_);
        throw Error("EGL has no configuration with 8 bits per colour for OpenGL ES 3 in a window: " +
                    eglErrorName(error) + remedy);
    }
    config_ = *found;
}

Display::~Display() {
    eglTerminate(display_);
}

Surface::Surface(const Display& display, ANativeWindow* window)
    : display_(display.get()), size_(ANativeWindow_getWidth(window), ANativeWindow_getHeight(window)) {
    surface_ = eglCreateWindowSurface(display_, display.config(), window, nullptr);
    if (surface_ == EGL_NO_SURFACE)
        throw Error("the window cannot be drawn into: " + eglErrorName(eglGetError()) + remedy);
}

Surface::~Surface() {
    eglDestroySurface(display_, surface_);
}

bool Surface::fits(ANativeWindow* window) const {
    return size_ == glm::ivec2(ANativeWindow_getWidth(window), ANativeWindow_getHeight(window));
}

GlContext::GlContext(const Display& display) : display_(display.get()) {
    for (const EGLint minor : {2, 1, 0}) {
        const std::array<EGLint, 5> attributes{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, minor,
                                               EGL_NONE};
        if (context_ == EGL_NO_CONTEXT)
            context_ = eglCreateContext(display_, display.config(), EGL_NO_CONTEXT, attributes.data());
    }
    if (context_ == EGL_NO_CONTEXT)
        throw Error("cannot create an OpenGL ES 3 context: " + eglErrorName(eglGetError()) +
                    "; this device cannot run the app");
    const std::array<EGLint, 5> onePixel{EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    idle_ = eglCreatePbufferSurface(display_, display.config(), onePixel.data());
    if (idle_ == EGL_NO_SURFACE || !eglMakeCurrent(display_, idle_, idle_, context_)) {
        const EGLint error = eglGetError();
        if (idle_ != EGL_NO_SURFACE) eglDestroySurface(display_, idle_);
        eglDestroyContext(display_, context_);
        throw Error("cannot use the OpenGL ES context: " + eglErrorName(error) + remedy);
    }
    current_ = idle_;
}

GlContext::~GlContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroySurface(display_, idle_);
    eglDestroyContext(display_, context_);
}

bool GlContext::makeCurrent(const Surface* surface) {
    const EGLSurface target = surface != nullptr ? surface->get() : idle_;
    if (target == current_) return true;
    if (eglMakeCurrent(display_, target, target, context_)) {
        current_ = target;
        return true;
    }
    const EGLint error = eglGetError();
    if (error == EGL_CONTEXT_LOST || surface == nullptr)
        throw gl::ContextLost("eglMakeCurrent: " + eglErrorName(error));
    return false;
}

GlContext::Shown GlContext::swap(const Surface& surface) {
    if (eglSwapBuffers(display_, surface.get())) return Shown::yes;
    return eglGetError() == EGL_CONTEXT_LOST ? Shown::contextLost : Shown::surfaceLost;
}

}  // namespace vct::app
