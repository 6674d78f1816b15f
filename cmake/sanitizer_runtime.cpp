// Part of programs built with the sanitizers only.

// The leak report at the end of a process names the library of each leak, and tests/lsan.supp excuses the drivers by that
// name; but Mesa's drivers are unloaded by then and would be nameless. So nothing is ever unloaded here.
extern "C" __attribute__((visibility("default"))) int dlclose(void*) { return 0; }

// While leaks are looked for, GCC 12's runtime follows its own list of each thread's thread-local blocks, and crashes
// ("Tracer caught signal 11") where one of the driver's threads is just ending: nine times in ten on a loaded machine for
// the shortest renders. Without the list, thread-local memory of libraries that came by dlopen is no root: none of ours.
extern "C" __attribute__((visibility("default"))) const char* __asan_default_options() { return "intercept_tls_get_addr=0"; }
