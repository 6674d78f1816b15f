// A viewer in a window of the desktop: the mouse is a finger, and keys choose what the display has.
#pragma once

#include <functional>
#include <string>

#include "app/viewer.h"

namespace vct::desktop {

struct WindowRequest {
    std::string title;
    glm::ivec2 size{800, 600};  // pixels
    app::ViewerHost host;       // but for the screen's density
    app::ShowRequest show;
    std::function<void(const app::Viewer::Seen&, const app::Choices&)> save;  // by key
};

// Until the window is closed; or until the scene cannot be loaded, which was logged: then it returns false.
// Throws vct::Error where there is no display, or no context for it.
bool runWindow(WindowRequest request);

// What each key and button does, for --help.
extern const char* const windowKeys;

}  // namespace vct::desktop
