// Recognizes files of other formats, to tell how they become glTF.
#pragma once

#include <string>
#include <vector>

namespace vct {

// Names a file that is not glTF, and the way to convert it: two clauses for an error. Both are empty if
// neither the name nor the first bytes tell.
struct ForeignFile {
    std::string cause, remedy;
};
ForeignFile foreignFile(const std::string& path, const std::vector<unsigned char>& bytes);

}  // namespace vct
