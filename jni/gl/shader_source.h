// Shader files into what the driver compiles: `#include` resolved, the #version and extension lines written
// here and nowhere else, and driver messages pointed back to the file and line that a person edits.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gl/api.h"

namespace vct::gl {

// Reads a shader by its path below shaders/ ("shared/frame.glsl"); throws vct::Error where there is none.
using ReadShader = std::function<std::string(const std::string& path)>;

// From a folder on disk.
ReadShader shadersFromFolder(const std::string& folder);

// What the sources are compiled as. 3.00 is for what is drawn on a driver that lacks all the rest.
enum class Language {
    essl300,  // "#version 300 es"
    essl310,  // "#version 310 es" with the extensions that the stage needs
    essl320,  // "#version 320 es"
};

struct AssembledShader {
    std::string text;
    std::vector<std::string> files;  // index: the source-string number in #line and in driver messages
};

// `path`'s extension names the stage: .vert .geom .frag .comp. `defines` are "NAME" or "NAME VALUE".
AssembledShader assembleShader(const ReadShader& read, const std::string& path,
                               const std::vector<std::string>& defines, Language language);

GLenum shaderStage(const std::string& path);

// "2:35(12): error: x" or "2(35) : error x" or "ERROR: 2:35: x" -> "shared/frame.glsl:35: ..."
std::string pointHome(const std::string& driverLog, const std::vector<std::string>& files);

}  // namespace vct::gl
