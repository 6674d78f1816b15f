// A GL context with or without a window. It does not depend on the library.
#pragma once

struct GLFWwindow;

class Window {
  public:
    // `framesWithoutWindow`: 0 opens a window; otherwise the number of frames to draw without one. Throws
    // std::runtime_error.
    explicit Window(int framesWithoutWindow);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    // Shows the drawn frame. Returns true if there is another frame to draw.
    bool next();
    int width() const { return width_; }
    int height() const { return height_; }
    static void* getProcAddress(const char* name);

  private:
    GLFWwindow* window_ = nullptr;
    int framesLeft_ = 0, width_ = 320, height_ = 240;
};
