// The shader's cones against the CPU's, over the same voxels and pixels: within rounding.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "scene/camera.h"
#include "support/cpu_packed_cones.h"
#include "support/frame_inspector.h"
#include "support/renderers.h"

namespace vct::test {
namespace {

// The picture is RGBA16F (half a step is 2^-11 of the value), positions are float. Where rounding decides
// whether a cone goes on, a pixel may differ by the sample that one of them took more.
constexpr double roundingDifference =
    1e-3;                                  // of radiance relative to E/pi, of ambientVisibility and of light
constexpr double roundingFraction = 1e-3;  // of the pixels' channels may differ by more

// How far apart two views are, channel by channel.
class Differences {
  public:
    void add(const glm::vec3& shader, const glm::dvec3& cpu) {
        for (int c = 0; c < 3; ++c) {
            const double difference = std::abs(shader[c] - cpu[c]);
            largest_ = std::max(largest_, difference);
            ++count_;
            if (difference > roundingDifference * std::max(1.0, cpu[c])) ++beyond_;
            brightest_ = std::max(brightest_, cpu[c]);
        }
    }
    void expectSmall(const char* name) const {
        std::printf("  %-9s beyond %g: %zu of %zu, largest %.5f, brightest pixel %.3f\n", name,
                    roundingDifference, beyond_, count_, largest_, brightest_);
        EXPECT_GT(brightest_, 0.1) << name << ": there is nothing to compare";
        EXPECT_LE(static_cast<double>(beyond_), roundingFraction * static_cast<double>(count_)) << name;
    }

  private:
    std::size_t count_ = 0, beyond_ = 0;
    double largest_ = 0.0, brightest_ = 0.0;
};

// One scene at each of two grids: what differs between scenes is how many steps a cone takes.
class ConeTracerOf : public testing::TestWithParam<std::pair<const char*, int>> {};
INSTANTIATE_TEST_SUITE_P(Scenes, ConeTracerOf,
                         testing::Values(std::pair("cornell", 128), std::pair("courtyard", 64)),
                         [](const auto& test) { return std::string(test.param.first); });

TEST_P(ConeTracerOf, ShaderEqualsTheCpuWithinRounding) {
    const auto [name, grid] = GetParam();
    const Context context = openContext(Backend::egl);
    const Scene scene = loadGltf(asset(std::string(name) + ".glb"));
    Settings settings = smallSettings(grid, 96);
    settings.skyRadiance = glm::vec3(0.2F, 0.3F, 0.5F);
    FrameInspector frame(context, scene, chooseLight(scene), settings, chooseCamera(scene, ""));
    const CpuConeTracer cpu(frame.packedLevels(), frame.uniforms());
    const glm::dvec3 towardsLight(frame.uniforms().towardsLight);
    const std::vector<SurfacePixel>& pixels = frame.pixels();
    const Image indirect = frame.view(VCT_VIEW_INDIRECT);
    const Image ao = frame.view(VCT_VIEW_AO);
    const Image coneShadow = frame.view(VCT_VIEW_CONE_SHADOW);

    Differences ofIndirect, ofAo, ofShadow;
    int surfaces = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const SurfacePixel& pixel = pixels[i];
        if (!pixel.surface) continue;
        const CpuConeTracer::Gather all = cpu.gather(pixel.positionVolume, pixel.normal, 1.0);
        const CpuConeTracer::Gather near =
            cpu.gather(pixel.positionVolume, pixel.normal, frame.uniforms().aoDistance);
        CpuConeTracer::Shadow shadow{0.0, 0};
        if (glm::dot(pixel.normal, towardsLight) > 0.0)
            shadow = cpu.shadow(pixel.positionVolume, pixel.normal);
        ofIndirect.add(indirect.pixels[i], pixel.albedo * all.radiance);
        ofAo.add(ao.pixels[i], glm::dvec3(near.ambientVisibility));
        ofShadow.add(coneShadow.pixels[i], glm::dvec3(shadow.light));
        ++surfaces;
    }
    ASSERT_GT(surfaces, 5000);
    ofIndirect.expectSmall("indirect");
    ofAo.expectSmall("occlusion");
    ofShadow.expectSmall("shadow");
}

}  // namespace
}  // namespace vct::test
