// Bytes onto the disk, whole or not at all.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace vct {

using Bytes = std::vector<unsigned char>;  // what is read from a file

// Writes a new file in the folder of `path`, under a name of its own, and renames it, so that nobody sees
// half a file; leaves no temporary file behind. Throws vct::Error naming the file, the cause and the remedy:
// also where `path` is there and no file, as a device, which would be replaced.
void replaceFile(const std::string& path, const std::string& bytes);

// Whether a new file can be made in the folder of `path`: 0, or why not, as errno has it. Only an attempt
// tells: permissions say nothing to root, on a full disk or in /proc. Leaves nothing behind.
int causeNotWritable(const std::string& path);

// Something that this process has made and that goes away if it is interrupted: a temporary file, or a folder
// if nothing is in it. Only the first so many at a time are known; the others would stay.
class RemovedOnInterruption {
  public:
    explicit RemovedOnInterruption(std::string path);
    ~RemovedOnInterruption();
    RemovedOnInterruption(RemovedOnInterruption&& other) noexcept;
    RemovedOnInterruption& operator=(RemovedOnInterruption&&) = delete;

    const std::string& path() const { return *path_; }

  private:
    std::unique_ptr<const std::string> path_;  // does not move: the slot points into it
    int slot_ = -1;
};

// Removes what is left to be removed, the last first. For a handler of a signal that ends the process: calls
// nothing that such a one must not.
void removeAfterInterruption();

}  // namespace vct
