// The state that the program activity.cpp and the stand-ins for Android's libraries share.
#pragma once

#include <android/asset_manager.h>
#include <android/input.h>

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

struct ANativeWindow {
    int width, height;
    bool alive = true;
};

struct AInputEvent {
    struct Point {
        int id;
        float x, y;
    };
    int type, action;
    std::int64_t timeNs;
    std::vector<Point> points;
};

namespace stand_in {

struct State {
    std::string apk;
    std::atomic<int> frames{0};          // how many the app has shown
    std::atomic<int> surfaces{0};        // how many windows have one
    std::atomic<int> traceDepth{0};      // sections of the trace that have not ended
    std::atomic<int> eventsFinished{0};  // how many the app has answered
    std::atomic<int> misuses{0};
    std::mutex mutex;
    std::string picturePath;  // the next frame is written there
};

State& state();

// Reports something that the app does and Android does not allow.
void reportMisuse(const char* what);

// Returns whether a line of the log since line `first` contains `text`.
bool isLogged(const std::string& text, std::size_t first);
std::size_t logSize();

AAssetManager* assetManager();
AInputQueue* createInputQueue();
void send(AInputQueue* queue, AInputEvent* event);

}  // namespace stand_in
