#include "gl/program_binary.h"

#include <cstdio>
#include <cstring>

#include "core/hash.h"

namespace vct::gl {

namespace {

constexpr std::uint64_t secondBasis = 0x9E3779B97F4A7C15U;

// The beginning of a stored program.
struct Header {
    std::uint64_t hash;  // of all that follows
    std::uint32_t format, size;
};

}  // namespace

std::string programKey(const std::vector<std::string>& sources) {
    std::vector<std::string> parts{glString(GL_VENDOR), glString(GL_RENDERER), glString(GL_VERSION)};
    parts.insert(parts.end(), sources.begin(), sources.end());
    std::uint64_t first = fnvBasis, second = secondBasis;
    for (const std::string& part : parts) {
        // With the zero at its end, so that the parts are kept apart.
        first = fnv1a(part.c_str(), part.size() + 1, first);
        second = fnv1a(part.c_str(), part.size() + 1, second);
    }
    char text[33];
    std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(first),
                  static_cast<unsigned long long>(second));
    return text;
}

bool hasProgramBinaries() {
    GLint formats = 0;
    GetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
    return formats > 0;
}

std::vector<std::uint8_t> programBinary(GLuint program) {
    GLint length = 0;
    GetProgramiv(program, GL_PROGRAM_BINARY_LENGTH, &length);
    if (length <= 0) return {};
    std::vector<std::uint8_t> binary(sizeof(Header) + static_cast<std::size_t>(length));
    GLenum format = 0;
    GLsizei size = 0;
    GetProgramBinary(program, length, &size, &format, &binary[sizeof(Header)]);
    if (GetError() != GL_NO_ERROR || size <= 0) return {};
    binary.resize(sizeof(Header) + static_cast<std::size_t>(size));
    Header header{0, format, static_cast<std::uint32_t>(size)};
    std::memcpy(binary.data(), &header, sizeof header);
    header.hash = fnv1a(&binary[sizeof header.hash], binary.size() - sizeof header.hash);
    std::memcpy(binary.data(), &header, sizeof header);
    return binary;
}

bool loadProgramBinary(GLuint program, const std::vector<std::uint8_t>& binary) {
    Header header;
    if (binary.size() <= sizeof header) return false;
    std::memcpy(&header, binary.data(), sizeof header);
    if (header.size != binary.size() - sizeof header ||
        header.hash != fnv1a(&binary[sizeof header.hash], binary.size() - sizeof header.hash))
        return false;
    ProgramBinary(program, header.format, &binary[sizeof header], static_cast<GLsizei>(header.size));
    GLint ok = GL_FALSE;
    GetProgramiv(program, GL_LINK_STATUS, &ok);
    return GetError() == GL_NO_ERROR && ok == GL_TRUE;
}

}  // namespace vct::gl
