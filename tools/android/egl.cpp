// A stand-in for Android's libEGL.so: the host's EGL and OpenGL ES. A window is a buffer in memory.
#include <EGL/egl.h>
#include <GLES3/gl31.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <utility>

#include "host.h"
#include "stand_in.h"

using stand_in::reportMisuse;
using stand_in::state;

namespace {

host::Host& hostProcess() {
    static auto& process =
        *reinterpret_cast<host::Host*>(std::strtoul(std::getenv(host::variable), nullptr, 16));
    return process;
}

// Prepares this thread for calls of the host.
void attachThread() {
    std::uint64_t* slots = nullptr;
#if defined(__x86_64__)
    __asm__("mov %%fs:0, %0" : "=r"(slots));
#else
    __asm__("mrs %0, tpidr_el0" : "=r"(slots));
#endif
    if (slots[host::threadSlot] != 0) return;
    const int index = __atomic_fetch_add(&hostProcess().threadCount, 1, __ATOMIC_SEQ_CST);
    if (index >= host::maxThreads) {
        std::fprintf(stderr, "too many threads call OpenGL\n");
        std::abort();
    }
    host::Call& call = hostProcess().calls[index];
    call.androidThread = reinterpret_cast<std::uint64_t>(slots);
    slots[host::threadSlot] = reinterpret_cast<std::uint64_t>(&call);
}

template <typename Function>
Function* findOnHost(const char* name) {
    attachThread();
    return reinterpret_cast<Function*>(hostProcess().find(name));
}

// Calls the host's function of the same name.
#define ON_HOST(name, ...)                                               \
    [&] {                                                                \
        static auto* const function = findOnHost<decltype(name)>(#name); \
        attachThread();                                                  \
        return function(__VA_ARGS__);                                    \
    }()

std::map<EGLSurface, ANativeWindow*> windows;
EGLint lastError = EGL_SUCCESS;  // an error of this file, which the host knows nothing about

void writePicture(const std::string& path, const ANativeWindow& window) {
    const auto width = static_cast<std::size_t>(window.width),
               height = static_cast<std::size_t>(window.height);
    std::string pixels(width * height * 4, '\0');
    GLint buffer = 0, framebuffer = 0;
    ON_HOST(glGetIntegerv, GL_PIXEL_PACK_BUFFER_BINDING, &buffer);
    ON_HOST(glGetIntegerv, GL_READ_FRAMEBUFFER_BINDING, &framebuffer);
    ON_HOST(glBindBuffer, GL_PIXEL_PACK_BUFFER, 0);
    ON_HOST(glBindFramebuffer, GL_READ_FRAMEBUFFER, 0);
    ON_HOST(glReadPixels, 0, 0, window.width, window.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    ON_HOST(glBindBuffer, GL_PIXEL_PACK_BUFFER, static_cast<GLuint>(buffer));
    ON_HOST(glBindFramebuffer, GL_READ_FRAMEBUFFER, static_cast<GLuint>(framebuffer));
    std::FILE* const file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) return std::perror(path.c_str());
    std::fprintf(file, "P6\n%d %d\n255\n", window.width, window.height);
    for (std::size_t y = height; y-- > 0;)
        for (std::size_t x = 0; x < width; ++x)
            std::fwrite(&pixels[(y * width + x) * 4], 1, 3, file);
    std::fclose(file);
}

}  // namespace

extern "C" {

EGLDisplay eglGetDisplay(EGLNativeDisplayType) {
    return ON_HOST(eglGetDisplay, EGL_DEFAULT_DISPLAY);
}
EGLBoolean eglInitialize(EGLDisplay display, EGLint* major, EGLint* minor) {
    return ON_HOST(eglInitialize, display, major, minor);
}
EGLBoolean eglTerminate(EGLDisplay display) {
    if (!windows.empty()) reportMisuse("the display is closed while a window has a surface");
    return ON_HOST(eglTerminate, display);
}
EGLBoolean eglChooseConfig(EGLDisplay display, const EGLint* attributes, EGLConfig* configs, EGLint size,
                           EGLint* count) {
    std::vector<EGLint> changed;
    for (; *attributes != EGL_NONE; attributes += 2)
        changed.insert(changed.end(),
                       {attributes[0], attributes[0] == EGL_SURFACE_TYPE ? EGL_PBUFFER_BIT : attributes[1]});
    changed.push_back(EGL_NONE);
    return ON_HOST(eglChooseConfig, display, changed.data(), configs, size, count);
}
EGLBoolean eglGetConfigAttrib(EGLDisplay display, EGLConfig config, EGLint attribute, EGLint* value) {
    return ON_HOST(eglGetConfigAttrib, display, config, attribute, value);
}
EGLContext eglCreateContext(EGLDisplay display, EGLConfig config, EGLContext shared,
                            const EGLint* attributes) {
    return ON_HOST(eglCreateContext, display, config, shared, attributes);
}
EGLBoolean eglDestroyContext(EGLDisplay display, EGLContext context) {
    return ON_HOST(eglDestroyContext, display, context);
}
EGLSurface eglCreatePbufferSurface(EGLDisplay display, EGLConfig config, const EGLint* attributes) {
    return ON_HOST(eglCreatePbufferSurface, display, config, attributes);
}
EGLSurface eglCreateWindowSurface(EGLDisplay display, EGLConfig config, EGLNativeWindowType window,
                                  const EGLint*) {
    if (window == nullptr || !window->alive) {
        reportMisuse("a surface is made for a destroyed window");
        lastError = EGL_BAD_NATIVE_WINDOW;
        return EGL_NO_SURFACE;
    }
    for (const auto& [surface, other] : windows)
        if (other == window) reportMisuse("a second surface is made for a window");
    const EGLint size[] = {EGL_WIDTH, window->width, EGL_HEIGHT, window->height, EGL_NONE};
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    if (surface != EGL_NO_SURFACE) windows[surface] = window;
    state().surfaces = static_cast<int>(windows.size());
    return surface;
}
EGLBoolean eglDestroySurface(EGLDisplay display, EGLSurface surface) {
    const auto found = windows.find(surface);
    if (found != windows.end()) {
        if (!found->second->alive) reportMisuse("a surface outlasts its window");
        windows.erase(found);
        state().surfaces = static_cast<int>(windows.size());
    }
    return ON_HOST(eglDestroySurface, display, surface);
}
EGLBoolean eglMakeCurrent(EGLDisplay display, EGLSurface draw, EGLSurface read, EGLContext context) {
    return ON_HOST(eglMakeCurrent, display, draw, read, context);
}
EGLBoolean eglSwapBuffers(EGLDisplay, EGLSurface surface) {
    const auto found = windows.find(surface);
    if (found == windows.end() || !found->second->alive) {
        reportMisuse("a frame is shown in a destroyed window");
        lastError = EGL_BAD_SURFACE;
        return EGL_FALSE;
    }
    if (ON_HOST(eglGetCurrentSurface, EGL_DRAW) != surface)
        reportMisuse("a frame is shown that is not current");
    ON_HOST(glFinish);
    {
        const std::lock_guard lock(state().mutex);
        if (!state().picturePath.empty())
            writePicture(std::exchange(state().picturePath, ""), *found->second);
    }
    ++state().frames;
    return EGL_TRUE;
}
EGLint eglGetError() {
    const EGLint error = ON_HOST(eglGetError);
    return lastError != EGL_SUCCESS ? std::exchange(lastError, EGL_SUCCESS) : error;
}
__eglMustCastToProperFunctionPointerType eglGetProcAddress(const char* name) {
    // The driver would call the app's function for debug messages on a thread pointer of glibc.
    return std::strstr(name, "DebugMessage") != nullptr ? nullptr : findOnHost<void()>(name);
}

}  // extern "C"
