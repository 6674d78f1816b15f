#include "java.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

namespace stand_in {

namespace {

std::string intentCommand;
bool isExceptionPending = false;
std::string activityObject = "activity", intentObject = "intent";  // Java objects are C++ strings
const std::string methods[] = {"getIntent()Landroid/content/Intent;",
                               "getStringExtra(Ljava/lang/String;)Ljava/lang/String;"};

template <typename Object>
Object toJava(const std::string& string) {
    return reinterpret_cast<Object>(const_cast<std::string*>(&string));
}
const std::string& fromJava(jobject object) {
    return *reinterpret_cast<const std::string*>(object);
}

void failUnknown() {
    std::fprintf(stderr, "misuse: the app calls a function of JNI that tools/android/java.cpp lacks\n");
    std::abort();
}

jmethodID findMethod(JNIEnv*, jclass, const char* name, const char* signature) {
    for (const std::string& method : methods)
        if (method == std::string(name) + signature) return toJava<jmethodID>(method);
    isExceptionPending = true;
    return nullptr;
}

jobject callMethod(JNIEnv*, jobject, jmethodID method, va_list arguments) {
    if (method == toJava<jmethodID>(methods[0])) return toJava<jobject>(intentObject);
    const bool known = fromJava(va_arg(arguments, jobject)) == "vct" && !intentCommand.empty();
    return known ? toJava<jobject>(intentCommand) : nullptr;
}

// A table of JNI whose functions all fail.
template <typename Table>
Table emptyTable() {
    Table table;
    auto* const functions = reinterpret_cast<void (**)()>(&table);
    std::fill_n(functions, sizeof table / sizeof *functions, failUnknown);
    return table;
}

}  // namespace

void makeJava(const std::string& command, JavaVM*& machine, JNIEnv*& environment, jobject& activity) {
    intentCommand = command;
    static JNINativeInterface functions = emptyTable<JNINativeInterface>();
    functions.GetObjectClass = [](JNIEnv*, jobject object) { return static_cast<jclass>(object); };
    functions.GetMethodID = findMethod;
    functions.CallObjectMethodV = callMethod;
    functions.DeleteLocalRef = [](JNIEnv*, jobject) {};
    functions.NewStringUTF = [](JNIEnv*, const char* text) {
        return toJava<jstring>(*new std::string(text));  // never freed: an app makes one at each start
    };
    functions.GetStringUTFChars = [](JNIEnv*, jstring string, jboolean*) { return fromJava(string).c_str(); };
    functions.ReleaseStringUTFChars = [](JNIEnv*, jstring, const char*) {};
    functions.ExceptionCheck = [](JNIEnv*) -> jboolean { return isExceptionPending; };
    functions.ExceptionClear = [](JNIEnv*) { isExceptionPending = false; };
    static JNIEnv ownEnvironment{&functions};

    static JNIInvokeInterface machineFunctions = emptyTable<JNIInvokeInterface>();
    machineFunctions.AttachCurrentThread = [](JavaVM*, JNIEnv** attached, void*) -> jint {
        *attached = &ownEnvironment;
        return JNI_OK;
    };
    machineFunctions.DetachCurrentThread = [](JavaVM*) -> jint { return JNI_OK; };
    static JavaVM ownMachine{&machineFunctions};

    machine = &ownMachine;
    environment = &ownEnvironment;
    activity = toJava<jobject>(activityObject);
}

}  // namespace stand_in
