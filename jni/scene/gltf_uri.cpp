#include <cctype>
#include <cstdint>
#include <string_view>

#include "core/error.h"
#include "scene/gltf_file.h"

namespace vct {
namespace {

// RFC 3986 section 2.1; a '%' without two digits stays as it is.
std::string percentDecoded(const std::string& text) {
    const auto isHexDigit = [&](std::size_t i) {
        return i < text.size() && std::isxdigit(static_cast<unsigned char>(text[i])) != 0;
    };
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '%' && isHexDigit(i + 1) && isHexDigit(i + 2)) {
            result += static_cast<char>(std::stoi(text.substr(i + 1, 2), nullptr, 16));
            i += 2;
        } else {
            result += text[i];
        }
    }
    return result;
}

// False where `text` holds a character that is not base64.
bool decodeBase64(const std::string& text, std::size_t begin, std::vector<unsigned char>& bytes) {
    // Values 62 and 63 are also written as in URLs: '-' and '_'.
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/-_";
    bytes.reserve((text.size() - begin) / 4 * 3 + 3);
    std::uint32_t bits = 0;
    int bitCount = 0;
    for (std::size_t i = begin; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '=') break;
        if (c == '\n' || c == '\r' || c == ' ' || c == '\t') continue;
        const std::size_t digit = digits.find(c);
        if (digit == std::string_view::npos) return false;
        bits = (bits << 6) | static_cast<std::uint32_t>(digit < 64 ? digit : digit - 2);
        bitCount += 6;
        if (bitCount >= 8) {
            bitCount -= 8;
            bytes.push_back(static_cast<unsigned char>((bits >> bitCount) & 0xFFU));
        }
    }
    return true;
}

}  // namespace

std::vector<unsigned char> readUri(const GltfFile& file, const std::string& uri, const std::string& what) {
    if (uri.compare(0, 5, "data:") == 0) {
        const std::size_t comma = uri.find(',');
        if (comma == std::string::npos) file.fail(what + " has a data URI without data");
        const std::string header = uri.substr(0, comma);
        std::vector<unsigned char> bytes;
        if (header.find(";base64") == std::string::npos) {
            const std::string text = percentDecoded(uri.substr(comma + 1));
            bytes.assign(text.begin(), text.end());
        } else if (!decodeBase64(uri, comma + 1, bytes)) {
            file.fail(what + " has a data URI that is not base64");
        }
        return bytes;
    }

    const std::size_t slash = file.path.find_last_of("/\\");
    const std::string folder = slash == std::string::npos ? std::string() : file.path.substr(0, slash + 1);
    const std::string path = folder + percentDecoded(uri);
    try {
        return file.readFile(path);
    } catch (const Error& error) {
        file.fail(what + " is in a file of its own, which fails (" + oneLine(error.what()) + ")",
                  "put " + oneLine(path) + " there, or export the scene as one .glb");
    }
}

}  // namespace vct
