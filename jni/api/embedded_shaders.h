// The files below shaders/, as they were when the library was built (cmake/embed_shaders.cmake).
#pragma once

#include "gl/shader_source.h"

namespace vct {

// Throws vct::Error where there is no such file.
gl::ReadShader embeddedShaders();

// What cmake/embed_shaders.cmake writes; the last path is null.
struct EmbeddedFile {
    const char* path;
    const char* text;
};
extern const EmbeddedFile embeddedFiles[];

}  // namespace vct
