// Fits the near planes of cameras to the surfaces that they see.
#pragma once

#include "scene/bounds.h"
#include "scene/scene.h"

namespace vct {

class NearPlane {
  public:
    // The scene must outlive this object. Takes time proportional to the number of triangles.
    explicit NearPlane(const Scene& scene);

    // Returns the camera with its near plane (Camera::nearest) as far away as it may be without cutting off a
    // surface in the picture, but at most at usualNearPlane(). A depth buffer of 24 bits (or of floats
    // between 0 and 1, which are no finer near 1) resolves positions at distance z to about z^2 2^-24 / near,
    // so with a near plane of a millimetre in a room of ten metres positions are off by centimetres, and
    // shadow tests fail.
    //
    // `aspect` is the picture's width over its height, and `pose` the scene's pose, or null at rest. Visits
    // the bounds of all parts of the scene, the triangles of parts that are near, and all vertices of meshes
    // that deform; nothing if the near plane is far enough already.
    Camera fitted(Camera camera, double aspect, const Pose* pose = nullptr) const;

  private:
    // Triangles that follow each other in a mesh, and their bounds relative to Mesh::centre.
    struct Part {
        std::size_t firstIndex, lastIndex;
        Bounds bounds;
    };
    const Scene& scene_;
    std::vector<std::vector<Part>> parts_;  // per mesh
};

}  // namespace vct
