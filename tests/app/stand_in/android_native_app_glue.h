// The parts of the NDK's native_app_glue that the app uses, for builds on a desktop. Names and values are the
// NDK's.
#pragma once

#include <android/asset_manager.h>
#include <android/configuration.h>
#include <android/input.h>
#include <android/native_window.h>

#include <cstddef>
#include <cstdint>

struct ANativeActivity {
    const char* internalDataPath;
    const char* externalDataPath;
    AAssetManager* assetManager;
};
void ANativeActivity_finish(ANativeActivity* activity);
void ANativeActivity_setWindowFlags(ANativeActivity* activity, uint32_t add, uint32_t remove);

struct android_app;
struct android_poll_source {
    int32_t id;
    android_app* app;
    void (*process)(android_app* app, android_poll_source* source);
};

struct android_app {
    void* userData;
    void (*onAppCmd)(android_app* app, int32_t command);
    int32_t (*onInputEvent)(android_app* app, AInputEvent* event);
    ANativeActivity* activity;
    AConfiguration* config;
    void* savedState;
    size_t savedStateSize;
    ANativeWindow* window;
    int destroyRequested;
};

enum { LOOPER_ID_MAIN = 1, LOOPER_ID_INPUT = 2 };
enum { ALOOPER_POLL_WAKE = -1, ALOOPER_POLL_CALLBACK = -2, ALOOPER_POLL_TIMEOUT = -3 };
int ALooper_pollOnce(int timeoutMs, int* fd, int* events, void** data);

enum {
    APP_CMD_INPUT_CHANGED,
    APP_CMD_INIT_WINDOW,
    APP_CMD_TERM_WINDOW,
    APP_CMD_WINDOW_RESIZED,
    APP_CMD_WINDOW_REDRAW_NEEDED,
    APP_CMD_CONTENT_RECT_CHANGED,
    APP_CMD_GAINED_FOCUS,
    APP_CMD_LOST_FOCUS,
    APP_CMD_CONFIG_CHANGED,
    APP_CMD_LOW_MEMORY,
    APP_CMD_START,
    APP_CMD_RESUME,
    APP_CMD_SAVE_STATE,
    APP_CMD_PAUSE,
    APP_CMD_STOP,
    APP_CMD_DESTROY,
};

void android_main(android_app* app);
