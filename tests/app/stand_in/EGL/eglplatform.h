// A native window is an ANativeWindow, as on Android.
#pragma once

#include <KHR/khrplatform.h>

#define EGLAPI KHRONOS_APICALL
#define EGLAPIENTRY KHRONOS_APIENTRY
#define EGLAPIENTRYP EGLAPIENTRY*

struct ANativeWindow;
typedef void* EGLNativeDisplayType;
typedef void* EGLNativePixmapType;
typedef struct ANativeWindow* EGLNativeWindowType;
typedef khronos_int32_t EGLint;
#define EGL_CAST(type, value) (static_cast<type>(value))
