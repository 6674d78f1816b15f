// Linked into programs that are built with the sanitizers. Works around two problems of the leak check with
// Mesa's drivers.

// The leak check at the end of a process names the library of each leak, and tests/lsan.supp excuses the
// drivers by name. Mesa's drivers would be unloaded by then and have no name. Therefore this dlclose() never
// unloads a library.
extern "C" __attribute__((visibility("default"))) int dlclose(void*) {
    return 0;
}

// During the leak check GCC 12's runtime follows its own list of each thread's thread-local blocks, and
// crashes
// ("Tracer caught signal 11") if one of the driver's threads is ending: in nine of ten short renders on a
// loaded machine. Without the list, thread-local memory of libraries loaded by dlopen is not searched for
// pointers; this project has none.
extern "C" __attribute__((visibility("default"))) const char* __asan_default_options() {
    return "intercept_tls_get_addr=0";
}
