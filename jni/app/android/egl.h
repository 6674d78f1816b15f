// The window system in layers, each an owner: display, the surface of a window, context. A surface goes
// whenever the system takes its window; the context, and with it every GL object, stays.
#pragma once

#include <EGL/egl.h>
#include <android/native_window.h>

#include <glm/glm.hpp>

namespace vct::app {

class Display {
  public:
    Display();  // throws vct::Error
    ~Display();
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;

    EGLDisplay get() const { return display_; }
    EGLConfig config() const { return config_; }

  private:
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLConfig config_ = nullptr;
};

class Surface {
  public:
    // Throws vct::Error, also where the window is already gone.
    Surface(const Display& display, ANativeWindow* window);
    ~Surface();
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;

    EGLSurface get() const { return surface_; }
    glm::ivec2 size() const { return size_; }  // pixels
    // False once the window has been turned or resized: drivers differ in when a surface follows, so a new
    // one is made.
    bool fits(ANativeWindow* window) const;

  private:
    EGLDisplay display_;
    EGLSurface surface_ = EGL_NO_SURFACE;
    glm::ivec2 size_{0};
};

class GlContext {
  public:
    // OpenGL ES 3.2, else 3.1, else 3.0: enough to say what is missing. Throws vct::Error. Current on this
    // thread from now on, without a window.
    explicit GlContext(const Display& display);
    ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    // Without a surface (null) GL goes on working, and nothing is shown. Throws gl::ContextLost; returns
    // false where the surface is of no use any more.
    bool makeCurrent(const Surface* surface);

    enum class Shown { yes, surfaceLost, contextLost };
    Shown swap(const Surface& surface);

  private:
    EGLDisplay display_;
    EGLSurface idle_ = EGL_NO_SURFACE;  // 1x1 pixels, never shown
    EGLContext context_ = EGL_NO_CONTEXT;
    EGLSurface current_ = EGL_NO_SURFACE;
};

}  // namespace vct::app
