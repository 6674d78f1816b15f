#include "cli/output.h"

#include <algorithm>
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
    std::vector<fs::path> missing;
    for (fs::path folder = fs::path(path).lexically_normal(); !folder.empty() && !fs::exists(folder, error);
         folder = folder.parent_path())
        if (folder.has_filename()) missing.push_back(folder);
    std::reverse(missing.begin(), missing.end());
    for (const fs::path& folder : missing) {
        fs::create_directory(folder, error);
        if (error) fail(error.message());
        made_.push_back(folder);
    }
    if (!fs::is_directory(path, error)) fail(error ? error.message() : "it is not a folder");
    if (const int cause = causeNotWritable(file("vct"))) fail(std::strerror(cause));
}

OutputFolder::~OutputFolder() {
    removeMade();
}

void OutputFolder::removeMade() {
    std::error_code ignored;
    for (; !made_.empty(); made_.pop_back())
        fs::remove(made_.back(), ignored);
}

void requireWritableFile(const std::string& path) {
    std::error_code ignored;
    const int cause = fs::is_directory(path, ignored) ? EISDIR : causeNotWritable(path);
    if (cause != 0)
        throw Error("cannot write '" + path + "': " + std::strerror(cause) +
                    "; choose a file in an existing, writable folder");
}

}  // namespace vct::cli
