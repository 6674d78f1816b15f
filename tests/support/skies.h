// Skies made in code.
#pragma once

#include <cmath>
#include <memory>

#include "engine/environment.h"
#include "support/scenes.h"

namespace vct::test {

// The direction of a pixel of an equirectangular picture; environment.h has the convention.
inline glm::dvec3 directionOfPixel(double x, double y, int width) {
    const double azimuth = (2.0 * (x + 0.5) / width - 1.0) * pi, polar = 2.0 * (y + 0.5) / width * pi;
    return {std::sin(polar) * std::cos(azimuth), std::cos(polar), std::sin(polar) * std::sin(azimuth)};
}

// `radiance`: a function of the direction.
template <class Radiance>
Image skyPicture(int width, const Radiance& radiance) {
    Image picture(width, width / 2);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < width; ++x)
            picture.at(x, y) = glm::vec3(radiance(directionOfPixel(x, y, width)));
    return picture;
}

template <class Radiance>
std::shared_ptr<const Environment> skyOf(const Radiance& radiance, int width = 256) {
    return std::make_shared<const Environment>(skyPicture(width, radiance), "of a test");
}

// A sky whose channels grow along the axes: red towards +X, green towards +Y, blue towards +Z. The mean over
// the hemisphere of a normal n, weighted by the cosine, is 1/2 + n/3.
inline glm::dvec3 skyAlongAxes(const glm::dvec3& direction) {
    return 0.5 + 0.5 * direction;
}

}  // namespace vct::test
