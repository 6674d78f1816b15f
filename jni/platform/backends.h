// The back ends behind createPlatform(). Internal to this folder.
#pragma once

#include <memory>
#include <string>

#include "platform/platform.h"

namespace vct::detail {

// `remedy` ends the message of the error where nothing works.
std::unique_ptr<Platform> createEgl(const PlatformOptions& options, const std::string& remedy);
std::unique_ptr<Platform> createOsmesa(const PlatformOptions& options);
std::unique_ptr<Platform> createZink(const PlatformOptions& options);

// EGL gives the same display to everyone who asks, and its driver is chosen when the first one does.
bool eglInUse();

}  // namespace vct::detail
