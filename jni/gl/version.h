// GL_VERSION taken apart: extensions are asked for only where the version does not already settle it.
#pragma once

#include <string>

namespace vct::gl {

struct Version {
    bool desktop = false;
    int major = 0;
    int minor = 0;

    // OpenGL ES and desktop OpenGL count separately, so a question names both numbers.
    bool atLeast(int esMajor, int esMinor, int desktopMajor, int desktopMinor) const;
};

// Understands "OpenGL ES 3.2 Mesa 22.3.6" and "4.5 (Core Profile) Mesa 22.3.6"; 0.0 for anything else.
Version parseVersion(const std::string& text);

}  // namespace vct::gl
