// Tables for people, in Markdown.
#pragma once

#include <string>
#include <vector>

namespace vct {

using TableRows = std::vector<std::vector<std::string>>;

// A number by a printf format for one double.
std::string cellText(const char* format, double value);

// The first row is the head; the columns are padded, so that the text can be read as it is.
std::string markdownTable(const TableRows& rows);

}  // namespace vct
