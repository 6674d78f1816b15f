#include "gl/program.h"

#include <iterator>

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

Handle<&DeleteProgram> link(const ShaderLibrary& library, const ProgramDescription& description) {
    Handle<&DeleteProgram> handle(CreateProgram());
    for (const std::string& path : description.shaders) {
        // GL keeps attached shaders until the program is deleted.
        const Shader shader = compile(library, description, path);
        AttachShader(handle.get(), shader.get());
    }
    LinkProgram(handle.get());
    GLint ok = GL_FALSE;
    GetProgramiv(handle.get(), GL_LINK_STATUS, &ok);
    if (ok != GL_TRUE)
        throw Error("program '" + description.name +
                    "' does not link: " + infoLog(handle.get(), GetProgramiv, GetProgramInfoLog));
    label(GL_PROGRAM, handle.get(), description.name);
    return handle;
}

void countNew(int& allowed) {
    if (allowed == 0) throw NewProgramLimit();
    --allowed;
}

}  // namespace

Program::Program(const ShaderLibrary& library, const ProgramDescription& description) {
    ProgramCache* const cache = library.cache.get();
    std::shared_ptr<Linked>* const shared =
        cache != nullptr ? &cache->programs_[ProgramCache::keyOf(library, description)] : nullptr;
    if (shared != nullptr && *shared) {
        linked_ = *shared;
        return;
    }
    if (cache != nullptr) countNew(*cache->newPrograms_);
    linked_ = std::make_shared<Linked>(
        Linked{link(library, description), cache != nullptr ? cache->newPrograms_ : nullptr});
    if (shared != nullptr) *shared = linked_;
}

void Program::use() const {
    if (!linked_->isUsed && linked_->newPrograms) countNew(*linked_->newPrograms);
    linked_->isUsed = true;
    UseProgram(linked_->handle.get());
}

ProgramCache::Key ProgramCache::keyOf(const ShaderLibrary& library, const ProgramDescription& description) {
    Key key = description.shaders;
    key.insert(key.end(), library.defines.begin(), library.defines.end());
    key.insert(key.end(), description.defines.begin(), description.defines.end());
    return key;
}

void ProgramCache::removeUnused() {
    for (auto at = programs_.begin(); at != programs_.end();)
        at = at->second && at->second.use_count() > 1 ? std::next(at) : programs_.erase(at);
}

bool ProgramCache::contains(const ShaderLibrary& library, const ProgramDescription& description) const {
    const auto found = programs_.find(keyOf(library, description));
    return found != programs_.end() && found->second;
}

}  // namespace vct::gl
