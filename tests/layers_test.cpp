// The folders that make up the library include nothing of those that are built on it.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "support/temporary_folder.h"

namespace vct {
namespace {

TEST(Layers, TheLibraryIncludesNothingOfItsUsers) {
    const std::regex include("#include \"(lab|cli|app|desktop|platform)/[^\"]*\"");
    std::size_t files = 0;
    for (const char* folder : {"core", "gl", "image", "scene", "engine", "api"})
        for (const auto& entry :
             std::filesystem::recursive_directory_iterator(std::string(VCT_SOURCE_DIR "/jni/") + folder)) {
            if (!entry.is_regular_file()) continue;
            const std::string text = readBytes(entry.path().string());
            std::smatch found;
            EXPECT_FALSE(std::regex_search(text, found, include)) << entry.path() << ": " << found.str();
            ++files;
        }
    EXPECT_GT(files, 100U);
}

}  // namespace
}  // namespace vct
