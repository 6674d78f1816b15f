// Bytes onto the disk, whole or not at all.
#pragma once

#include <string>
#include <vector>

namespace vct {

using Bytes = std::vector<unsigned char>;  // what is read from a file

// Writes `path.tmp` and renames it, so that nobody sees half a file; leaves no temporary file behind. Throws
// vct::Error naming the file, the cause and the remedy.
void replaceFile(const std::string& path, const std::string& bytes);

}  // namespace vct
