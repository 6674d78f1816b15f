#include "core/one_line.h"

namespace vct {

std::string oneLine(std::string text) {
    constexpr std::size_t maxLength = 300;
    if (text.size() > maxLength) {
        std::size_t end = maxLength;
        while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
            --end;  // do not cut a UTF-8 character of several bytes
        text = text.substr(0, end) + "...";
    }
    for (char& c : text) {
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) c = ' ';
    }
    return text;
}

std::string asClause(const std::string& message) {
    std::string text = oneLine(message);
    while (!text.empty() && (text.back() == ' ' || text.back() == '.'))
        text.pop_back();
    return text;
}

}  // namespace vct
