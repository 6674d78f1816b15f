// Text of a list for messages, shortened if the list is long.
#pragma once

#include <string>
#include <vector>

namespace vct {

// "a, b, c", or the first few and how many more: "a, b, c, d, e, f and 94 more".
inline std::string listText(const std::vector<std::string>& items) {
    constexpr std::size_t most = 6;
    std::string text;
    for (std::size_t i = 0; i < items.size() && i < most; ++i)
        text += (i == 0 ? "" : ", ") + items[i];
    return items.size() <= most ? text : text + " and " + std::to_string(items.size() - most) + " more";
}

}  // namespace vct
