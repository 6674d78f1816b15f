#include "gl/call_log.h"

#include <cassert>
#include <cstring>
#include <type_traits>

namespace vct::gl {

namespace {

CallLog* current = nullptr;

bool is(const Call& call, const char* name) {
    return std::strcmp(call.name, name) == 0;
}

bool startsWith(const Call& call, const char* start) {
    return std::strncmp(call.name, start, std::strlen(start)) == 0;
}

template <typename T>
void keep(Call& call, T argument) {
    if constexpr (std::is_pointer_v<T>)
        call.arguments.push_back(static_cast<std::int64_t>(reinterpret_cast<std::intptr_t>(argument)));
    else
        call.arguments.push_back(static_cast<std::int64_t>(argument));
    if constexpr (std::is_same_v<T, const GLchar*>) {
        if (argument != nullptr) call.text = argument;
    }
    // ShaderSource is always called with one string and no length.
    if constexpr (std::is_same_v<T, const GLchar* const*>) call.text = argument[0];
    // The argument before such an array is its length.
    if constexpr (std::is_same_v<T, const GLuint*>) {
        if (startsWith(call, "Delete") || is(call, "InvalidateFramebuffer"))
            call.names.assign(argument, argument + *(call.arguments.end() - 2));
    }
}

// The function that replaces an entry point, and the driver's own function. Entry points that the driver
// lacks are recorded too, so that the log does not depend on the driver.
template <auto* entry>
struct Hook;
template <typename Result, typename... Arguments, Result(GL_APIENTRY** entry)(Arguments...)>
struct Hook<entry> {
    static inline Result(GL_APIENTRY* driver)(Arguments...) = nullptr;
    static inline const char* name = nullptr;

    static Result GL_APIENTRY call(Arguments... arguments) {
        Call made{name, {}, {}};
        (keep(made, arguments), ...);
        current->add(std::move(made));
        if constexpr (std::is_void_v<Result>) {
            if (driver != nullptr) driver(arguments...);
        } else {
            return driver != nullptr ? driver(arguments...) : Result{};
        }
    }
    static void install(const char* ownName) {
        name = ownName;
        driver = *entry;
        *entry = call;
    }
    static void remove() { *entry = driver; }
};

std::string bufferName(std::int64_t target) {
    if (target == GL_UNIFORM_BUFFER) return "uniform buffer ";
    return target == GL_SHADER_STORAGE_BUFFER ? "storage buffer " : "other buffer ";
}

std::string textureTarget(std::int64_t target) {
    if (target == GL_TEXTURE_2D) return "2D";
    return target == GL_TEXTURE_3D ? "3D" : "other";
}

}  // namespace

CallLog::CallLog() {
    assert(current == nullptr);
    current = this;
#define VCT_GL_INSTALL(NAME) Hook<&NAME>::install(#NAME);
    VCT_GL_FUNCTIONS(VCT_GL_INSTALL)
    VCT_GL_OPTIONAL_FUNCTIONS(VCT_GL_INSTALL)
#undef VCT_GL_INSTALL
}

CallLog::~CallLog() {
#define VCT_GL_REMOVE(NAME) Hook<&NAME>::remove();
    VCT_GL_FUNCTIONS(VCT_GL_REMOVE)
    VCT_GL_OPTIONAL_FUNCTIONS(VCT_GL_REMOVE)
#undef VCT_GL_REMOVE
    current = nullptr;
}

CallSummary summarize(const std::vector<Call>& calls) {
    CallSummary summary;
    std::vector<std::string> groups{""};
    const auto countOf = [&](const std::string& group) -> int& {
        for (auto& [name, count] : summary.byGroup)
            if (name == group) return count;
        return summary.byGroup.emplace_back(group, 0).second;
    };
    std::int64_t program = 0, unit = 0;
    const auto number = [](std::int64_t value) { return std::to_string(value); };
    for (const Call& call : calls) {
        const std::vector<std::int64_t>& a = call.arguments;
        if (is(call, "PushDebugGroup")) {
            if (groups.size() == 1) summary.passes.insert(call.text);
            groups.push_back(call.text);
            countOf(call.text);
            continue;
        }
        if (is(call, "PopDebugGroup")) {
            groups.pop_back();
            continue;
        }
        ++summary.calls;
        ++summary.byName[call.name];
        ++countOf(groups.back());
        const bool draw = startsWith(call, "DrawArrays") || startsWith(call, "DrawElements");
        const bool dispatch = startsWith(call, "DispatchCompute");
        summary.draws += draw;
        summary.dispatches += dispatch;
        if (draw || dispatch) summary.programs.insert(program);
        if (is(call, "UseProgram")) program = a[0];
        if (is(call, "ActiveTexture")) unit = a[0] - GL_TEXTURE0;
        if (is(call, "BindTexture"))
            summary.bindings.insert("texture " + number(unit) + ": " + textureTarget(a[0]));
        if (is(call, "BindSampler")) summary.bindings.insert("sampler " + number(a[0]));
        if (is(call, "BindImageTexture"))
            summary.bindings.insert("image " + number(a[0]) + ", level " + number(a[2]));
        if (is(call, "BindBufferBase")) summary.bindings.insert(bufferName(a[0]) + number(a[1]));
        if (is(call, "BindBufferRange"))
            summary.bindings.insert(bufferName(a[0]) + number(a[1]) + ": " + number(a[4]) + " bytes");
        if (startsWith(call, "Uniform")) summary.bindings.insert("uniform " + number(a[0]));
    }
    return summary;
}

}  // namespace vct::gl
