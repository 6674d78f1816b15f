#include "gl/program.h"

#include <chrono>
#include <iterator>

#include "core/error.h"
#include "gl/debug.h"
#include "gl/program_binary.h"

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

AssembledShader sourceOf(const ShaderLibrary& library, const ProgramDescription& description,
                         const std::string& path) {
    std::vector<std::string> defines = library.defines;
    defines.insert(defines.end(), description.defines.begin(), description.defines.end());
    return assembleShader(library.read, path, defines, library.language);
}

Shader compile(const AssembledShader& source, const ProgramDescription& description,
               const std::string& path) {
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

Handle<&DeleteProgram> link(const ShaderLibrary& library, const ProgramDescription& description,
                            const ProgramHooks& hooks) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    const auto onLinked = [&](bool isLoaded) {
        const std::chrono::duration<double, std::milli> duration = Clock::now() - start;
        if (hooks.onLinked) hooks.onLinked(description.name, duration.count(), isLoaded);
    };
    std::vector<AssembledShader> sources;
    std::vector<std::string> texts;
    for (const std::string& path : description.shaders) {
        sources.push_back(sourceOf(library, description, path));
        if (hooks.onSource) hooks.onSource(description, path, sources.back());
        texts.push_back(sources.back().text);
    }
    Handle<&DeleteProgram> handle(CreateProgram());
    const bool keeps = (hooks.load || hooks.store) && hasProgramBinaries();
    const std::string key = keeps ? programKey(texts) : "";
    if (keeps && hooks.load && loadProgramBinary(handle.get(), hooks.load(key))) {
        label(GL_PROGRAM, handle.get(), description.name);
        onLinked(true);
        return handle;
    }
    for (std::size_t i = 0; i < sources.size(); ++i) {
        // GL keeps attached shaders until the program is deleted.
        const Shader shader = compile(sources[i], description, description.shaders[i]);
        AttachShader(handle.get(), shader.get());
    }
    if (keeps) ProgramParameteri(handle.get(), GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
    LinkProgram(handle.get());
    GLint ok = GL_FALSE;
    GetProgramiv(handle.get(), GL_LINK_STATUS, &ok);
    if (ok != GL_TRUE)
        throw Error("program '" + description.name +
                    "' does not link: " + infoLog(handle.get(), GetProgramiv, GetProgramInfoLog));
    label(GL_PROGRAM, handle.get(), description.name);
    if (keeps && hooks.store)
        if (const std::vector<std::uint8_t> binary = programBinary(handle.get()); !binary.empty())
            hooks.store(key, binary);
    onLinked(false);
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
    static const ProgramHooks noHooks;
    linked_ = std::make_shared<Linked>(
        Linked{link(library, description, cache != nullptr ? cache->hooks_ : noHooks),
               cache != nullptr ? cache->newPrograms_ : nullptr});
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
