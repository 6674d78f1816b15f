#include "gl/shader_source.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

#include "core/error.h"

namespace vct::gl {

namespace {

constexpr int maxIncludeDepth = 16;

std::string extensionOf(const std::string& path) {
    const std::size_t dot = path.rfind('.');
    return dot == std::string::npos ? "" : path.substr(dot);
}

// The only place with #version and extension lines. The default precision is highp: image and 3D sampler
// types have no default, and mediump has 16 bits on Mali.
std::string header(const std::string& stage, Language language) {
    if (language == Language::essl300)
        return "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";
    std::string text = language == Language::essl320 ? "#version 320 es\n" : "#version 310 es\n";
    if (language == Language::essl310) {
        if (stage == ".geom") text += "#extension GL_EXT_geometry_shader : require\n";
        // Enables `precise` if the driver has it (shared/dominant_axis.h).
        if (stage != ".frag") text += "#extension GL_EXT_gpu_shader5 : enable\n";
        if (stage == ".frag" || stage == ".comp") text += "#extension GL_OES_shader_image_atomic : require\n";
        // For the coverage of voxels (directional/coverage.glsl), if the driver has it.
        if (stage == ".frag") text += "#extension GL_OES_sample_variables : enable\n";
    }
    text += "precision highp float;\nprecision highp int;\n";
    for (const char* type :
         {"sampler2D", "sampler2DShadow", "sampler3D", "usampler2D", "usampler3D", "uimage3D"})
        text += "precision highp " + std::string(type) + ";\n";
    return text;
}

class Assembler {
  public:
    Assembler(const ReadShader& read, AssembledShader& source) : read_(read), source_(source) {}

    void append(const std::string& path, int depth) {
        if (depth > maxIncludeDepth)
            throw Error("shaders/" + path + ": #include nests deeper than " +
                        std::to_string(maxIncludeDepth) + " files; check whether a file includes itself");
        const std::size_t fileNumber = source_.files.size();
        source_.files.push_back(path);
        std::istringstream lines(read_(path));
        static const std::regex include(R"re(^\s*#\s*include\s+"([^"]+)"\s*$)re");
        std::string line;
        std::smatch match;
        for (int number = 1; std::getline(lines, line); ++number) {
            if (number == 1) setLine(1, fileNumber);
            if (std::regex_match(line, match, include)) {
                const std::string included = match[1];
                // Each file is included once.
                if (std::find(source_.files.begin(), source_.files.end(), included) == source_.files.end())
                    appendNested(included, path, number, depth);
                setLine(number + 1, fileNumber);
            } else {
                source_.text += line + '\n';
            }
        }
    }

  private:
    void appendNested(const std::string& included, const std::string& from, int line, int depth) {
        try {
            append(included, depth + 1);
        } catch (const Error& error) {
            throw Error("shaders/" + from + ":" + std::to_string(line) + ": " + error.what());
        }
    }
    void setLine(int line, std::size_t file) {
        source_.text += "#line " + std::to_string(line) + " " + std::to_string(file) + "\n";
    }
    const ReadShader& read_;
    AssembledShader& source_;
};

}  // namespace

ReadShader shadersFromFolder(const std::string& folder) {
    return [folder](const std::string& path) {
        // Only regular files are read, because reading a pipe might never end.
        std::error_code ignored;
        std::ifstream file;
        if (std::filesystem::is_regular_file(folder + "/" + path, ignored))
            file.open(folder + "/" + path, std::ios::binary);
        if (!file.is_open())
            throw Error("cannot read the shader " + folder + "/" + path +
                        "; set the project's folder of shaders (for vct: the variable VCT_SHADER_DIR)");
        std::ostringstream text;
        text << file.rdbuf();
        return text.str();
    };
}

AssembledShader assembleShader(const ReadShader& read, const std::string& path,
                               const std::vector<std::string>& defines, Language language) {
    AssembledShader source;
    source.text = header(extensionOf(path), language);
    for (const std::string& define : defines)
        source.text += "#define " + define + "\n";
    Assembler(read, source).append(path, 0);
    return source;
}

GLenum shaderStage(const std::string& path) {
    const std::string extension = extensionOf(path);
    if (extension == ".vert") return GL_VERTEX_SHADER;
    if (extension == ".geom") return GL_GEOMETRY_SHADER;
    if (extension == ".frag") return GL_FRAGMENT_SHADER;
    if (extension == ".comp") return GL_COMPUTE_SHADER;
    throw Error("shaders/" + path +
                ": its extension is not that of a shader stage; use .vert, .geom, .frag or .comp");
}

std::string locateInFiles(const std::string& driverLog, const std::vector<std::string>& files) {
    // Formats: Mesa "0:35(12): error", NVIDIA "0(35) : error", Arm and glslang "0:35: ..." after an optional
    // "ERROR: ".
    static const std::regex place(R"((^|\s)(\d+)(?:\((\d+)\)|:(\d+)(?:\(\d+\))?)\s*:)");
    std::istringstream lines(driverLog);
    std::string line, result;
    while (std::getline(lines, line)) {
        std::smatch match;
        if (std::regex_search(line, match, place)) {
            const std::size_t file = std::stoul(match[2]);
            const std::string number = match[3].matched ? match[3].str() : match[4].str();
            if (file < files.size())
                line = match.prefix().str() + match[1].str() + "shaders/" + files[file] + ":" + number + ":" +
                       match.suffix().str();
        }
        result += line + '\n';
    }
    return result;
}

}  // namespace vct::gl
