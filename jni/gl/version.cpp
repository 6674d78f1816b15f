#include "gl/version.h"

#include <cstdio>

namespace vct::gl {

bool Version::atLeast(int esMajor, int esMinor, int desktopMajor, int desktopMinor) const {
    const int wantedMajor = desktop ? desktopMajor : esMajor;
    const int wantedMinor = desktop ? desktopMinor : esMinor;
    return major != wantedMajor ? major > wantedMajor : minor >= wantedMinor;
}

Version parseVersion(const std::string& text) {
    const std::string prefix = "OpenGL ES ";
    Version version;
    version.desktop = text.compare(0, prefix.size(), prefix) != 0;
    const char* numbers = text.c_str() + (version.desktop ? 0 : prefix.size());
    if (std::sscanf(numbers, "%d.%d", &version.major, &version.minor) != 2) {
        version.major = 0;
        version.minor = 0;
    }
    return version;
}

}  // namespace vct::gl
