// A linked program, from files below shaders/.
#pragma once

#include <string>
#include <vector>

#include "gl/objects.h"
#include "gl/shader_source.h"

namespace vct::gl {

// What a program is made of; the tests enumerate these to check every variant offline.
struct ProgramDescription {
    std::string name;                  // "shade gi": for debuggers and messages
    std::vector<std::string> shaders;  // "passes/full_screen.vert", "passes/shade.frag"
    std::vector<std::string> defines;  // "VCT_MODE 4"
};

// Where shaders come from and which language the context speaks.
struct ShaderLibrary {
    ReadShader read;
    Language language = Language::essl310;
    std::vector<std::string> defines = {};  // for every program, beside its own
};

class Program {
  public:
    Program() = default;
    // Compiles and links; throws vct::Error with the driver's messages pointed to file and line.
    Program(const ShaderLibrary& library, const ProgramDescription& description);
    void use() const { UseProgram(handle_.get()); }
    GLint uniform(const char* name) const { return GetUniformLocation(handle_.get(), name); }

  private:
    Handle<&DeleteProgram> handle_;
};

}  // namespace vct::gl
