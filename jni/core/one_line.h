// Makes text from files and libraries fit into a message.
#pragma once

#include <string>

namespace vct {

// Text of a file as a part of a sentence: control characters become spaces, and long text is cut off.
std::string oneLine(std::string text);

// Message of a library or of another vct::Error as a part of a sentence: as oneLine(), without full stops and
// spaces at its end.
std::string asClause(const std::string& message);

}  // namespace vct
