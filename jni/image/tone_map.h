// Tone mapping: from radiance to linear values that a screen can show.
#pragma once

#include <string>

#include "image/image.h"

namespace vct {

// The tone mappers of shaders/shared/tone_map.h. With `none`, values above 1 are clamped.
enum class ToneMap { none, neutral, agx, aces };
// Accepts the names above; throws vct::Error naming all of them for any other text.
ToneMap toneMapFromText(const std::string& text);

// The result is linear. It lies in [0, 1], except with ToneMap::none.
Image toneMapped(Image image, ToneMap toneMap, float exposure);

// Exposure that brings the geometric mean of a picture's luminance to middle grey (Reinhard et al. 2002,
// "Photographic Tone Reproduction for Digital Images"). A small emitter hardly changes that mean, however
// bright it is. Pixels darker than a thousandth of the 99th percentile count as black and are left out. The
// result has two significant digits, so that the printed number reproduces it. It is 1 for a black picture.
float automaticExposure(const Image& image);

// Returns the picture with the sky in place of the background, so that a background does not change the
// exposure.
Image withSky(Image image, const glm::vec3& background, const glm::vec3& sky);

}  // namespace vct
