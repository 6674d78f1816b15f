// A renderer of a scene from one camera, whose pictures, G-buffer, voxels and received light are brought to
// the CPU. Which volume is around the scene, its bounds decide: a test may set them by hand.
#pragma once

#include <vector>

#include "engine/renderer.h"
#include "platform/platform.h"
#include "support/faces.h"
#include "support/received.h"
#include "support/voxels.h"

namespace vct::test {

// What the G-buffer says of a pixel.
struct SurfacePixel {
    bool surface = false;  // false: sky, and nothing else is set
    glm::dvec3 positionVolume{0.0}, positionWorld{0.0};
    glm::dvec3 normal{0.0};
    glm::dvec3 albedo{0.0};
};

// Of values, one after the other.
struct Spread {
    double mean = 0.0, min = 1e9, max = -1e9;
    int count = 0;
    void add(double value);
};

// Bounds around which the volume of a grid is [0, grid]^3: world units are voxels.
Bounds boundsForVoxelsAsWorld(int grid);

class FrameInspector {
  public:
    FrameInspector(const Context& context, Scene scene, const DirectionalLight& light,
                   const Settings& settings, const Camera& camera);

    Renderer& renderer() { return renderer_; }
    void setLight(const glm::dvec3& directionToLight);

    // A converged output, relative to E/pi. That of indirect light shows one bounce unless all are asked for.
    Image view(Output output);
    Image view(Output output, bool allBounces);
    // Share of the sun that each pixel sees, row by row from the top, by the compared map of mode 4 or by the
    // soft shadow of mode 5. The compared map's is 0 where the surface faces away.
    std::vector<float> hardShadow();
    std::vector<float> softShadow();
    // Row by row from the top, as in an Image.
    const std::vector<SurfacePixel>& pixels();
    // An output's red channel over the surfaces.
    Spread spreadOf(Output output);

    // The base level of the packed voxels; and that level replaced, whose other levels follow on the CPU.
    Words packedVoxels();
    void replacePackedVoxels(const Words& base);

    // The radiance that faces store as 1 in the last frame, relative to E/pi.
    double faceRange() const;
    // Of directional voxels: the faces, which shine with what they received only once received() was asked
    // for; and what each face received, converged with all bounces or with one.
    std::vector<FaceLevel> faceLevels();
    ReceivedFaces received(bool allBounces);

  private:
    Scene scene_;
    DirectionalLight light_;
    Settings settings_;
    Camera camera_;
    Renderer renderer_;
    std::vector<SurfacePixel> pixels_;
};

}  // namespace vct::test
