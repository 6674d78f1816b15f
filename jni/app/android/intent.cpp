// Reads the intent's string extra: activity.getIntent().getStringExtra(name).
#include "app/android/activity.h"
#include "app/android/java.h"

namespace vct::app {

std::string intentExtra(ANativeActivity& activity, const char* name) {
    const Java java(activity.vm);
    const jobject intent = java.call(activity.clazz, "getIntent", "()Landroid/content/Intent;");
    if (intent == nullptr) return "";
    const jstring key = java.env()->NewStringUTF(name);
    const auto value = static_cast<jstring>(
        java.call(intent, "getStringExtra", "(Ljava/lang/String;)Ljava/lang/String;", key));
    if (value == nullptr) return "";
    const char* chars = java.env()->GetStringUTFChars(value, nullptr);
    if (chars == nullptr) return "";
    const std::string text = chars;
    java.env()->ReleaseStringUTFChars(value, chars);
    return text;
}

}  // namespace vct::app
