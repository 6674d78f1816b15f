// Writing files atomically, and removing unfinished ones when the process is interrupted.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace vct {

using Bytes = std::vector<unsigned char>;  // content of a file

// Writes a temporary file in the folder of `path` and renames it to `path`, so that nobody sees half a file.
// Leaves no temporary file behind. Throws vct::Error naming the file, the cause and the remedy. Also throws
// if `path` exists and is not a regular file (a device, for example), because the renaming would replace it.
void replaceFile(const std::string& path, const std::string& bytes);

// Returns 0 if a new file can be made in the folder of `path`, otherwise the errno of the failure. It tries
// to make one, because permission bits tell nothing to root, on a full disk or in /proc. Leaves nothing
// behind.
int causeNotWritable(const std::string& path);

// Registers a temporary file or a folder for removal when the process is interrupted; a folder is removed
// only if it is empty. The number of registrations at one time is limited: further paths are not removed.
class RemovedOnInterruption {
  public:
    explicit RemovedOnInterruption(std::string path);
    ~RemovedOnInterruption();
    RemovedOnInterruption(RemovedOnInterruption&& other) noexcept;
    RemovedOnInterruption& operator=(RemovedOnInterruption&&) = delete;

    const std::string& path() const { return *path_; }

  private:
    std::unique_ptr<const std::string> path_;  // at a fixed address, because the slot points into it
    int slot_ = -1;
};

// Removes all registered paths, the last one first. Safe to call from a signal handler: it uses only
// async-signal-safe functions.
void removeAfterInterruption();

}  // namespace vct
