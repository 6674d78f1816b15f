// Part of programs built with the sanitizers only. The leak report at the end of a process names the library of each
// leak, and tests/lsan.supp excuses the drivers by that name; but Mesa's drivers are unloaded by then and would be
// nameless. So nothing is ever unloaded here.
extern "C" __attribute__((visibility("default"))) int dlclose(void*) { return 0; }
