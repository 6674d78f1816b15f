// Wraps EGL (the linker's --wrap): windows become pbuffers, misuse is recorded, and a context can be lost.
// Outside a run of the app every call goes to the real EGL.
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl32.h>

#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "stand_in.h"

using vct::test::currentStandIn;
using vct::test::StandIn;

namespace {

// The live surfaces of the app and their windows.
std::map<EGLSurface, ANativeWindow*> surfaces;
EGLint injectedError = EGL_SUCCESS;

void misuse(const std::string& what) {
    currentStandIn()->misuse.push_back(what);
}

// Live GL objects by kind. eglGetProcAddress returns these functions, which count and call the driver.
std::map<std::string, int> liveObjects;

template <typename Function>
Function real(const char* name);

#define VCT_COUNTED(X) X(Buffers) X(Framebuffers) X(Textures) X(VertexArrays) X(Queries)
#define VCT_COUNT(KIND)                                                         \
    void gen##KIND(GLsizei count, GLuint* names) {                              \
        liveObjects[#KIND] += count;                                            \
        real<void (*)(GLsizei, GLuint*)>("glGen" #KIND)(count, names);          \
    }                                                                           \
    void delete##KIND(GLsizei count, const GLuint* names) {                     \
        liveObjects[#KIND] -= count;                                            \
        real<void (*)(GLsizei, const GLuint*)>("glDelete" #KIND)(count, names); \
    }
VCT_COUNTED(VCT_COUNT)

GLuint createProgram() {
    ++liveObjects["Programs"];
    return real<GLuint (*)()>("glCreateProgram")();
}
void deleteProgram(GLuint name) {
    --liveObjects["Programs"];
    real<void (*)(GLuint)>("glDeleteProgram")(name);
}
GLuint createShader(GLenum stage) {
    ++liveObjects["Shaders"];
    return real<GLuint (*)(GLenum)>("glCreateShader")(stage);
}
void deleteShader(GLuint name) {
    --liveObjects["Shaders"];
    real<void (*)(GLuint)>("glDeleteShader")(name);
}

// A lost context reports the loss until it is destroyed.
GLenum getError() {
    StandIn* const android = currentStandIn();
    if (android != nullptr) {
        if (android->lossAtGlError_ > 0 && --android->lossAtGlError_ == 0) android->contextLost = true;
        if (android->contextLost) return GL_CONTEXT_LOST;
    }
    return real<GLenum (*)()>("glGetError")();
}

using Proc = void (*)();

// The function that replaces an entry point of the driver, or null.
Proc wrapped(const std::string& name) {
#define VCT_WRAP(GL, OURS) \
    if (name == GL) return reinterpret_cast<Proc>(OURS);
#define VCT_WRAP_COUNTED(KIND) VCT_WRAP("glGen" #KIND, gen##KIND) VCT_WRAP("glDelete" #KIND, delete##KIND)
    VCT_COUNTED(VCT_WRAP_COUNTED)
    VCT_WRAP("glCreateProgram", createProgram)
    VCT_WRAP("glDeleteProgram", deleteProgram)
    VCT_WRAP("glCreateShader", createShader)
    VCT_WRAP("glDeleteShader", deleteShader)
    VCT_WRAP("glGetError", getError)
    return nullptr;
}

// The frame that is about to be shown: 8-bit values over 255, row 0 at the top.
vct::Image readWindow(int width, int height) {
    std::vector<unsigned char> rgba(static_cast<std::size_t>(width) * height * 4);
    real<void (*)(GLenum, GLuint)>("glBindFramebuffer")(GL_FRAMEBUFFER, 0);
    real<void (*)(GLenum, GLint)>("glPixelStorei")(GL_PACK_ALIGNMENT, 4);
    real<void (*)(GLint, GLint, GLsizei, GLsizei, GLenum, GLenum, void*)>("glReadPixels")(
        0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    vct::Image image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c)
                image.at(x, y)[c] =
                    static_cast<float>(rgba[(static_cast<std::size_t>(height - 1 - y) * width + x) * 4 + c]) /
                    255.0F;
    return image;
}

}  // namespace

extern "C" {

EGLDisplay __real_eglGetDisplay(EGLNativeDisplayType native);
EGLDisplay __wrap_eglGetDisplay(EGLNativeDisplayType native) {
    if (currentStandIn() == nullptr) return __real_eglGetDisplay(native);
    return eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
}

EGLBoolean __real_eglChooseConfig(EGLDisplay, const EGLint*, EGLConfig*, EGLint, EGLint*);
EGLBoolean __wrap_eglChooseConfig(EGLDisplay display, const EGLint* attributes, EGLConfig* configs,
                                  EGLint size, EGLint* count) {
    if (currentStandIn() == nullptr) return __real_eglChooseConfig(display, attributes, configs, size, count);
    std::vector<EGLint> ours;
    for (const EGLint* a = attributes; *a != EGL_NONE; a += 2) {
        ours.push_back(a[0]);
        ours.push_back(a[0] == EGL_SURFACE_TYPE ? a[1] & ~EGL_WINDOW_BIT : a[1]);
    }
    ours.push_back(EGL_NONE);
    return __real_eglChooseConfig(display, ours.data(), configs, size, count);
}

EGLSurface __wrap_eglCreateWindowSurface(EGLDisplay display, EGLConfig config, EGLNativeWindowType window,
                                         const EGLint*) {
    StandIn& android = *currentStandIn();
    if (window == nullptr || !window->alive) {
        misuse("a surface was made for a dead window");
        injectedError = EGL_BAD_NATIVE_WINDOW;
        return EGL_NO_SURFACE;
    }
    for (const auto& [surface, owner] : surfaces)
        if (owner == window) misuse("a window was given a second surface");
    if (android.failSurface_) {
        android.failSurface_ = false;
        injectedError = EGL_BAD_ALLOC;
        return EGL_NO_SURFACE;
    }
    const EGLint size[] = {EGL_WIDTH, window->width, EGL_HEIGHT, window->height, EGL_NONE};
    const EGLSurface surface = eglCreatePbufferSurface(display, config, size);
    if (surface != EGL_NO_SURFACE) surfaces[surface] = window;
    return surface;
}

EGLBoolean __real_eglDestroySurface(EGLDisplay, EGLSurface);
EGLBoolean __wrap_eglDestroySurface(EGLDisplay display, EGLSurface surface) {
    const auto found = surfaces.find(surface);
    if (found != surfaces.end()) {
        // The app must destroy the surface before it answers that the window goes.
        if (!found->second->alive) misuse("a surface outlived its window");
        surfaces.erase(found);
    }
    return __real_eglDestroySurface(display, surface);
}

EGLBoolean __real_eglMakeCurrent(EGLDisplay, EGLSurface, EGLSurface, EGLContext);
EGLBoolean __wrap_eglMakeCurrent(EGLDisplay display, EGLSurface draw, EGLSurface read, EGLContext context) {
    StandIn* const android = currentStandIn();
    if (android != nullptr) {
        const auto found = surfaces.find(draw);
        if (found != surfaces.end() && !found->second->alive)
            misuse("a dead window's surface was made current");
        if (android->contextLost && context != EGL_NO_CONTEXT) {
            injectedError = EGL_CONTEXT_LOST;
            return EGL_FALSE;
        }
    }
    return __real_eglMakeCurrent(display, draw, read, context);
}

EGLBoolean __real_eglSwapBuffers(EGLDisplay, EGLSurface);
EGLBoolean __wrap_eglSwapBuffers(EGLDisplay display, EGLSurface surface) {
    StandIn* const android = currentStandIn();
    if (android == nullptr) return __real_eglSwapBuffers(display, surface);
    const auto found = surfaces.find(surface);
    if (found == surfaces.end() || !found->second->alive) {
        misuse("a dead window was drawn into");
        injectedError = EGL_BAD_SURFACE;
        return EGL_FALSE;
    }
    if (eglGetCurrentSurface(EGL_DRAW) != surface) misuse("a surface was shown that is not current");
    if (android->lossAtSwap_ > 0 && --android->lossAtSwap_ == 0) android->contextLost = true;
    if (android->contextLost) {
        injectedError = EGL_CONTEXT_LOST;
        return EGL_FALSE;
    }
    if (android->capture) android->screen = readWindow(found->second->width, found->second->height);
    ++android->shown;
    return EGL_TRUE;
}

EGLint __real_eglGetError();
EGLint __wrap_eglGetError() {
    if (injectedError == EGL_SUCCESS) return __real_eglGetError();
    const EGLint error = injectedError;
    injectedError = EGL_SUCCESS;
    __real_eglGetError();
    return error;
}

EGLContext __real_eglCreateContext(EGLDisplay, EGLConfig, EGLContext, const EGLint*);
EGLContext __wrap_eglCreateContext(EGLDisplay display, EGLConfig config, EGLContext share,
                                   const EGLint* attributes) {
    const EGLContext context = __real_eglCreateContext(display, config, share, attributes);
    if (StandIn* const android = currentStandIn(); android != nullptr && context != EGL_NO_CONTEXT) {
        ++android->contextsMade;
        liveObjects.clear();
    }
    return context;
}

EGLBoolean __real_eglDestroyContext(EGLDisplay, EGLContext);
EGLBoolean __wrap_eglDestroyContext(EGLDisplay display, EGLContext context) {
    if (StandIn* const android = currentStandIn()) {
        for (const auto& [kind, count] : liveObjects)
            if (count != 0) misuse("the context was destroyed with " + std::to_string(count) + " " + kind);
        android->contextLost = false;
        android->lossAtGlError_ = android->lossAtSwap_ = 0;
    }
    return __real_eglDestroyContext(display, context);
}

EGLBoolean __real_eglTerminate(EGLDisplay);
EGLBoolean __wrap_eglTerminate(EGLDisplay display) {
    if (currentStandIn() != nullptr && !surfaces.empty()) misuse("the display was closed with a surface");
    return __real_eglTerminate(display);
}

Proc __real_eglGetProcAddress(const char* name);
Proc __wrap_eglGetProcAddress(const char* name) {
    const Proc ours = currentStandIn() != nullptr ? wrapped(name) : nullptr;
    return ours != nullptr ? ours : __real_eglGetProcAddress(name);
}

}  // extern "C"

namespace {

template <typename Function>
Function real(const char* name) {
    return reinterpret_cast<Function>(__real_eglGetProcAddress(name));
}

}  // namespace

int vct::test::liveGlObjects(const std::string& kind) {
    return liveObjects[kind];
}
