#include "core/files.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "core/error.h"

namespace vct {

void replaceFile(const std::string& path, const std::string& bytes) {
    const std::string temporary = path + ".tmp";
    const auto fail = [&](int cause) {
        throw Error("cannot write '" + path + "': " + std::strerror(cause) +
                    "; choose a file in an existing, writable folder with space left");
    };
    errno = 0;
    std::FILE* file = std::fopen(temporary.c_str(), "wb");
    if (file == nullptr) fail(errno);
    int cause = 0;
    if (std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size()) cause = errno;
    // What is still in the buffer is written here, so a full disk may show only now.
    if (std::fclose(file) != 0 && cause == 0) cause = errno;
    if (cause == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) cause = errno;
    if (cause != 0) {
        std::remove(temporary.c_str());
        fail(cause);
    }
}

}  // namespace vct
