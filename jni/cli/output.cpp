#include "cli/output.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "core/error.h"

namespace vct::cli {

namespace fs = std::filesystem;

namespace {

// Only an attempt tells: permissions say nothing to root, on a full disk or in /proc. The name is the one
// that the file is written under before it is renamed.
int causeNotWritable(const std::string& path) {
    const std::string probe = path + ".tmp";
    std::FILE* file = std::fopen(probe.c_str(), "wb");
    if (file == nullptr) return errno;
    std::fclose(file);
    std::remove(probe.c_str());
    return 0;
}

}  // namespace

OutputFolder::OutputFolder(const std::string& path) : path_(path) {
    const auto fail = [&](const std::string& cause) {
        removeMade();
        throw Error("cannot write into the folder '" + path + "': " + cause + "; choose another --out");
    };
    std::error_code error;
    if (fs::exists(path, error) && !fs::is_directory(path, error)) fail("it is not a folder");
    for (fs::path folder = fs::path(path).lexically_normal(); !folder.empty() && !fs::exists(folder, error);
         folder = folder.parent_path())
        made_.push_back(folder);
    fs::create_directories(path, error);
    if (error) fail(error.message());
    if (const int cause = causeNotWritable(file("vct"))) fail(std::strerror(cause));
}

OutputFolder::~OutputFolder() {
    removeMade();
}

void OutputFolder::removeMade() {
    std::error_code ignored;
    for (const fs::path& folder : made_)
        fs::remove(folder, ignored);
}

void requireWritableFile(const std::string& path) {
    std::error_code ignored;
    const int cause = fs::is_directory(path, ignored) ? EISDIR : causeNotWritable(path);
    if (cause != 0)
        throw Error("cannot write '" + path + "': " + std::strerror(cause) +
                    "; choose a file in an existing, writable folder");
}

}  // namespace vct::cli
