// The back ends of createPlatform(). Internal to this folder.
#pragma once

#include <memory>
#include <string>

#include "platform/platform.h"

namespace vct::detail {

// `remedy` is appended to the error message if no display has a driver.
std::unique_ptr<Platform> createEgl(const PlatformOptions& options, const std::string& remedy);
std::unique_ptr<Platform> createOsmesa(const PlatformOptions& options);
std::unique_ptr<Platform> createZink(const PlatformOptions& options);

// True if an EGL platform exists. All of them share a display, whose driver is chosen by the first one.
bool eglInUse();

}  // namespace vct::detail
