// Evaluates the preprocessor's conditions in a shader.
#pragma once

#include <string>

namespace vct {

// The source with spaces in place of comments, of directives, and of what #if and its kin exclude, so that
// positions stay. A macro of the driver counts as undefined. Throws vct::Error at a condition that it cannot
// read.
std::string activeSource(const std::string& source);

}  // namespace vct
