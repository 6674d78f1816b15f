// Parses the modes that a user names.
#include "engine/output.h"

#include <algorithm>
#include <sstream>

#include "core/error.h"

namespace vct {

namespace {
constexpr const char* modeNames = "phong, shadow-map, ao, gi, gi-cone-shadow (or 1 to 5, or all)";
}  // namespace

const std::vector<Output>& allModes() {
    static const std::vector<Output> modes{Output::phong, Output::shadowMap, Output::ao, Output::gi,
                                           Output::giConeShadow};
    return modes;
}

std::vector<Output> modesFromText(const std::string& text) {
    if (text == "all") return allModes();
    std::vector<Output> modes;
    std::istringstream parts(text + ",");
    std::string part;
    while (std::getline(parts, part, ',')) {
        const auto named = std::find_if(allModes().begin(), allModes().end(), [&](Output mode) {
            return part == outputName(mode) || part == std::to_string(static_cast<int>(mode));
        });
        if (named == allModes().end())
            throw Error("'" + part + "' is not a mode; use " + modeNames + ", separated by commas");
        if (std::find(modes.begin(), modes.end(), *named) == modes.end()) modes.push_back(*named);
    }
    return modes;
}

}  // namespace vct
