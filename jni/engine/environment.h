// A sky that depends on direction: a cube map made from an equirectangular picture, for cones of any width.
//
// A cube map gives a cone its light by one fetch with a direction and a mip level. ES 3.1 filters it across
// the borders of its faces, and it has no poles.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "engine/settings.h"
#include "gl/objects.h"
#include "image/image.h"

namespace vct {

constexpr int maxEnvironmentWidth = 8192;  // pixels

// The sky's radiance as a cube map on the CPU, in floats. A texel is the mean of the four texels of the next
// finer level, weighted by solid angle, so that every level has the same total light, even if a sun is a
// single pixel.
class Environment {
  public:
    // `picture`: equirectangular, linear radiance. Its centre is towards +X, its top edge towards +Y, and +Z
    // is a quarter of its width to the right of the centre, as in three.js and Khronos' glTF Sample Viewer.
    // `name` names the picture in messages. Throws vct::Error if the picture is not twice as wide as high, is
    // wider than maxEnvironmentWidth, or has pixels that are negative or not finite.
    Environment(const Image& picture, const std::string& name);

    // Texels along a side of a face; 1 at the coarsest level.
    int side(int level = 0) const { return 1 << (levels() - 1 - level); }
    int levels() const { return static_cast<int>(levels_.size()); }
    // Face by face in GL's order, rows from t = 0 on.
    const std::vector<glm::vec3>& texels(int level) const { return levels_[level]; }

    // An upper bound of irradiance over pi on any surface, in any channel: four times the mean radiance. A
    // surface would receive this if all light came from the direction of its normal.
    float largestIrradiance() const;

    // The largest radiance of the finest level, in any channel.
    float largestRadiance() const;

    // RGBA16F, relative to `radianceUnit`.
    gl::Texture texture(float radianceUnit) const;

  private:
    std::vector<std::vector<glm::vec3>> levels_;
};

}  // namespace vct
