// The sky all around a scene, out of a picture of all directions, for cones of any width.
//
// A cube map of halves: one fetch of a direction and a mip level is a cone's sky, filtered by the texture
// unit across the faces' borders and without a pole, which ES 3.1 has in its core.
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "engine/settings.h"
#include "gl/objects.h"
#include "image/image.h"

namespace vct {

constexpr int maxEnvironmentWidth = 8192;  // pixels of a picture

// A sky's radiance as a cube map on the CPU, in floats. Each texel of a level is the mean of those of the
// finer one, weighted by the solid angle that they fill: no light is lost or made from level to level, not
// even that of a sun of one pixel.
class Environment {
  public:
    // `picture`: equirectangular, linear radiance. Its centre is towards +X, its top edge towards +Y, and +Z
    // is a quarter of its width to the right of the centre, as in three.js and Khronos' glTF Sample Viewer.
    // `name` is the picture's in messages: throws vct::Error where it is not twice as wide as high, is wider
    // than maxEnvironmentWidth, or has pixels that are negative or not finite.
    Environment(const Image& picture, const std::string& name);

    // Along a face's edge; the coarsest level has the side 1.
    int side(int level = 0) const { return 1 << (levels() - 1 - level); }
    int levels() const { return static_cast<int>(levels_.size()); }
    // Face by face in GL's order, rows from t = 0 on.
    const std::vector<glm::vec3>& texels(int level) const { return levels_[level]; }

    // A bound of the irradiance over pi that a surface receives, in any channel: four times the mean over all
    // directions, which is what a surface receives of a sky that is all in the direction of its normal.
    float largestIrradiance() const;

    // RGBA16F, relative to `radianceUnit`. What halves cannot hold, a sun perhaps, is cut off in those levels
    // that are too fine for it, as skyRadiance is (frame_uniforms.cpp).
    gl::Texture texture(float radianceUnit) const;

  private:
    std::vector<std::vector<glm::vec3>> levels_;
};

}  // namespace vct
