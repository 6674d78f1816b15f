#include "gl/capabilities.h"

#include <algorithm>
#include <sstream>

#include "core/error.h"
#include "gl/api.h"
#include "gl/gpu_timer.h"
#include "gl/requirements.h"
#include "gl/version.h"

namespace vct::gl {
namespace {

GLint getInteger(GLenum name) {
    GLint value = 0;  // kept if the driver does not know the name
    GetIntegerv(name, &value);
    return value;
}

// Tests by compilation which ES language versions a context accepts, because no version number says it for
// OSMesa's desktop context.
bool compiles(const char* version) {
    const std::string text =
        std::string("#version ") + version + "\nvoid main() { gl_Position = vec4(0.0); }\n";
    const char* source = text.c_str();
    const GLuint shader = CreateShader(GL_VERTEX_SHADER);
    ShaderSource(shader, 1, &source, nullptr);
    CompileShader(shader);
    GLint status = GL_FALSE;
    GetShaderiv(shader, GL_COMPILE_STATUS, &status);
    DeleteShader(shader);
    return status == GL_TRUE;
}

std::string lineOf(const Requirement& row) {
    return row.name + " (found: " + row.found + ")";
}

}  // namespace

void Capabilities::requireAll() const {
    std::string missing;
    for (const Requirement& row : requirements) {
        if (row.required && !row.met) missing += "\n  " + lineOf(row) + ": " + row.neededBy;
    }
    if (missing.empty()) return;
    throw Error("the GL driver (" + renderer + ", " + version + ") lacks what the renderer needs:" + missing +
                "\nUse a newer driver or another device; the program `vct info` lists what is missing.");
}

bool Capabilities::meets(const std::string& name) const {
    return std::none_of(requirements.begin(), requirements.end(),
                        [&](const Requirement& row) { return row.name == name && !row.met; });
}

Capabilities queryCapabilities() {
    Capabilities result;
    result.vendor = glString(GL_VENDOR);
    result.renderer = glString(GL_RENDERER);
    result.version = glString(GL_VERSION);
    result.shadingLanguage = glString(GL_SHADING_LANGUAGE_VERSION);
    const Version version = parseVersion(result.version);
    result.desktopContext = version.desktop;
    result.debugOutput = DebugMessageCallback != nullptr;
    result.softwareDriver = isSoftwareRenderer(result.renderer);
    result.texturesInMainMemory = result.softwareDriver;
    result.limits = limitsOf(getInteger);
    result.faults = faultsOf(result.renderer, result.version);
    result.gpuTimerBits = result.faults.timerQueries.empty() ? gpuTimerBits() : 0;
    result.uniformBufferOffsetAlignment = getInteger(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT);

    // Some ES 3.1 contexts (Mesa's) compile version 3.20 but need not have all of its core features.
    result.essl320 = version.atLeast(3, 2, 0, 0) && compiles("320 es");
    result.requirements = evaluateRequirements(
        {result.version, extensionNames(), compiles("310 es"), result.essl320, getInteger});
    return result;
}

std::string describe(const Capabilities& capabilities) {
    std::ostringstream out;
    out << "vendor:    " << capabilities.vendor << "\n"
        << "renderer:  " << capabilities.renderer
        << (capabilities.softwareDriver ? "  (runs on the CPU)" : "") << "\n"
        << "version:   " << capabilities.version << (capabilities.desktopContext ? "  (desktop context)" : "")
        << "\n"
        << "language:  " << capabilities.shadingLanguage << "; shaders are compiled as #version "
        << (capabilities.essl320 ? "320 es" : "310 es with extensions") << "\n"
        << "debugging: " << (capabilities.debugOutput ? "KHR_debug messages and groups" : "glGetError only")
        << "\n"
        << "GPU clock: "
        << (capabilities.gpuTimerBits > 0              ? std::to_string(capabilities.gpuTimerBits) + " bits"
            : capabilities.faults.timerQueries.empty() ? "none"
                                                       : "not used: " + capabilities.faults.timerQueries)
        << "\n\n";

    size_t nameWidth = 0, foundWidth = 0;
    for (const Requirement& row : capabilities.requirements) {
        nameWidth = std::max(nameWidth, row.name.size());
        foundWidth = std::max(foundWidth, row.found.size());
    }
    size_t lost = 0;
    for (const Requirement& row : capabilities.requirements) {
        const char* state = row.met ? "ok      " : row.required ? "MISSING " : "absent  ";
        out << state << row.name << std::string(nameWidth - row.name.size() + 2, ' ') << row.found
            << std::string(foundWidth - row.found.size() + 2, ' ') << (row.required ? "required" : "optional")
            << "\n";
        if (!row.met) ++lost;
    }
    out << "\n" << (lost == 0 ? "Nothing is missing.\n" : "Missing, and what needs it:\n");
    for (const Requirement& row : capabilities.requirements) {
        if (!row.met) out << "  " << lineOf(row) << ": " << row.neededBy << "\n";
    }
    return out.str();
}

}  // namespace vct::gl
