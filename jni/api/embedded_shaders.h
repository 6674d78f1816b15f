// The shader files that are built into the library (cmake/embed_shaders.cmake).
#pragma once

#include "gl/shader_source.h"

namespace vct {

// The returned function throws vct::Error if a file does not exist.
gl::ReadShader embeddedShaders();

// The table that cmake/embed_shaders.cmake writes; the last path is null.
struct EmbeddedFile {
    const char* path;
    const char* text;
};
extern const EmbeddedFile embeddedFiles[];

}  // namespace vct
