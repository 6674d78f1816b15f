// A renderer of a scene from one camera, which reads its outputs, G-buffer, voxels and face irradiance back
// to the CPU. The scene's bounds determine the volume around it; a test may set them by hand.
#pragma once

#include <vector>

#include "engine/renderer.h"
#include "lab/cpu_mips.h"
#include "platform/platform.h"
#include "support/face_irradiance.h"
#include "support/faces.h"

namespace vct::test {

// Cigolle et al. 2014: the octahedron unfolded into a square with two coordinates of 0..steps.
glm::dvec3 normalFromCode(std::uint32_t codeX, std::uint32_t codeY, double steps);

// The G-buffer at one pixel.
struct SurfacePixel {
    bool surface = false;  // false: sky, and nothing else is set
    glm::dvec3 positionVolume{0.0}, positionWorld{0.0};
    glm::dvec3 normal{0.0};
    glm::dvec3 albedo{0.0};
};

// A surface, and the output that is seen on it.
struct SeenSurface {
    const SurfacePixel& surface;
    glm::dvec3 value;
};

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

    // A converged output, relative to E/pi. Indirect light has one bounce unless all are asked for.
    Image view(Output output);
    Image view(Output output, bool allBounces);
    // A converged output at the pixels that show a surface.
    std::vector<SeenSurface> seen(Output output);
    // Share of the sun that each pixel sees, row by row from the top, by mode 2, by the compared map of mode
    // 4 (both 0 where the surface faces away) or by the soft shadow of mode 5.
    std::vector<float> mode2Shadow();
    std::vector<float> hardShadow();
    std::vector<float> softShadow();
    // Row by row from the top, as in an Image.
    const std::vector<SurfacePixel>& pixels();
    // The red channel of an output over the surfaces.
    Spread spreadOf(Output output);

    Words packedVoxels();  // the base level
    // The CPU computes the other levels.
    void replacePackedVoxels(Words base);

    // The faces of directional voxels, which emit and reflect direct light alone.
    Faces faces();
    // Converged irradiance of each face, with all bounces or with one.
    IrradianceByFace irradiance(bool allBounces);

  private:
    Scene scene_;
    DirectionalLight light_;
    Settings settings_;
    Camera camera_;
    Renderer renderer_;
    std::vector<SurfacePixel> pixels_;
};

}  // namespace vct::test
