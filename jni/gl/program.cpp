#include "gl/program.h"

#include "core/error.h"
#include "gl/debug.h"

namespace vct::gl {

namespace {

using Shader = Handle<&DeleteShader>;

std::string infoLog(GLuint object, decltype(GetShaderiv) getParameter, decltype(GetShaderInfoLog) getLog) {
    GLint length = 0;
    getParameter(object, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length > 0 ? length : 1), '\0');
    GLsizei written = 0;
    getLog(object, static_cast<GLsizei>(log.size()), &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    return log;
}

Shader compile(const ShaderLibrary& library, const ProgramDescription& description, const std::string& path) {
    std::vector<std::string> defines = library.defines;
    defines.insert(defines.end(), description.defines.begin(), description.defines.end());
    const AssembledShader source = assembleShader(library.read, path, defines, library.language);
    Shader shader(CreateShader(shaderStage(path)));
    const char* text = source.text.c_str();
    ShaderSource(shader.get(), 1, &text, nullptr);
    CompileShader(shader.get());
    GLint ok = GL_FALSE;
    GetShaderiv(shader.get(), GL_COMPILE_STATUS, &ok);
    if (ok != GL_TRUE)
        throw Error("shaders/" + path + " does not compile for '" + description.name + "':\n" +
                    locateInFiles(infoLog(shader.get(), GetShaderiv, GetShaderInfoLog), source.files));
    return shader;
}

}  // namespace

Program::Program(const ShaderLibrary& library, const ProgramDescription& description)
    : handle_(CreateProgram()) {
    for (const std::string& path : description.shaders) {
        // GL keeps attached shaders until the program is deleted.
        const Shader shader = compile(library, description, path);
        AttachShader(handle_.get(), shader.get());
    }
    LinkProgram(handle_.get());
    GLint ok = GL_FALSE;
    GetProgramiv(handle_.get(), GL_LINK_STATUS, &ok);
    if (ok != GL_TRUE)
        throw Error("program '" + description.name +
                    "' does not link: " + infoLog(handle_.get(), GetProgramiv, GetProgramInfoLog));
    label(GL_PROGRAM, handle_.get(), description.name);
}

}  // namespace vct::gl
