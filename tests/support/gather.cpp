#include "support/gather.h"

#include "support/traced_frame.h"

namespace vct::test {

GatherResult gatherOver(const Context& context, const Scene& scene, const DirectionalLight& light,
                        const Settings& settings, const Camera& camera, int view,
                        const std::function<void(Words& base)>& editBase) {
    TracedFrame frame(context, scene, light, settings, volumeAround(scene.boundsWorld, settings.grid),
                      camera);
    Words base = frame.level(0);
    editBase(base);
    frame.replaceVoxels(base);

    GatherResult result;
    result.image = frame.view(view);
    const std::vector<SurfacePixel> pixels = frame.pixels();
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (!pixels[i].surface) continue;
        result.positions.push_back(pixels[i].positionVolume);
        result.values.push_back(result.image.pixels[i].x);
    }
    return result;
}

}  // namespace vct::test
