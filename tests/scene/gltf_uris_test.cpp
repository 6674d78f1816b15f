// A scene may name files in its folder and below, and others only if that is allowed.
#include <gtest/gtest.h>

#include <filesystem>

#include "support/errors.h"
#include "support/gltf_builder.h"
#include "support/temporary_folder.h"

namespace vct::test {
namespace {

namespace fs = std::filesystem;

class Uris : public ::testing::Test {
  protected:
    Uris() {
        fs::create_directories(folder.file("scene/parts"));
        builder.triangle();
        for (const char* name : {"outside.bin", "scene/parts/inside.bin"})
            writeBytes(folder.file(name), builder.binary);
        fs::create_symlink("../outside.bin", folder.file("scene/leaves.bin"));
        fs::create_symlink("parts/inside.bin", folder.file("scene/stays.bin"));
        fs::create_directory_symlink("..", folder.file("scene/up"));
        // The name of another folder begins like that of the scene's folder.
        fs::create_directory(folder.file("scene2"));
        writeBytes(folder.file("scene2/a.bin"), builder.binary);
    }
    std::string errorFor(const std::string& uri, bool allowOutside = false) {
        writeBytes(folder.file("scene/a.gltf"), builder.gltf(uri));
        return errorOf(
            [&] { loadGltf(folder.file("scene/a.gltf"), readFileFromDisk, {.allowOutside = allowOutside}); });
    }

    TemporaryFolder folder;
    GltfBuilder builder;
};

TEST_F(Uris, FilesBelowTheSceneAreRead) {
    for (const char* uri :
         {"parts/inside.bin", "./parts/../parts/inside.bin", "stays.bin", "parts%2Finside.bin"})
        EXPECT_EQ(errorFor(uri), "") << uri;
}

TEST_F(Uris, FilesOutsideAreRefusedAfterLinksAreResolvedUnlessTheyAreAllowed) {
    for (const char* uri : {"../outside.bin", "..%2foutside.bin", "leaves.bin", "up/outside.bin",
                            "parts/../../outside.bin", "../scene2/a.bin"}) {
        const std::string error = errorFor(uri);
        expectMentions(error,
                       {"a.gltf", "buffer 0", ".bin, outside of the scene's folder", "allow files outside"});
        EXPECT_EQ(errorFor(uri, true), "") << uri;
    }
}

// The error must not reveal that there is no such file.
TEST_F(Uris, AMissingFileOutsideIsRefusedLikeAnyOther) {
    expectMentions(errorFor("../none.bin"), {"outside of the scene's folder"});
    expectMentions(errorFor("none.bin"), {"there is no such file"});
}

TEST_F(Uris, AnAbsolutePathIsBelowTheScene) {
    expectMentions(errorFor(folder.file("outside.bin"), true), {"there is no such file"});
}

TEST_F(Uris, ASceneOfTheWorkingFolderHasThatFolder) {
    writeBytes(folder.file("scene/a.gltf"), builder.gltf("../outside.bin"));
    const fs::path before = fs::current_path();
    fs::current_path(folder.file("scene"));
    const std::string error = errorOf([] { loadGltf("a.gltf"); });
    fs::current_path(before);
    expectMentions(error, {"outside of the scene's folder"});
}

}  // namespace
}  // namespace vct::test
