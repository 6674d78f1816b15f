#include "app_library.h"

#include <android/dlext.h>
#include <dlfcn.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>

namespace stand_in {

namespace {

using Namespace = android_namespace_t;

constexpr const char* publicLibraries = "libandroid.so:liblog.so:libEGL.so:libz.so:libm.so:libdl.so:libc.so";
constexpr std::uint32_t targetSdk = 36;
constexpr std::uint64_t isolated = 1;          // ANDROID_NAMESPACE_TYPE_ISOLATED
constexpr std::uint64_t useNamespace = 0x200;  // ANDROID_DLEXT_USE_NAMESPACE
constexpr const char* allowedFolders = "/data:/mnt/expand";

[[noreturn]] void fail(const std::string& what) {
    const char* const reason = dlerror();
    std::fprintf(stderr, "activity: error: %s: %s\n", what.c_str(),
                 reason != nullptr ? reason : "no reason given");
    _exit(1);
}

template <typename Function>
Function* find(void* library, const char* name) {
    return reinterpret_cast<Function*>(dlsym(library, name));
}

// Android 7. A library is public if it is loaded before the namespace is made.
Namespace* createNamespace7(const char* folder) {
    const auto init = find<bool(const char*, const char*)>(RTLD_DEFAULT, "android_init_namespaces");
    if (init == nullptr) return nullptr;
    const std::string libraries = publicLibraries;
    for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
        end = libraries.find(':', begin);
        const std::string name = libraries.substr(begin, end - begin);
        if (dlopen(name.c_str(), RTLD_NOW | RTLD_NODELETE) == nullptr) fail(name);
    }
    if (!init(publicLibraries, "")) fail("android_init_namespaces");
    const auto create =
        find<Namespace*(const char*, const char*, const char*, std::uint64_t, const char*, Namespace*)>(
            RTLD_DEFAULT, "android_create_namespace");
    return create("app", nullptr, folder, isolated, allowedFolders, nullptr);
}

// Android 8 and later. The functions are those that the system's libnativeloader.so calls.
Namespace* createNamespace(const char* folder) {
    void* const linker = dlopen("ld-android.so", RTLD_NOW);
    if (linker == nullptr) fail("ld-android.so");
    const auto setTarget =
        find<void(std::uint32_t)>(linker, "__loader_android_set_application_target_sdk_version");
    const auto create =
        find<Namespace*(const char*, const char*, const char*, std::uint64_t, const char*, Namespace*,
                        const void*)>(linker, "__loader_android_create_namespace");
    const auto link =
        find<bool(Namespace*, Namespace*, const char*)>(linker, "__loader_android_link_namespaces");
    if (setTarget == nullptr || create == nullptr || link == nullptr) fail("this linker makes no namespaces");
    setTarget(targetSdk);
    Namespace* const app =
        create("app", nullptr, folder, isolated, allowedFolders, nullptr, __builtin_return_address(0));
    if (app != nullptr && !link(app, nullptr, publicLibraries)) fail("android_link_namespaces");
    return app;
}

}  // namespace

void* loadAppLibrary(const std::string& folder, const std::string& name) {
    Namespace* app = createNamespace7(folder.c_str());
    if (app == nullptr) app = createNamespace(folder.c_str());
    if (app == nullptr) fail("no namespace for the app");
    android_dlextinfo info{};
    info.flags = useNamespace;
    info.library_namespace = app;
    // A namespace that sees everything would hide a library that the APK lacks.
    if (android_dlopen_ext("libnot_public.so", RTLD_NOW, &info) != nullptr)
        fail("the namespace is not isolated");
    void* const library = android_dlopen_ext((folder + "/" + name).c_str(), RTLD_NOW, &info);
    if (library == nullptr) fail(name);
    return library;
}

}  // namespace stand_in
