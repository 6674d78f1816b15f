#include "lab/table.h"

#include <algorithm>
#include <cstdio>

namespace vct {

std::string cellText(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string markdownTable(const TableRows& rows) {
    std::vector<std::size_t> widths(rows.front().size());
    for (const auto& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i)
            widths[i] = std::max(widths[i], row[i].size());
    std::string text;
    const auto add = [&](std::size_t column, const std::string& cell, char fill, char end) {
        const std::string padding(widths[column] - cell.size(), fill);
        text += (column == 0 ? std::string("|") : std::string()) + fill +
                (column == 0 ? cell + padding : padding + cell) + end + "|";
    };
    for (const auto& row : rows) {
        for (std::size_t i = 0; i < widths.size(); ++i)
            add(i, row[i], ' ', ' ');
        text += "\n";
        if (&row != &rows.front()) continue;
        for (std::size_t i = 0; i < widths.size(); ++i)
            add(i, "", '-', i == 0 ? '-' : ':');
        text += "\n";
    }
    return text;
}

}  // namespace vct
