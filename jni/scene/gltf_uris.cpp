// Resolves the URIs of a glTF file, checks that the file may refer to them, and reads their content.
#include <algorithm>
#include <cctype>
#include <cstdint>
#include <filesystem>
#include <iterator>

#include "core/error.h"
#include "scene/gltf_file.h"

namespace vct {
namespace {

using Bytes = std::vector<unsigned char>;

// Decodes percent-encoding (RFC 3986 section 2.1). A '%' without two digits stays as it is.
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

bool isDataUri(const std::string& uri) {
    return uri.compare(0, 5, "data:") == 0;
}

}  // namespace

std::string resolvedUri(const GltfFile& file, const std::string& uri, const std::string& what) {
    if (isDataUri(uri)) return uri;
    namespace fs = std::filesystem;
    const std::size_t slash = file.path.find_last_of('/');
    const std::string folder = slash == std::string::npos ? "./" : file.path.substr(0, slash + 1);
    const std::string path = (slash == std::string::npos ? "" : folder) + percentDecoded(uri);
    std::error_code noFolder, noFile;
    const fs::path root = fs::weakly_canonical(folder, noFolder);
    const fs::path target = fs::weakly_canonical(path, noFile);
    if (noFolder || noFile) return path;  // reading it will report the reason
    // The path of a folder may end in an empty part, which paths of files in it do not have.
    const auto last = root.filename().empty() ? std::prev(root.end()) : root.end();
    const bool inside = std::mismatch(root.begin(), last, target.begin(), target.end()).first == last;
    if (!inside && !file.allowOutside)
        file.fail(what + " is the file " + oneLine(target.string()) + ", outside of the scene's folder " +
                      oneLine(root.string()),
                  "move it there, or allow files outside of the folder");
    return fs::exists(target, noFile) ? target.string() : path;
}

std::string identityOf(const std::string& resolved, const std::string& what) {
    return isDataUri(resolved) ? what : resolved;
}

std::vector<unsigned char> readResolved(GltfFile& file, const std::string& resolved,
                                        const std::string& what) {
    if (isDataUri(resolved)) {
        file.reserve(resolved.size() / 4 * 3, what);
        Bytes bytes;
        std::string mediaType;
        if (!tinygltf::DecodeDataURI(&bytes, mediaType, resolved, 0, false))
            file.fail(what + " has a data URI that is not base64 with a media type of glTF");
        return bytes;
    }
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(resolved, error);
    // A file in an APK has no size until it is read.
    if (!error) file.reserve(static_cast<std::size_t>(size), what + ", the file " + oneLine(resolved) + ",");
    try {
        Bytes bytes = file.readFile(resolved);
        if (error) file.reserve(bytes.size(), what);
        return bytes;
    } catch (const Error& failure) {
        file.fail(what + " is in a separate file that cannot be read (" + asClause(failure.what()) + ")",
                  "provide " + oneLine(resolved) + ", or export the scene as one .glb");
    }
}

}  // namespace vct
