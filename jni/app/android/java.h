// Calls of Java from the app's thread. Every call returns nothing if its method does not exist on this
// version of Android or throws, so that callers need no versions.
#pragma once

#include <jni.h>

#include <optional>

namespace vct::app {

// Attaches this thread to the Java virtual machine during its lifetime. Detaching frees the local references.
class Java {
  public:
    explicit Java(JavaVM* machine);
    ~Java();
    Java(const Java&) = delete;
    Java& operator=(const Java&) = delete;

    JNIEnv* env() const { return env_; }  // null: the thread cannot be attached

    // Calls a method with the arguments of its signature. The result of a call on a null object is null.
    template <typename... Arguments>
    jobject call(jobject object, const char* method, const char* signature, Arguments... arguments) const {
        const jmethodID id = methodOf(object, method, signature);
        if (id == nullptr) return nullptr;
        const jobject result = env_->CallObjectMethod(object, id, arguments...);
        return hasFailed() ? nullptr : result;
    }
    template <typename... Arguments>
    std::optional<int> callInt(jobject object, const char* method, const char* signature,
                               Arguments... arguments) const {
        const jmethodID id = methodOf(object, method, signature);
        if (id == nullptr) return {};
        const jint result = env_->CallIntMethod(object, id, arguments...);
        if (hasFailed()) return {};
        return result;
    }
    std::optional<int> intField(jobject object, const char* field) const;

  private:
    jmethodID methodOf(jobject object, const char* method, const char* signature) const;
    bool hasFailed() const;  // also clears the exception

    JavaVM* machine_;
    JNIEnv* env_ = nullptr;
};

}  // namespace vct::app
