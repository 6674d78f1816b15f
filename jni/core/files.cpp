#include "core/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

#include "core/error.h"

namespace vct {
namespace {

// Paths registered by RemovedOnInterruption objects; null in a free slot.
std::atomic<const char*> removedOnInterruption[32];

// A new, uniquely named file in the folder of the file `beside`. O_EXCL never opens an existing file and
// follows no link. The destructor removes the file unless it was renamed.
class NewFile {
  public:
    explicit NewFile(const std::string& beside) {
        static std::atomic<unsigned> count{0};
        const std::string folder = beside.substr(0, beside.find_last_of('/') + 1);  // "" without a slash
        // A process that was killed, or one on another machine, may have left a file of the same name.
        for (int attempt = 0; descriptor_ < 0 && attempt < 1000; ++attempt) {
            path_ = folder + ".vct-" + std::to_string(getpid()) + "-" + std::to_string(count++) + ".tmp";
            descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
            cause_ = descriptor_ < 0 ? errno : 0;
            if (cause_ != EEXIST) break;
        }
        if (cause_ == 0) removed_.emplace(path_);
    }
    ~NewFile() {
        if (descriptor_ >= 0) close(descriptor_);
        if (removed_) unlink(path_.c_str());
    }
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    int cause() const { return cause_; }  // errno of the first failure, or 0

    void write(const std::string& bytes) {
        for (std::size_t done = 0; cause_ == 0 && done < bytes.size();) {
            const ssize_t written = ::write(descriptor_, bytes.data() + done, bytes.size() - done);
            if (written < 0 && errno != EINTR) cause_ = errno;
            if (written > 0) done += static_cast<std::size_t>(written);
        }
    }

    void renameTo(const std::string& path) {
        if (cause_ != 0) return;
        // A network file system may report a full disk only here.
        const int closed = close(descriptor_);
        descriptor_ = -1;
        if (closed != 0 || std::rename(path_.c_str(), path.c_str()) != 0)
            cause_ = errno;
        else
            removed_.reset();
    }

  private:
    std::string path_;
    int descriptor_ = -1;
    int cause_ = 0;
    std::optional<RemovedOnInterruption> removed_;
};

}  // namespace

RemovedOnInterruption::RemovedOnInterruption(std::string path)
    : path_(std::make_unique<const std::string>(std::move(path))) {
    for (int i = 0; slot_ < 0 && i < static_cast<int>(std::size(removedOnInterruption)); ++i) {
        const char* free = nullptr;
        if (removedOnInterruption[i].compare_exchange_strong(free, path_->c_str())) slot_ = i;
    }
}

RemovedOnInterruption::RemovedOnInterruption(RemovedOnInterruption&& other) noexcept
    : path_(std::move(other.path_)), slot_(std::exchange(other.slot_, -1)) {}

RemovedOnInterruption::~RemovedOnInterruption() {
    if (slot_ >= 0) removedOnInterruption[slot_] = nullptr;
}

void removeAfterInterruption() {
    for (std::size_t i = std::size(removedOnInterruption); i-- > 0;) {
        const char* const path = removedOnInterruption[i];
        if (path != nullptr && unlink(path) != 0) rmdir(path);
    }
}

int causeNotWritable(const std::string& path) {
    return NewFile(path).cause();
}

void replaceFile(const std::string& path, const std::string& bytes) {
    const auto fail = [&](const std::string& cause) {
        throw Error("cannot write '" + path + "': " + cause +
                    "; choose a file in an existing, writable folder with free space");
    };
    struct stat found{};
    if (stat(path.c_str(), &found) == 0 && !S_ISREG(found.st_mode))
        fail(S_ISDIR(found.st_mode) ? std::strerror(EISDIR) : "it exists but is not a file");
    NewFile file(path);
    file.write(bytes);
    file.renameTo(path);
    if (file.cause() != 0) fail(std::strerror(file.cause()));
}

}  // namespace vct
