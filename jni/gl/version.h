// GL_VERSION taken apart: extensions are asked for only where the version does not already settle it.
#pragma once

#include <cstdio>
#include <string>

namespace vct::gl {

struct Version {
    bool desktop = false;
    int major = 0;
    int minor = 0;

    // OpenGL ES and desktop OpenGL count separately, so a question names both numbers.
    bool atLeast(int esMajor, int esMinor, int desktopMajor, int desktopMinor) const {
        const int wantedMajor = desktop ? desktopMajor : esMajor;
        const int wantedMinor = desktop ? desktopMinor : esMinor;
        return major != wantedMajor ? major > wantedMajor : minor >= wantedMinor;
    }
};

// Understands "OpenGL ES 3.2 Mesa 22.3.6" and "4.5 (Core Profile) Mesa 22.3.6"; 0.0 for anything else.
inline Version parseVersion(const std::string& text) {
    const std::string prefix = "OpenGL ES ";
    Version version;
    version.desktop = text.compare(0, prefix.size(), prefix) != 0;
    const char* numbers = text.c_str() + (version.desktop ? 0 : prefix.size());
    if (std::sscanf(numbers, "%d.%d", &version.major, &version.minor) != 2) version.major = version.minor = 0;
    return version;
}

}  // namespace vct::gl
