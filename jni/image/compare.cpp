#include "image/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"

namespace vct {
namespace {

std::string sizeOf(const Image& image) {
    return std::to_string(image.width) + " x " + std::to_string(image.height);
}

bool isFinite(const glm::vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

// Error text with the position of the first NaN or infinity; empty if all values are finite.
std::string firstNonFinite(const Image& image, const char* which) {
    const auto found = std::find_if_not(image.pixels.begin(), image.pixels.end(), isFinite);
    if (found == image.pixels.end()) return {};
    const auto index = static_cast<int>(found - image.pixels.begin());
    return std::string("the ") + which + " picture has a NaN or an infinity at pixel (" +
           std::to_string(index % image.width) + ", " + std::to_string(index / image.width) + ")";
}

}  // namespace

Difference compareImages(const Image& a, const Image& b, float maxDifference) {
    Difference result;
    if (a.width != b.width || a.height != b.height) {
        result.reason = "the first picture is " + sizeOf(a) + " pixels, the second " + sizeOf(b);
    } else if (a.pixels.empty()) {
        result.reason = "the pictures have no pixels";
    } else {
        result.reason = firstNonFinite(a, "first");
        if (result.reason.empty()) result.reason = firstNonFinite(b, "second");
    }
    result.comparable = result.reason.empty();
    if (!result.comparable) return result;

    double largest = 0.0;
    std::size_t differing = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        bool differs = false;
        for (int c = 0; c < 3; ++c) {
            const double x = a.pixels[i][c];
            const double y = b.pixels[i][c];
            const double difference = std::abs(x - y);
            // x, y and the limit are each rounded to float; 10/255 - 5/255 must not exceed 5/255 because of
            // that. A limit of 0 stays exact.
            const double rounding = 0x1p-22 * std::max({std::abs(x), std::abs(y), double(maxDifference)});
            differs = differs || difference > maxDifference + (maxDifference > 0.0F ? rounding : 0.0);
            largest = std::max(largest, difference);
        }
        if (differs) ++differing;
    }
    result.largest = static_cast<float>(std::min(largest, double(std::numeric_limits<float>::max())));
    result.fraction = static_cast<double>(differing) / static_cast<double>(a.pixels.size());
    return result;
}

Image differenceImage(const Image& a, const Image& b, float maxDifference) {
    if (a.width != b.width || a.height != b.height) {
        throw Error("cannot show the difference of pictures of " + sizeOf(a) + " and " + sizeOf(b) +
                    " pixels; render both at one size");
    }
    // Magenta is hard to mistake for a difference of finite values.
    const glm::vec3 notFinite(1.0F, 0.0F, 1.0F);
    Image result(a.width, a.height);
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const glm::vec3& x = a.pixels[i];
        const glm::vec3& y = b.pixels[i];
        if (!isFinite(x) || !isFinite(y)) {
            result.pixels[i] = notFinite;
            continue;
        }
        for (int c = 0; c < 3; ++c) {
            const double difference = std::abs(double(x[c]) - double(y[c]));
            // A viewer shows the picture as sRGB, so mid-grey is half of the encoded full scale.
            const double shown = difference > 0.0 ? std::min(0.5 * difference / maxDifference, 1.0) : 0.0;
            result.pixels[i][c] = srgbDecode(static_cast<float>(shown));
        }
    }
    return result;
}

}  // namespace vct
