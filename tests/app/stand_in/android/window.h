#pragma once

enum { AWINDOW_FLAG_KEEP_SCREEN_ON = 0x80 };
