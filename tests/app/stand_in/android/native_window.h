#pragma once

#include <cstdint>

struct ANativeWindow;
int32_t ANativeWindow_getWidth(ANativeWindow* window);
int32_t ANativeWindow_getHeight(ANativeWindow* window);
