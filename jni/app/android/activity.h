// Queries to Android's activity: how the app was started, its folder, its screen and the fingers on it.
#pragma once

#include <android_native_app_glue.h>

#include <string>
#include <vector>

#include "app/free_area.h"
#include "app/touch.h"

namespace vct::app {

// Returns the string extra `name` of the intent that started the activity (`am start --es NAME VALUE`), or ""
// if there is none.
std::string intentExtra(ANativeActivity& activity, const char* name);

// The app's folder on the device, if possible the one that other programs can access. Empty if there is none.
std::string filesFolder(const ANativeActivity& activity);

// The screen's density over 160 dpi.
float pixelsPerDp(AConfiguration* configuration);

// Reads the insets of the activity's window; zero before the window's first layout.
WindowInsets windowInsets(ANativeActivity& activity);

// True if fingers touch the screen, move on it or leave it. Android also reports a mouse or pen above the
// screen, and wheels, as motion events.
bool isTouch(const AInputEvent* event);

// Every finger that is down after such an event.
std::vector<TouchPoint> fingersAfter(const AInputEvent* event);

}  // namespace vct::app
