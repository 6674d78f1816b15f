// Reads the intent's string extra: activity.getIntent().getStringExtra(name). No other file calls Java.
#include "app/android/activity.h"

#include <jni.h>

namespace vct::app {

namespace {

// Attaches this thread to the Java virtual machine during its lifetime. Detaching frees the local references.
class Java {
  public:
    explicit Java(JavaVM* machine) : machine_(machine) {
        if (machine_->AttachCurrentThread(&env, nullptr) != JNI_OK) env = nullptr;
    }
    ~Java() {
        if (env == nullptr) return;
        if (env->ExceptionCheck()) env->ExceptionClear();
        machine_->DetachCurrentThread();
    }
    Java(const Java&) = delete;
    Java& operator=(const Java&) = delete;

    // Calls a method without parameters or with one string. Returns null if it does not exist or throws.
    jobject call(jobject object, const char* method, const char* signature, jstring argument = nullptr) {
        if (object == nullptr) return nullptr;
        const jclass type = env->GetObjectClass(object);
        const jmethodID id = env->GetMethodID(type, method, signature);
        env->DeleteLocalRef(type);
        return id == nullptr ? nullptr : env->CallObjectMethod(object, id, argument);
    }

    JNIEnv* env = nullptr;

  private:
    JavaVM* machine_;
};

}  // namespace

std::string intentExtra(ANativeActivity& activity, const char* name) {
    Java java(activity.vm);
    if (java.env == nullptr) return "";
    const jobject intent = java.call(activity.clazz, "getIntent", "()Landroid/content/Intent;");
    if (intent == nullptr) return "";
    const jstring key = java.env->NewStringUTF(name);
    const auto value = static_cast<jstring>(
        java.call(intent, "getStringExtra", "(Ljava/lang/String;)Ljava/lang/String;", key));
    if (value == nullptr) return "";
    const char* chars = java.env->GetStringUTFChars(value, nullptr);
    if (chars == nullptr) return "";
    const std::string text = chars;
    java.env->ReleaseStringUTFChars(value, chars);
    return text;
}

}  // namespace vct::app
