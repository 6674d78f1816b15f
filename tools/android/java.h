// A stand-in for Android's Java, as much of it as the app calls: the intent of the activity and its extra.
#pragma once

#include <jni.h>

#include <string>

namespace stand_in {

// Writes the machine, the environment and the activity object that the app gets. `command` is the intent's
// extra "vct".
void makeJava(const std::string& command, JavaVM*& machine, JNIEnv*& environment, jobject& activity);

}  // namespace stand_in
