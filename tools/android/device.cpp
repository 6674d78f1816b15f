// A stand-in for Android's libandroid.so: windows, the device's configuration, and the assets of an APK.
#include <android/configuration.h>
#include <android/native_activity.h>
#include <android/trace.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>

#include "stand_in.h"

using stand_in::reportMisuse;
using stand_in::state;

struct AConfiguration {};

struct AAssetManager {
    std::map<std::string, std::string> files;  // contents by name
};
struct AAsset {
    const std::string& bytes;
    std::size_t position = 0;
};
struct AAssetDir {
    std::vector<std::string> names;
    std::size_t next = 0;
};

namespace {

template <typename T>
T readFrom(const std::string& bytes, std::size_t offset) {
    T value{};
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

std::string inflated(const std::string& zip, std::size_t offset, std::size_t packedSize, std::size_t size) {
    std::string bytes(size, '\0');
    z_stream stream{};
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(zip.data() + offset));
    stream.avail_in = static_cast<uInt>(packedSize);
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data());
    stream.avail_out = static_cast<uInt>(size);
    inflateInit2(&stream, -MAX_WBITS);
    if (inflate(&stream, Z_FINISH) != Z_STREAM_END) reportMisuse("the APK has a damaged asset");
    inflateEnd(&stream);
    return bytes;
}

// Reads the folder assets/ of an APK, which is a ZIP archive, through its directory.
AAssetManager readAssets(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string zip(std::istreambuf_iterator<char>(file), {});
    const std::size_t end = zip.rfind("PK\5\6");
    if (end == std::string::npos) {
        std::fprintf(stderr, "activity: error: %s is not an APK\n", path.c_str());
        _exit(1);
    }
    AAssetManager assets;
    const std::string prefix = "assets/";
    std::size_t entry = readFrom<std::uint32_t>(zip, end + 16);
    for (int left = readFrom<std::uint16_t>(zip, end + 10); left > 0; --left) {
        const std::size_t nameSize = readFrom<std::uint16_t>(zip, entry + 28);
        const std::string name = zip.substr(entry + 46, nameSize);
        const bool packed = readFrom<std::uint16_t>(zip, entry + 10) != 0;
        const std::size_t packedSize = readFrom<std::uint32_t>(zip, entry + 20);
        const std::size_t size = readFrom<std::uint32_t>(zip, entry + 24);
        std::size_t offset = readFrom<std::uint32_t>(zip, entry + 42);
        offset += 30 + readFrom<std::uint16_t>(zip, offset + 26) + readFrom<std::uint16_t>(zip, offset + 28);
        if (name.rfind(prefix, 0) == 0)
            assets.files[name.substr(prefix.size())] =
                packed ? inflated(zip, offset, packedSize, size) : zip.substr(offset, size);
        entry += 46 + nameSize + readFrom<std::uint16_t>(zip, entry + 30) +
                 readFrom<std::uint16_t>(zip, entry + 32);
    }
    return assets;
}

int32_t sideOf(const ANativeWindow* window, int ANativeWindow::* side) {
    if (window != nullptr && window->alive) return window->*side;
    reportMisuse("a destroyed window is asked for its size");
    return 0;
}

}  // namespace

namespace stand_in {

State& state() {
    static State state;
    return state;
}

void reportMisuse(const char* what) {
    std::fprintf(stderr, "misuse: %s\n", what);
    ++state().misuses;
}

AAssetManager* assetManager() {
    static AAssetManager assets = readAssets(state().apk);
    return &assets;
}

}  // namespace stand_in

extern "C" {

int32_t ANativeWindow_getWidth(ANativeWindow* window) {
    return sideOf(window, &ANativeWindow::width);
}
int32_t ANativeWindow_getHeight(ANativeWindow* window) {
    return sideOf(window, &ANativeWindow::height);
}

void ANativeActivity_finish(ANativeActivity*) {}
void ANativeActivity_setWindowFlags(ANativeActivity*, uint32_t, uint32_t) {}

void ATrace_beginSection(const char*) {
    ++state().traceDepth;
}
void ATrace_endSection() {
    --state().traceDepth;
}

AConfiguration* AConfiguration_new() {
    return new AConfiguration;
}
void AConfiguration_delete(AConfiguration* configuration) {
    delete configuration;
}
void AConfiguration_fromAssetManager(AConfiguration*, AAssetManager*) {}
int32_t AConfiguration_getDensity(AConfiguration*) {
    return ACONFIGURATION_DENSITY_XHIGH;
}
void AConfiguration_getLanguage(AConfiguration*, char* language) {
    std::memcpy(language, "en", 2);
}
void AConfiguration_getCountry(AConfiguration*, char* country) {
    std::memcpy(country, "GB", 2);
}

AAsset* AAssetManager_open(AAssetManager* assets, const char* name, int) {
    const auto found = assets->files.find(name);
    return found == assets->files.end() ? nullptr : new AAsset{found->second};
}
off64_t AAsset_getLength64(AAsset* asset) {
    return static_cast<off64_t>(asset->bytes.size());
}
int AAsset_read(AAsset* asset, void* bytes, size_t size) {
    size = std::min(size, asset->bytes.size() - asset->position);
    std::memcpy(bytes, asset->bytes.data() + asset->position, size);
    asset->position += size;
    return static_cast<int>(size);
}
void AAsset_close(AAsset* asset) {
    delete asset;
}

AAssetDir* AAssetManager_openDir(AAssetManager* assets, const char* folder) {
    const std::string prefix = std::string(folder) + "/";
    auto* const files = new AAssetDir;
    for (const auto& [name, bytes] : assets->files)
        if (name.rfind(prefix, 0) == 0 && name.find('/', prefix.size()) == std::string::npos)
            files->names.push_back(name.substr(prefix.size()));
    return files;
}
const char* AAssetDir_getNextFileName(AAssetDir* files) {
    return files->next < files->names.size() ? files->names[files->next++].c_str() : nullptr;
}
void AAssetDir_close(AAssetDir* files) {
    delete files;
}

}  // extern "C"
