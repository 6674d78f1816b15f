// From radiance to what a screen shows, before it is encoded.
#pragma once

#include <string>

#include "image/image.h"

namespace vct {

enum class ToneMap {
    none,     // cut off at 1
    neutral,  // shaders/shared/tone_map.h
};
// "none" or "neutral"; throws vct::Error listing them.
ToneMap toneMapFromText(const std::string& text);

// Linear, 0 to 1 with ToneMap::neutral.
Image toneMapped(Image image, ToneMap toneMap, float exposure);

// The exposure with which a picture's luminances are about middle grey in their geometric mean (Reinhard et
// al. 2002, "Photographic Tone Reproduction for Digital Images"): a small lamp, however bright, hardly moves
// it. What is a thousandth as bright as the bright parts or less is black, and does not count. Two
// significant digits, so that what is printed repeats it. 1 where everything is black.
float automaticExposure(const Image& image);

}  // namespace vct
