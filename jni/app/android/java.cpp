#include "app/android/java.h"

namespace vct::app {

Java::Java(JavaVM* machine) : machine_(machine) {
    if (machine_->AttachCurrentThread(&env_, nullptr) != JNI_OK) env_ = nullptr;
}

Java::~Java() {
    if (env_ != nullptr) machine_->DetachCurrentThread();
}

std::optional<int> Java::intField(jobject object, const char* field) const {
    if (env_ == nullptr || object == nullptr) return {};
    const jclass type = env_->GetObjectClass(object);
    const jfieldID id = env_->GetFieldID(type, field, "I");
    env_->DeleteLocalRef(type);
    if (hasFailed()) return {};
    return env_->GetIntField(object, id);
}

jmethodID Java::methodOf(jobject object, const char* method, const char* signature) const {
    if (env_ == nullptr || object == nullptr) return nullptr;
    const jclass type = env_->GetObjectClass(object);
    const jmethodID id = env_->GetMethodID(type, method, signature);
    env_->DeleteLocalRef(type);
    return hasFailed() ? nullptr : id;
}

bool Java::hasFailed() const {
    if (!env_->ExceptionCheck()) return false;
    env_->ExceptionClear();
    return true;
}

}  // namespace vct::app
