#include "desktop/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "core/error.h"
#include "desktop/file_dialog.h"
#include "engine/settings.h"

namespace vct::desktop {

const char* const windowKeys =
    "Mouse:\n"
    "  left button       drag to turn the view, double click to reset it\n"
    "  middle button     drag to shift the view\n"
    "  right button      drag to turn the sun\n"
    "  wheel             move nearer or farther; over the panel, scroll it\n"
    "Keys:\n"
    "  W A S D, Q, E     walk, go down, go up (with Shift: faster)\n"
    "  1 to 5, Tab       choose the mode, the next preset\n"
    "  N, B              show the next or the previous scene of the folder\n"
    "  O                 open a scene or a sky (.hdr); or drop it on the window\n"
    "  Space             stop or continue the animation\n"
    "  T, H              time the steps, hide the panel\n"
    "  R                 reset view and sun\n"
    "  P                 save the picture as vct-view-N.png and print the `vct render` command for it\n"
    "  Escape            close the window";

namespace {

constexpr double walkShareOfSceneAndSecond = 0.15;
constexpr float lightDegPerPixel = 0.4F;

std::string glfwProblem;  // GLFW's last error

std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value == nullptr ? "is not set" : std::string("is '") + value + "'";
}

// Initializes GLFW, and terminates it in the destructor.
struct Glfw {
    Glfw() {
        glfwSetErrorCallback([](int, const char* text) { glfwProblem = text; });
        if (glfwInit() == GLFW_FALSE)
            throw Error(
                "cannot open a window: " + glfwProblem + " (DISPLAY " + variable("DISPLAY") +
                ", WAYLAND_DISPLAY " + variable("WAYLAND_DISPLAY") +
                "); run it on a desktop, or set DISPLAY to a display that this user may use (Wayland without "
                "Xwayland needs the package libglfw3-wayland in place of libglfw3), or use `vct render`, "
                "which needs no display");
    }
    ~Glfw() { glfwTerminate(); }
    Glfw(const Glfw&) = delete;
    Glfw& operator=(const Glfw&) = delete;
};

class Window {
  public:
    explicit Window(WindowRequest request) : request_(std::move(request)) {
        glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
        glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, VCT_GL_DEBUG);
        glfwWindowHint(GLFW_DEPTH_BITS, 0);
        glfwWindowHint(GLFW_STENCIL_BITS, 0);
        for (int minor = 2; minor >= 1 && window_ == nullptr; --minor) {
            glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
            window_ =
                glfwCreateWindow(request_.size.x, request_.size.y, request_.title.c_str(), nullptr, nullptr);
        }
        if (window_ == nullptr)
            throw Error("cannot open a window with OpenGL ES 3.1: " + glfwProblem +
                        "; run `vct info` to see what the driver supports, or set LIBGL_ALWAYS_SOFTWARE=1 to "
                        "use Mesa's software driver");
        glfwMakeContextCurrent(window_);
        float scale = 1.0F;
        glfwGetWindowContentScale(window_, &scale, nullptr);
        request_.host.pixelsPerDp = std::max(scale, 1.0F);
        request_.host.askForFile = [this] { askForFile(); };
        viewer_.emplace(request_.host, request_.show);
        glfwSetWindowUserPointer(window_, this);
        // Keys that were pressed and released between two frames count too.
        glfwSetInputMode(window_, GLFW_STICKY_KEYS, GLFW_TRUE);
        glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int) {
            if (action == GLFW_PRESS) of(window).press(key);
        });
        glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int) {
            of(window).click(button, action == GLFW_PRESS);
        });
        glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double x, double y) {
            of(window).move(of(window).inPixels(x, y));
        });
        glfwSetScrollCallback(window_, [](GLFWwindow* window, double, double y) { of(window).wheel(y); });
        glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
            for (int i = 0; i < count; ++i)
                of(window).viewer_->open(paths[i]);
        });
        glfwSetWindowContentScaleCallback(window_, [](GLFWwindow* window, float now, float) {
            of(window).viewer_->setPixelsPerDp(std::max(now, 1.0F));
        });
        glfwSetWindowFocusCallback(window_, [](GLFWwindow* window, int focused) {
            if (focused == GLFW_FALSE) of(window).viewer_->cancelTouch();
        });
    }
    ~Window() {
        viewer_.reset();  // while its OpenGL context still exists
        if (window_ != nullptr) glfwDestroyWindow(window_);
    }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    bool run() {
        while (glfwWindowShouldClose(window_) == GLFW_FALSE) {
            glfwPollEvents();
            const glm::ivec2 size = pixels();
            if (size.x <= 0 || size.y <= 0 || glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE) {
                glfwWaitEvents();
                viewer_->resume();
                continue;
            }
            walk();
            takeFile();
            viewer_->draw(size, {0, 0, size});
            if (save_) save();
            glfwSwapBuffers(window_);
            viewer_->shown();
            if (viewer_->hasNothingToShow()) return false;
        }
        return true;
    }

  private:
    static Window& of(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

    glm::ivec2 pixels() const {
        glm::ivec2 size(0);
        glfwGetFramebufferSize(window_, &size.x, &size.y);
        return size;
    }

    // Converts an event's position to pixels. The cursor itself may have moved since.
    glm::vec2 inPixels(double x, double y) const {
        glm::ivec2 window(1);
        glfwGetWindowSize(window_, &window.x, &window.y);
        return glm::vec2(glm::dvec2(x, y) * glm::dvec2(pixels()) / glm::dvec2(glm::max(window, 1)));
    }

    // Tells the viewer that `count` fingers touch the window, side by side around `at`.
    void fingers(int count, const glm::vec2& at, float apart = 100.0F) {
        std::vector<app::TouchPoint> points;
        for (int i = 0; i < count; ++i)
            points.push_back({i, at + glm::vec2(count == 1 ? 0.0F : (i == 0 ? -apart : apart), 0.0F)});
        viewer_->finger(points, glfwGetTime());
    }

    void click(int button, bool down) {
        if (down ? held_ != -1 : held_ != button) return;
        held_ = down ? button : -1;
        if (button == GLFW_MOUSE_BUTTON_LEFT) fingers(down ? 1 : 0, cursor_);
        // Over the panel, only the left button acts.
        if (button != GLFW_MOUSE_BUTTON_LEFT && down && viewer_->hudCovers(cursor_)) held_ = -1;
        if (button == GLFW_MOUSE_BUTTON_MIDDLE && (held_ != -1 || !down)) fingers(down ? 2 : 0, cursor_);
    }

    void move(const glm::vec2& to) {
        if (held_ == GLFW_MOUSE_BUTTON_LEFT) fingers(1, to);
        if (held_ == GLFW_MOUSE_BUTTON_MIDDLE) fingers(2, to);
        if (held_ == GLFW_MOUSE_BUTTON_RIGHT)
            viewer_->turnLight(lightDegPerPixel * glm::vec2(to.x - cursor_.x, cursor_.y - to.y));
        cursor_ = to;
    }

    void wheel(double clicks) {
        if (held_ != -1) return;
        if (viewer_->hudCovers(cursor_)) return viewer_->scrollHud(cursor_, static_cast<float>(clicks));
        fingers(2, cursor_);
        fingers(2, cursor_, 100.0F * std::pow(1.1F, static_cast<float>(clicks)));
        fingers(0, cursor_);
    }

    void press(int key) {
        app::Choices& choices = viewer_->choices();
        const std::vector<std::string>& presets = presetNames();
        if (key >= GLFW_KEY_1 && key <= GLFW_KEY_5)
            choices.mode = allModes().at(static_cast<std::size_t>(key - GLFW_KEY_1));
        switch (key) {
            case GLFW_KEY_TAB: {
                const auto at =
                    std::find(presets.begin(), presets.end(), choices.preset) - presets.begin() + 1;
                app::choosePreset(choices, presets[static_cast<std::size_t>(at) % presets.size()]);
                break;
            }
            case GLFW_KEY_N:
                return viewer_->showOtherScene(1);
            case GLFW_KEY_B:
                return viewer_->showOtherScene(-1);
            case GLFW_KEY_O:
                return askForFile();
            case GLFW_KEY_SPACE:
                choices.play = !choices.play;
                break;
            case GLFW_KEY_T:
                choices.timeSteps = !choices.timeSteps;
                break;
            case GLFW_KEY_H:
                return viewer_->toggleHud();
            case GLFW_KEY_R:
                return viewer_->reset();
            case GLFW_KEY_P:
                save_ = true;
                break;
            case GLFW_KEY_ESCAPE:
                glfwSetWindowShouldClose(window_, GLFW_TRUE);
                break;
            default:
                break;
        }
    }

    void askForFile() {
        if (dialog_) return;
        try {
            dialog_ = std::make_unique<FileDialog>();
        } catch (const Error& error) {
            viewer_->fail(error.what());
        }
    }

    void takeFile() {
        const std::optional<std::string> path = dialog_ ? dialog_->poll() : std::nullopt;
        if (!path) return;
        dialog_.reset();
        if (!path->empty()) viewer_->open(*path);
    }

    void walk() {
        const double now = glfwGetTime();
        const double passedS = std::min(now - lastWalkS_, 0.2);  // a slow frame must not jump through a wall
        lastWalkS_ = now;
        const auto along = [&](int forth, int back) {
            return (glfwGetKey(window_, forth) == GLFW_PRESS ? 1.0 : 0.0) -
                   (glfwGetKey(window_, back) == GLFW_PRESS ? 1.0 : 0.0);
        };
        const glm::dvec3 way(along(GLFW_KEY_D, GLFW_KEY_A), along(GLFW_KEY_E, GLFW_KEY_Q),
                             along(GLFW_KEY_S, GLFW_KEY_W));
        const double speed = glfwGetKey(window_, GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS ? 4.0 : 1.0;
        if (way != glm::dvec3(0.0)) viewer_->walk(speed * walkShareOfSceneAndSecond * passedS * way);
    }

    void save() {
        save_ = false;
        try {
            if (const std::optional<app::Viewer::Seen> seen = viewer_->seen())
                request_.save(*seen, viewer_->choices());
        } catch (const Error& error) {
            viewer_->fail(error.what());
        }
    }

    WindowRequest request_;
    GLFWwindow* window_ = nullptr;
    std::optional<app::Viewer> viewer_;
    std::unique_ptr<FileDialog> dialog_;  // while it is open
    int held_ = -1;                       // mouse button that is held; -1: none
    glm::vec2 cursor_{0.0F};
    bool save_ = false;
    double lastWalkS_ = 0.0;
};

}  // namespace

bool runWindow(WindowRequest request) {
    const Glfw glfw;
    return Window(std::move(request)).run();
}

}  // namespace vct::desktop
