#include "image/tone_map.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "core/error.h"
#include "shared/tone_map.h"

namespace vct {

ToneMap toneMapFromText(const std::string& text) {
    if (text == "none") return ToneMap::none;
    if (text == "neutral") return ToneMap::neutral;
    if (text == "agx") return ToneMap::agx;
    if (text == "aces") return ToneMap::aces;
    throw Error("'" + text + "' is not a tone mapping; use neutral, agx, aces or none");
}

Image toneMapped(Image image, ToneMap toneMap, float exposure) {
    const auto curve = toneMap == ToneMap::agx    ? shared::agxToneMapped
                       : toneMap == ToneMap::aces ? shared::acesToneMapped
                                                  : shared::neutralToneMapped;
    for (glm::vec3& pixel : image.pixels) {
        pixel *= exposure;
        // Rendering errors can leave negative values and NaN, which the curves do not accept.
        if (toneMap != ToneMap::none)
            pixel = curve(glm::clamp(glm::mix(pixel, glm::vec3(0.0F), glm::isnan(pixel)), 0.0F, 1e30F));
    }
    return image;
}

float automaticExposure(const Image& image) {
    constexpr float middleGrey = 0.18F;  // reflectance of a grey card
    constexpr double brightPart = 0.99;
    constexpr float blackBeside = 1e-3F;
    std::vector<float> luminances;
    for (const glm::vec3& pixel : image.pixels) {
        const float luminance = glm::dot(pixel, glm::vec3(0.2126F, 0.7152F, 0.0722F));  // IEC 61966-2-1
        if (luminance > 0.0F && std::isfinite(luminance)) luminances.push_back(luminance);
    }
    if (luminances.empty()) return 1.0F;
    const auto bright = luminances.begin() +
                        static_cast<std::ptrdiff_t>(brightPart * static_cast<double>(luminances.size() - 1));
    std::nth_element(luminances.begin(), bright, luminances.end());
    const float least = blackBeside * *bright;
    double sum = 0.0;
    int count = 0;
    for (const float luminance : luminances)
        if (luminance > least) {
            sum += std::log(luminance);
            ++count;
        }
    char text[32];
    std::snprintf(text, sizeof text, "%.1e", std::clamp(middleGrey / std::exp(sum / count), 1e-30, 1e30));
    return std::strtof(text, nullptr);
}

Image withSky(Image image, const glm::vec3& background, const glm::vec3& sky) {
    constexpr float rounding = 2e-3F;  // of the half floats that pictures are rendered in
    for (glm::vec3& pixel : image.pixels)
        if (glm::all(glm::lessThanEqual(glm::abs(pixel - background), rounding * background))) pixel = sky;
    return image;
}

}  // namespace vct
