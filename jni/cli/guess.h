// Errors about command lines: finds the option or command that a slip probably means.
#pragma once

#include <string>
#include <vector>

namespace vct::cli {

// Returns those of `names` that `given` probably means: a name that begins with it or that it begins with, a
// name of the same meaning, or one that differs by few letters. Empty if there is none, or if there are too
// many.
std::vector<std::string> guesses(const std::string& given, const std::vector<std::string>& names);

// " (do you mean A or B?)", or "" for no guesses.
std::string guessText(const std::vector<std::string>& guesses);

// True if a word of the command line is the name of a scene's file, and not that of a command or an option.
bool isSceneFile(const std::string& word);

}  // namespace vct::cli
