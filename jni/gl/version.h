// Parses GL_VERSION.
#pragma once

#include <cstdio>
#include <string>

namespace vct::gl {

struct Version {
    bool desktop = false;
    int major = 0;
    int minor = 0;

    // Compares with a version of OpenGL ES or of desktop OpenGL, which have separate numbers.
    bool atLeast(int esMajor, int esMinor, int desktopMajor, int desktopMinor) const {
        const int wantedMajor = desktop ? desktopMajor : esMajor;
        const int wantedMinor = desktop ? desktopMinor : esMinor;
        return major != wantedMajor ? major > wantedMajor : minor >= wantedMinor;
    }
};

// Parses "OpenGL ES 3.2 Mesa 22.3.6" or "4.5 (Core Profile) Mesa 22.3.6"; returns 0.0 for anything else.
inline Version parseVersion(const std::string& text) {
    const std::string prefix = "OpenGL ES ";
    Version version;
    version.desktop = text.compare(0, prefix.size(), prefix) != 0;
    const char* numbers = text.c_str() + (version.desktop ? 0 : prefix.size());
    if (std::sscanf(numbers, "%d.%d", &version.major, &version.minor) != 2) version.major = version.minor = 0;
    return version;
}

}  // namespace vct::gl
