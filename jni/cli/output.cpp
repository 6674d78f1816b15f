#include "cli/output.h"

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "core/error.h"
#include "core/files.h"

namespace vct::cli {

namespace fs = std::filesystem;

namespace {
[[noreturn]] void failToWrite(const std::string& path, const std::string& cause) {
    throw Error("cannot write '" + path + "': " + cause + "; choose a file in an existing, writable folder");
}
}  // namespace

OutputFolder::OutputFolder(const std::string& path) : path_(path) {
    const auto fail = [&](const std::string& cause) {
        removeCreated();
        throw Error("cannot write into the folder '" + path + "': " + cause +
                    "; choose another folder with --out");
    };
    std::error_code error;
    if (fs::exists(path, error) && !fs::is_directory(path, error)) fail("it is not a folder");
    std::vector<fs::path> missing;  // innermost first
    for (fs::path folder = fs::path(path).lexically_normal(); !folder.empty() && !fs::exists(folder, error);
         folder = folder.parent_path())
        missing.push_back(folder);
    // Each folder is registered for removal before it is created, because a signal may come in between. The
    // outermost comes first.
    for (auto folder = missing.rbegin(); folder != missing.rend() && !error; ++folder) {
        created_.emplace_back(folder->string());
        fs::create_directory(*folder, error);
    }
    if (error) fail(error.message());
    if (const int cause = causeNotWritable(file("vct"))) fail(std::strerror(cause));
}

OutputFolder::~OutputFolder() {
    removeCreated();
}

void OutputFolder::removeCreated() {
    std::error_code ignored;
    for (auto folder = created_.rbegin(); folder != created_.rend(); ++folder)
        fs::remove(folder->path(), ignored);
}

void requireNoFolder(const std::string& path) {
    std::error_code ignored;
    const fs::file_status found = fs::status(path, ignored);
    if (!fs::exists(found) || fs::is_regular_file(found)) return;
    failToWrite(path, fs::is_directory(found) ? std::strerror(EISDIR) : "it exists but is not a file");
}

void requireWritableFile(const std::string& path) {
    requireNoFolder(path);
    if (const int error = causeNotWritable(path)) failToWrite(path, std::strerror(error));
}

}  // namespace vct::cli
