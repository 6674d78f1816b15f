// Formats tables in Markdown.
#pragma once

#include <string>
#include <vector>

namespace vct {

using TableRows = std::vector<std::vector<std::string>>;

// Formats a number by a printf format for one double.
std::string cellText(const char* format, double value);

// Returns the table as Markdown, with the first row as the head. Columns are padded, so that the source text
// is readable too.
std::string markdownTable(const TableRows& rows);

}  // namespace vct
