// This program again, in a process of its own.
#pragma once

#include <string>
#include <vector>

namespace vct::cli {

// Runs this program with `arguments`, its standard output thrown away, and waits for it. An interruption
// (Ctrl-C, a termination request) is passed on to it. Throws vct::Error with what it said on standard error,
// in one line, where it does not end with 0; `logFile` takes that text meanwhile.
void runSelf(const std::vector<std::string>& arguments, const std::string& logFile);

}  // namespace vct::cli
