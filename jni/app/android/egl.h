// Owners of EGL's objects: the display, the surface of a window, the context. A surface is destroyed whenever
// the system takes the window away; the context and its GL objects stay.
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
    // Throws vct::Error, for example if the window no longer exists.
    Surface(const Display& display, ANativeWindow* window);
    ~Surface();
    Surface(const Surface&) = delete;
    Surface& operator=(const Surface&) = delete;

    EGLSurface get() const { return surface_; }
    glm::ivec2 size() const { return size_; }  // pixels
    // False after the window was rotated or resized. Drivers differ in when a surface follows the new size,
    // so the caller makes a new one.
    bool fits(ANativeWindow* window) const;

  private:
    EGLDisplay display_;
    EGLSurface surface_ = EGL_NO_SURFACE;
    glm::ivec2 size_{0};
};

class GlContext {
  public:
    // Creates an OpenGL ES context of version 3.2, 3.1 or 3.0, whichever is the highest possible; 3.0 is
    // enough to show what is missing. Makes it current on this thread, without a window. Throws vct::Error.
    explicit GlContext(const Display& display);
    ~GlContext();
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;

    // Makes the context current with this surface, or with none (null): then GL calls work, but nothing is
    // shown. Returns false if the surface can no longer be used. Throws gl::ContextLost.
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
