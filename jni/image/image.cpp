#include "image/image.h"

#include <cmath>

namespace vct {

float srgbEncode(float linear) {
    if (!(linear > 0.0F)) return 0.0F;  // NaN too
    if (linear >= 1.0F) return 1.0F;
    return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}

float srgbDecode(float encoded) {
    if (!(encoded > 0.0F)) return 0.0F;
    if (encoded >= 1.0F) return 1.0F;
    return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

}  // namespace vct
