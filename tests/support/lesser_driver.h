// Drivers of earlier versions, without extensions.
#pragma once

#include <cstdlib>

namespace vct::test {

// Mesa has this version of OpenGL ES, and leaves out extensions ("-GL_NAME"), for contexts that are made
// while the object lives.
class LesserDriver {
  public:
    LesserDriver(const char* version, const char* extensions) {
        setenv("MESA_GLES_VERSION_OVERRIDE", version, 1);
        setenv("MESA_EXTENSION_OVERRIDE", extensions, 1);
    }
    ~LesserDriver() {
        unsetenv("MESA_GLES_VERSION_OVERRIDE");
        unsetenv("MESA_EXTENSION_OVERRIDE");
    }
};

}  // namespace vct::test
