#include "app/android/assets.h"

#include <algorithm>
#include <filesystem>
#include <memory>

#include "core/error.h"

namespace vct::app {

namespace {

std::vector<unsigned char> readAsset(AAssetManager* assets, const std::string& path) {
    const std::unique_ptr<AAsset, decltype(&AAsset_close)> asset(
        AAssetManager_open(assets, path.c_str(), AASSET_MODE_STREAMING), AAsset_close);
    if (!asset) throw Error("cannot read " + path + ": the APK has no such file; install the app again");
    std::vector<unsigned char> bytes(static_cast<std::size_t>(AAsset_getLength64(asset.get())));
    std::size_t done = 0;
    while (done < bytes.size()) {
        const int count = AAsset_read(asset.get(), bytes.data() + done, bytes.size() - done);
        if (count <= 0) throw Error("cannot read " + path + ": the APK is damaged; install the app again");
        done += static_cast<std::size_t>(count);
    }
    return bytes;
}

}  // namespace

gl::ReadShader shadersFromAssets(AAssetManager* assets) {
    return [assets](const std::string& path) {
        const std::vector<unsigned char> bytes = readAsset(assets, "shaders/" + path);
        return std::string(bytes.begin(), bytes.end());
    };
}

std::vector<FileChoice> findFiles(AAssetManager* assets, const std::string& folder,
                                  const std::vector<std::string>& extensions) {
    std::vector<FileChoice> files;
    const auto isFound = [&](const std::string& name) {
        return std::find(extensions.begin(), extensions.end(),
                         std::filesystem::path(name).extension().string()) != extensions.end();
    };
    const std::unique_ptr<AAssetDir, decltype(&AAssetDir_close)> bundled(
        AAssetManager_openDir(assets, "scenes"), AAssetDir_close);
    if (bundled)
        while (const char* name = AAssetDir_getNextFileName(bundled.get()))
            if (isFound(name)) files.push_back({name, std::string("scenes/") + name, true});
    std::error_code ignored;
    if (!folder.empty())
        for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
            if (isFound(entry.path().string()) && entry.is_regular_file(ignored))
                files.push_back({entry.path().filename().string(), entry.path().string(), false});
    std::sort(files.begin(), files.end(), [](const FileChoice& a, const FileChoice& b) {
        return a.bundled != b.bundled ? a.bundled : a.name < b.name;
    });
    return files;
}

ReadFile sceneReader(AAssetManager* assets, bool bundled, const std::atomic<bool>& cancelled) {
    return [assets, bundled, &cancelled](const std::string& path) {
        if (cancelled) throw Error("loading was cancelled");
        return bundled ? readAsset(assets, path) : readFileFromDisk(path);
    };
}

}  // namespace vct::app
