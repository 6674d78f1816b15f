// Compiles and links programs from the files below shaders/.
#pragma once

#include <string>
#include <vector>

#include "gl/objects.h"
#include "gl/shader_source.h"

namespace vct::gl {

// The parts of a program. Tests enumerate the descriptions to check every variant offline.
struct ProgramDescription {
    std::string name;                  // for debuggers and messages: "shade 4"
    std::vector<std::string> shaders;  // "passes/full_screen.vert", "passes/shade.frag"
    std::vector<std::string> defines;  // "VCT_MODE 4"
};

// The source of the shader files, and the language of the context.
struct ShaderLibrary {
    ReadShader read;
    Language language = Language::essl310;
    std::vector<std::string> defines = {};  // added to every program's own
};

class Program {
  public:
    Program() = default;
    // Compiles and links. Throws vct::Error with the driver's messages, which name file and line.
    Program(const ShaderLibrary& library, const ProgramDescription& description);
    void use() const { UseProgram(handle_.get()); }
    GLint uniform(const char* name) const { return GetUniformLocation(handle_.get(), name); }

  private:
    Handle<&DeleteProgram> handle_;
};

}  // namespace vct::gl
