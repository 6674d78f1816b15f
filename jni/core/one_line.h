// Text of others as a part of a message.
#pragma once

#include <string>

namespace vct {

// Text of a file as a part of a sentence: one line, not too long.
std::string oneLine(std::string text);

// What a library or another vct::Error says, likewise, and without a full stop at its end.
std::string asClause(const std::string& message);

}  // namespace vct
