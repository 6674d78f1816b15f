// Output folders and files of commands: checked before any slow work, and left as they were if the command
// fails.
#pragma once

#include <string>
#include <vector>

#include "core/files.h"

namespace vct::cli {

// A folder that the constructor creates if necessary and that can be written to. The destructor removes the
// folders that were created, if they are empty, unless keep() was called: a command that fails or is
// interrupted leaves nothing behind.
class OutputFolder {
  public:
    // Throws vct::Error if `path` cannot be created or written to.
    explicit OutputFolder(const std::string& path);
    ~OutputFolder();
    OutputFolder(const OutputFolder&) = delete;
    OutputFolder& operator=(const OutputFolder&) = delete;

    const std::string& path() const { return path_; }
    std::string file(const std::string& name) const { return path_ + "/" + name; }
    void keep() { created_.clear(); }

  private:
    void removeCreated();

    std::string path_;
    std::vector<RemovedOnInterruption> created_;  // the created folders, outermost first
};

// Throws vct::Error if something other than a file, such as a folder, is at `path`.
void requireNoFolder(const std::string& path);

// Throws vct::Error if no file can be written at `path`. Writes nothing.
void requireWritableFile(const std::string& path);

}  // namespace vct::cli
