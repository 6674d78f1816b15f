#include "gl/debug.h"

#include <algorithm>
#include <iterator>
#include <mutex>
#include <vector>

#include "gl/api.h"

namespace vct::gl {
namespace {

// A driver may call from its own thread even if synchronous output is enabled.
std::mutex keptMutex;
std::vector<std::string> kept;

// A shader in a loop can repeat a message without end; the first few suffice.
constexpr size_t maxKept = 32;

void keep(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length, const GLchar* message) {
    if (type != GL_DEBUG_TYPE_ERROR && severity != GL_DEBUG_SEVERITY_HIGH) return;
    if (type == GL_DEBUG_TYPE_PERFORMANCE) return;
    // Program reports shaders that do not compile, with file and line.
    if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) return;
    std::string text = length < 0 ? std::string(message) : std::string(message, static_cast<size_t>(length));
    while (!text.empty() && (text.back() == '\n' || text.back() == '\0'))
        text.pop_back();
    const std::lock_guard<std::mutex> lock(keptMutex);
    if (kept.size() < maxKept) kept.push_back(text + " (message " + std::to_string(id) + ")");
}

void GL_APIENTRY onMessage(GLenum source, GLenum type, GLuint id, GLenum severity, GLsizei length,
                           const GLchar* message, const void* /*user*/) {
    // The caller is the driver's C code, so no exception may leave this function.
    try {
        keep(source, type, id, severity, length, message);
    } catch (...) {
    }
}

std::string errorName(GLenum error) {
    // The names are in the order of their values, from GL_INVALID_ENUM on.
    constexpr const char* names[] = {"GL_INVALID_ENUM",
                                     "GL_INVALID_VALUE",
                                     "GL_INVALID_OPERATION",
                                     "GL_STACK_OVERFLOW",
                                     "GL_STACK_UNDERFLOW",
                                     "GL_OUT_OF_MEMORY",
                                     "GL_INVALID_FRAMEBUFFER_OPERATION",
                                     "GL_CONTEXT_LOST"};
    const GLenum index = error - GL_INVALID_ENUM;
    return index < std::size(names) ? names[index] : "GL error " + std::to_string(error);
}

std::vector<std::string> drainErrors() {
    std::vector<std::string> errors;
    // The limit is needed because some drivers return errors for ever without a valid context.
    for (GLenum error = GetError(); error != GL_NO_ERROR && errors.size() < 8; error = GetError())
        errors.push_back(errorName(error));
    return errors;
}

}  // namespace

void installDebugCallback() {
    {
        // Drop messages of an earlier context.
        const std::lock_guard<std::mutex> lock(keptMutex);
        kept.clear();
    }
    if (!DebugMessageCallback || !DebugMessageControl) return;
    Enable(GL_DEBUG_OUTPUT);
    Enable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    DebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_NOTIFICATION, 0, nullptr, GL_FALSE);
    DebugMessageControl(GL_DONT_CARE, GL_DEBUG_TYPE_PERFORMANCE, GL_DONT_CARE, 0, nullptr, GL_FALSE);
    // Errors may have low severity, and messages of low severity are disabled by default.
    DebugMessageControl(GL_DONT_CARE, GL_DEBUG_TYPE_ERROR, GL_DONT_CARE, 0, nullptr, GL_TRUE);
    DebugMessageCallback(onMessage, nullptr);
}

void checkErrors(const std::string& where) {
    std::vector<std::string> messages;
    {
        const std::lock_guard<std::mutex> lock(keptMutex);
        messages.swap(kept);
    }
    // Errors are drained even if there are messages, because otherwise the next pass would report them. They
    // are reported only without messages, which say the same and more.
    const std::vector<std::string> errors = drainErrors();
    if (std::count(errors.begin(), errors.end(), errorName(GL_CONTEXT_LOST)) > 0)
        throw ContextLost(where + ": the GL context was lost");
    if (messages.empty()) messages = errors;
    if (messages.empty()) return;
    std::string text = where + ": ";
    for (size_t i = 0; i < messages.size(); ++i)
        text += (i ? "; " : "") + messages[i];
    throw Error(text);
}

DebugGroup::DebugGroup(const char* name) : section_(name) {
    if (PushDebugGroup) PushDebugGroup(GL_DEBUG_SOURCE_APPLICATION, 0, -1, name);
}

DebugGroup::~DebugGroup() {
    if (PopDebugGroup) PopDebugGroup();
}

void label(unsigned identifier, unsigned name, const std::string& text) {
    // `identifier` is a namespace such as GL_BUFFER; for textures it is GL_TEXTURE, whatever the target. A
    // driver may limit labels to 256 bytes, and names in a scene may be longer.
    constexpr std::size_t most = 255;
    if (ObjectLabel)
        ObjectLabel(identifier, name, static_cast<GLsizei>(std::min(text.size(), most)), text.c_str());
}

}  // namespace vct::gl
