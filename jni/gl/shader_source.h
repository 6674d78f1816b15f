// Assembles the source that the driver compiles from shader files: resolves `#include`, and adds the
// #version and extension lines. Translates positions in driver messages back to files and lines.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gl/api.h"

namespace vct::gl {

// Reads a shader by its path below shaders/ ("shared/frame.glsl"). Throws vct::Error if it does not exist.
using ReadShader = std::function<std::string(const std::string& path)>;

// Reads shaders from a folder on disk.
ReadShader shadersFromFolder(const std::string& folder);

// The language of the assembled sources. Version 3.00 is for the app's head-up display, which also has to
// work on drivers that cannot run the engine.
enum class Language {
    essl300,  // "#version 300 es"
    essl310,  // "#version 310 es" with the extensions that the stage needs
    essl320,  // "#version 320 es"
};

struct AssembledShader {
    std::string text;
    std::vector<std::string> files;  // by source-string number, as in #line and in driver messages
};

// The extension of `path` is the stage: .vert .geom .frag .comp. `defines` are "NAME" or "NAME VALUE".
AssembledShader assembleShader(const ReadShader& read, const std::string& path,
                               const std::vector<std::string>& defines, Language language);

GLenum shaderStage(const std::string& path);

// Replaces positions in a driver's log, such as "2:35(12): error: x", "2(35) : error x" or "ERROR: 2:35: x",
// by "shared/frame.glsl:35: ...".
std::string locateInFiles(const std::string& driverLog, const std::vector<std::string>& files);

}  // namespace vct::gl
