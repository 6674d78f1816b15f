// The viewer in a desktop window. The mouse acts as fingers do on a phone, and keys change the panel's
// choices.
#pragma once

#include <functional>
#include <string>

#include "app/viewer.h"

namespace vct::desktop {

struct WindowRequest {
    std::string title;
    glm::ivec2 size{800, 600};  // pixels
    app::ViewerHost host;       // runWindow() sets pixelsPerDp
    app::ShowRequest show;
    std::function<void(const app::Viewer::Seen&, const app::Choices&)> save;  // called by the key P
};

// Runs until the window is closed and returns true. Returns false if the scene cannot be loaded; the reason
// has been logged. Throws vct::Error if there is no display or no OpenGL ES 3.1 context.
bool runWindow(WindowRequest request);

// The mouse buttons and keys, for --help.
extern const char* const windowKeys;

}  // namespace vct::desktop
