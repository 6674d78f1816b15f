// Compiles and links programs from the files below shaders/.
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <limits>
#include <map>
#include <memory>
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

class ProgramCache;

// The source of the shader files, and the language of the context.
struct ShaderLibrary {
    ReadShader read;
    Language language = Language::essl310;
    std::vector<std::string> defines = {};     // added to every program's own
    std::shared_ptr<ProgramCache> cache = {};  // null: every Program is linked for itself
};

class Program {
  public:
    Program() = default;
    // Compiles and links, unless the library's cache has the program. Throws vct::Error with the driver's
    // messages, which name file and line.
    Program(const ShaderLibrary& library, const ProgramDescription& description);
    void use() const;
    GLint uniform(const char* name) const { return GetUniformLocation(linked_->handle.get(), name); }

  private:
    friend class ProgramCache;
    struct Linked {
        Handle<&DeleteProgram> handle;
        std::shared_ptr<int> newPrograms;  // how many the cache still allows; null: not in a cache
        bool isUsed = false;
    };
    std::shared_ptr<Linked> linked_;
};

// Too many programs were new: see ProgramCache::runLimited(). It is no vct::Error, because nothing is wrong:
// the same work succeeds if it is repeated often enough.
struct NewProgramLimit : std::exception {
    const char* what() const noexcept override { return "too many new programs for one frame"; }
};

// Functions that are called while a program is linked. Each may be empty.
struct ProgramHooks {
    // May change the source of a program's shader.
    std::function<void(const ProgramDescription& program, const std::string& shader, AssembledShader& source)>
        onSource;
    // Return and keep what a driver has compiled, by a key of 32 hexadecimal digits, which depends on the
    // driver and the source. An empty result means that there is none; one that does not fit is not used.
    std::function<std::vector<std::uint8_t>(const std::string& key)> load;
    std::function<void(const std::string& key, const std::vector<std::uint8_t>& binary)> store;
    // `isLoaded`: the program was not compiled.
    std::function<void(const std::string& name, double ms, bool isLoaded)> onLinked;
};

// Shares the programs of a context, so that each is linked once, at a time that the caller chooses. A shared
// program has the uniforms of whoever used it last.
class ProgramCache {
  public:
    explicit ProgramCache(ProgramHooks hooks = {}) : hooks_(std::move(hooks)) {}

    bool contains(const ShaderLibrary& library, const ProgramDescription& description) const;

    // Runs `work`, which may link one program or use one for the first time, which is when some drivers
    // compile it. Returns false if it needs more: then it was interrupted, and gets further when repeated.
    template <typename Work>
    bool runLimited(const Work& work) {
        struct Limit {
            int& newPrograms;
            explicit Limit(int& count) : newPrograms(count) { newPrograms = 1; }
            ~Limit() { newPrograms = unlimited; }
        } const limit(*newPrograms_);
        try {
            work();
        } catch (const NewProgramLimit&) {
            return false;
        }
        return true;
    }

    void removeUnused();  // deletes the programs that have no other owner

  private:
    friend class Program;
    using Key = std::vector<std::string>;  // shaders, then defines
    static Key keyOf(const ShaderLibrary& library, const ProgramDescription& description);

    ProgramHooks hooks_;
    std::map<Key, std::shared_ptr<Program::Linked>> programs_;
    static constexpr int unlimited = std::numeric_limits<int>::max();
    std::shared_ptr<int> newPrograms_ = std::make_shared<int>(unlimited);
};

}  // namespace vct::gl
