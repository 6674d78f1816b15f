// The shift of a picture, which anti-aliasing uses for parts of a pixel, is exact for whole pixels.
#include <gtest/gtest.h>

#include "scene/camera.h"
#include "scene/light_choice.h"
#include "support/renderers.h"
#include "support/scenes.h"

namespace vct::test {
namespace {

TEST(PictureShift, ByWholePixelsMovesThePictureAndKeepsTheLight) {
    const Context context = openContext(Backend::egl);
    const Scene scene = loadGltf(asset("contact.glb"));
    Renderer renderer = makeRenderer(context, scene, chooseLight(scene), mobileAt(64));
    const Camera front = chooseCamera(scene, "");
    renderer.render({{Output::gi}, front, LightSteps::all});
    const Image still = renderer.radiance();
    renderer.setPictureShift({3.0F, 2.0F});
    renderer.render({{Output::gi}, front});
    const Image moved = renderer.radiance();
    int different = 0;
    for (int y = 2; y < 64; ++y)
        for (int x = 0; x < 61; ++x)
            different += glm::length(moved.at(x + 3, y - 2) - still.at(x, y)) > 2e-3F;
    EXPECT_LT(different, 20);  // Edges whose rounding differs.
    renderer.setPictureShift({0.0F, 0.0F});
    renderer.render({{Output::gi}, front});
    EXPECT_EQ(renderer.radiance().pixels, still.pixels);
}

}  // namespace
}  // namespace vct::test
