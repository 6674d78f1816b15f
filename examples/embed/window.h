// A GL context with a window, or without one. Nothing here has to do with the library.
#pragma once

struct GLFWwindow;

class Window {
  public:
    // `framesWithoutWindow`: 0 opens a window; else there is none, and so many frames are drawn. Throws
    // std::runtime_error.
    explicit Window(int framesWithoutWindow);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    // Shows what was drawn, and says whether there is another frame to draw.
    bool next();
    int width() const { return width_; }
    int height() const { return height_; }
    static void* getProcAddress(const char* name);

  private:
    GLFWwindow* window_ = nullptr;
    int framesLeft_ = 0, width_ = 320, height_ = 240;
};
