// What the app was started with.
#pragma once

#include <android_native_app_glue.h>

#include <string>

namespace vct::app {

// The string extra `name` of the intent that started the activity (`am start --es NAME VALUE`), "" without
// one.
std::string intentExtra(ANativeActivity& activity, const char* name);

}  // namespace vct::app
