// The temperature of the device, as Android tells it.
#pragma once

#include <optional>

namespace vct::app {

// The thermal headroom that Android forecasts for the next seconds: 1 is the start of severe throttling.
// Empty before Android 12, on devices that do not tell it, and if it was asked less than a second ago.
std::optional<float> thermalHeadroom();

}  // namespace vct::app
