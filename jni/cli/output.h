// Where a command will write: found out before anything slow, and left as it was where the command fails.
#pragma once

#include <string>
#include <vector>

#include "core/files.h"

namespace vct::cli {

// A folder that is there, and can be written to, from the constructor on. Folders that it had to make go away
// again (if nothing is in them) unless keep() is called: a command that fails or is interrupted leaves
// nothing behind.
class OutputFolder {
  public:
    // Throws vct::Error where `path` cannot be made or written to.
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
    std::vector<RemovedOnInterruption> created_;  // outermost first
};

// Throws vct::Error where a file could not be written at `path`; writes nothing.
void requireWritableFile(const std::string& path);

}  // namespace vct::cli
