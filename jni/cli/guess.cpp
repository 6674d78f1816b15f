#include "cli/guess.h"

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <utility>

namespace vct::cli {
namespace {

// Words of other programs, and names of options here.
constexpr std::pair<const char*, const char*> synonyms[] = {
    {"resolution", "size"},  {"width", "size"},          {"height", "size"},    {"spp", "samples"},
    {"hdri", "environment"}, {"hdr", "environment"},     {"sun", "light"},      {"fov", "camera"},
    {"quality", "preset"},   {"duration", "frames"},     {"output-dir", "out"}, {"file", "out"},
    {"gpu", "device"},       {"brightness", "exposure"}, {"voxels", "grid"},
};
constexpr std::size_t maxGuesses = 3;

std::string lowerWithoutDashes(const std::string& name) {
    std::string text = name.substr(std::min(name.find_first_not_of('-'), name.size()));
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text.substr(0, text.find('='));
}

// Number of letters that are added, left out or replaced, and of neighbours that are swapped.
std::size_t distanceBetween(const std::string& a, const std::string& b) {
    std::vector<std::size_t> before, previous(b.size() + 1), current(b.size() + 1);
    std::iota(previous.begin(), previous.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        current[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            current[j] = std::min(
                {previous[j] + 1, current[j - 1] + 1, previous[j - 1] + (a[i - 1] == b[j - 1] ? 0U : 1U)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                current[j] = std::min(current[j], before[j - 2] + 1);
        }
        before = previous;
        previous = current;
    }
    return previous[b.size()];
}

bool beginsWith(const std::string& text, const std::string& beginning) {
    return text.compare(0, beginning.size(), beginning) == 0;
}

}  // namespace

std::vector<std::string> guesses(const std::string& given, const std::vector<std::string>& names) {
    const std::string word = lowerWithoutDashes(given);
    if (word.empty()) return {};
    std::vector<std::string> prefixes, near;
    std::size_t nearest = std::max<std::size_t>(word.size() / 3, 1);
    for (const std::string& candidate : names) {
        const std::string name = lowerWithoutDashes(candidate);
        for (const auto& [other, meant] : synonyms)
            if (word == other && name == meant) return {candidate};
        if (beginsWith(name, word) || (name.size() > 2 && beginsWith(word, name)))
            prefixes.push_back(candidate);
        const std::size_t distance = distanceBetween(word, name);
        if (distance > nearest) continue;
        if (distance < nearest) near.clear();
        nearest = distance;
        near.push_back(candidate);
    }
    const std::vector<std::string>& found = prefixes.empty() ? near : prefixes;
    return found.size() <= maxGuesses ? found : std::vector<std::string>{};
}

std::string guessText(const std::vector<std::string>& guesses) {
    std::string text;
    for (std::size_t i = 0; i < guesses.size(); ++i)
        text += (i == 0 ? " (do you mean " : i + 1 == guesses.size() ? " or " : ", ") + guesses[i];
    return text.empty() ? "" : text + "?)";
}

bool isSceneFile(const std::string& word) {
    if (word.empty() || word.front() == '-') return false;
    const std::filesystem::path path(word);
    const std::string ending = lowerWithoutDashes(path.extension().string());
    std::error_code ignored;
    return ending == ".glb" || ending == ".gltf" || std::filesystem::is_regular_file(path, ignored);
}

}  // namespace vct::cli
