#include "window.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <stdexcept>
#ifdef EMBED_HAS_GLFW
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#endif

namespace {

void openWithoutWindow() {
    const EGLDisplay display =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 1, EGL_NONE};
    if (eglInitialize(display, nullptr, nullptr) != EGL_TRUE || eglBindAPI(EGL_OPENGL_ES_API) != EGL_TRUE ||
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE,
                       eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes)) != EGL_TRUE)
        throw std::runtime_error("EGL gives no context of OpenGL ES 3.1 without a window");
}

}  // namespace

void* Window::getProcAddress(const char* name) {
    return reinterpret_cast<void*>(eglGetProcAddress(name));
}

#ifdef EMBED_HAS_GLFW
Window::Window(int framesWithoutWindow) : framesLeft_(framesWithoutWindow) {
    if (framesWithoutWindow > 0) {
        openWithoutWindow();
        return;
    }
    if (glfwInit() == GLFW_FALSE) throw std::runtime_error("GLFW finds no display; try --headless");
    glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
    glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 1);
    window_ = glfwCreateWindow(2 * width_, 2 * height_, "vct::GlobalIllumination", nullptr, nullptr);
    if (window_ == nullptr) throw std::runtime_error("GLFW gives no window with OpenGL ES 3.1");
    glfwMakeContextCurrent(window_);
    glfwGetFramebufferSize(window_, &width_, &height_);
}

Window::~Window() {
    if (window_ != nullptr) glfwTerminate();
}

bool Window::next() {
    if (window_ == nullptr) return framesLeft_-- > 0;
    glfwSwapBuffers(window_);
    glfwPollEvents();
    glfwGetFramebufferSize(window_, &width_, &height_);
    return glfwWindowShouldClose(window_) == GLFW_FALSE;
}
#else
Window::Window(int framesWithoutWindow) : framesLeft_(framesWithoutWindow) {
    if (framesWithoutWindow == 0) throw std::runtime_error("built without GLFW: only --headless works");
    openWithoutWindow();
}

Window::~Window() = default;

bool Window::next() {
    return framesLeft_-- > 0;
}
#endif
