// The tables 5.2 to 5.5 of the thesis.
#pragma once

#include <string>
#include <vector>

namespace vct {

struct TableRow {
    std::string platform;
    std::vector<double> valuesMs;
    // Over the runs; empty for what the thesis printed.
    std::vector<double> minMs = {}, maxMs = {};
};

struct ThesisTable {
    std::string number;  // as in the thesis, "5.2"
    std::string title;
    std::vector<std::string> columns;
    std::vector<TableRow> rows;
};

// The tables as they are printed in chapter 5.1.
std::vector<ThesisTable> thesisTables();

}  // namespace vct
