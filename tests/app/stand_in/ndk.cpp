// The NDK's functions, which call the stand-in that runs.
#include <android/choreographer.h>
#include <android/log.h>
#include <android/trace.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>

#include "app/android/activity.h"
#include "app/android/thermal.h"
#include "stand_in.h"

using vct::test::currentStandIn;
using vct::test::StandIn;

struct AAsset {
    std::string bytes;
    std::size_t read = 0;
};

struct AAssetDir {
    std::vector<std::string> names;
    std::size_t next = 0;
};

int ALooper_pollOnce(int timeoutMs, int*, int*, void** data) {
    return currentStandIn()->poll(timeoutMs, data);
}

struct AChoreographer {};

AChoreographer* AChoreographer_getInstance() {
    static AChoreographer choreographer;
    return &choreographer;
}

void AChoreographer_postFrameCallback(AChoreographer*, AChoreographer_frameCallback callback, void* data) {
    StandIn& android = *currentStandIn();
    if (android.atRefresh) android.misuse.push_back("one refresh was asked for twice");
    android.atRefresh = [callback, data](std::int64_t timeNs) { callback(timeNs, data); };
}

int __android_log_write(int priority, const char*, const char* text) {
    static std::mutex mutex;  // the app's threads log too
    const std::lock_guard<std::mutex> lock(mutex);
    if (StandIn* const android = currentStandIn()) android->log.push_back({priority, text});
    return 1;
}

void ATrace_beginSection(const char* name) {
    StandIn& android = *currentStandIn();
    ++android.traceDepth;
    auto& seen = android.traceSections;
    if (std::find(seen.begin(), seen.end(), name) == seen.end()) seen.emplace_back(name);
}

void ATrace_endSection() {
    if (StandIn* const android = currentStandIn()) --android->traceDepth;
}

void ANativeActivity_finish(ANativeActivity*) {
    currentStandIn()->finished = true;
}

void ANativeActivity_setWindowFlags(ANativeActivity*, uint32_t add, uint32_t remove) {
    currentStandIn()->windowFlags |= add;
    currentStandIn()->windowFlags &= ~remove;
}

int32_t ANativeWindow_getWidth(ANativeWindow* window) {
    if (window == nullptr || !window->alive) {
        currentStandIn()->misuse.push_back("the size of a dead window was asked for");
        return 0;
    }
    return window->width;
}

int32_t ANativeWindow_getHeight(ANativeWindow* window) {
    return window != nullptr && window->alive ? window->height : 0;
}

int32_t AConfiguration_getDensity(AConfiguration* configuration) {
    return configuration->density;
}

AAsset* AAssetManager_open(AAssetManager*, const char* name, int) {
    const StandIn& android = *currentStandIn();
    const std::string path = name;
    const bool shader = path.rfind("shaders/", 0) == 0;
    const std::string file = shader ? VCT_SOURCE_DIR "/" + path : android.scenes + path.substr(6);
    std::ifstream stream(file, std::ios::binary);
    if (!stream) return nullptr;
    auto* const asset = new AAsset{{std::istreambuf_iterator<char>(stream), {}}, 0};
    const std::size_t at =
        shader && !android.shadersFrom.empty() ? asset->bytes.find(android.shadersFrom) : std::string::npos;
    if (at != std::string::npos) asset->bytes.replace(at, android.shadersFrom.size(), android.shadersTo);
    return asset;
}

AAssetDir* AAssetManager_openDir(AAssetManager*, const char* name) {
    auto* const folder = new AAssetDir;
    if (std::string(name) == "scenes")
        for (const auto& entry : std::filesystem::directory_iterator(currentStandIn()->scenes))
            folder->names.push_back(entry.path().filename().string());
    return folder;
}

int64_t AAsset_getLength64(AAsset* asset) {
    return static_cast<int64_t>(asset->bytes.size());
}

int AAsset_read(AAsset* asset, void* buffer, size_t count) {
    const std::size_t some = std::min(count, asset->bytes.size() - asset->read);
    std::memcpy(buffer, asset->bytes.data() + asset->read, some);
    asset->read += some;
    return static_cast<int>(some);
}

void AAsset_close(AAsset* asset) {
    delete asset;
}

const char* AAssetDir_getNextFileName(AAssetDir* folder) {
    return folder->next < folder->names.size() ? folder->names[folder->next++].c_str() : nullptr;
}

void AAssetDir_close(AAssetDir* folder) {
    delete folder;
}

int32_t AInputEvent_getType(const AInputEvent* event) {
    return event->type;
}

int32_t AMotionEvent_getAction(const AInputEvent* event) {
    return event->action;
}

size_t AMotionEvent_getPointerCount(const AInputEvent* event) {
    return event->pointers.size();
}

int32_t AMotionEvent_getPointerId(const AInputEvent* event, size_t index) {
    return event->pointers.at(index).id;
}

float AMotionEvent_getX(const AInputEvent* event, size_t index) {
    return event->pointers.at(index).x;
}

float AMotionEvent_getY(const AInputEvent* event, size_t index) {
    return event->pointers.at(index).y;
}

int64_t AMotionEvent_getEventTime(const AInputEvent* event) {
    return event->timeNs;
}

namespace vct::app {

std::string intentExtra(ANativeActivity&, const char* name) {
    return std::string(name) == "vct" ? currentStandIn()->intentExtra : "";
}

WindowInsets windowInsets(ANativeActivity&) {
    return currentStandIn()->insets;
}

std::optional<float> thermalHeadroom() {
    return currentStandIn()->headroom;
}

}  // namespace vct::app
