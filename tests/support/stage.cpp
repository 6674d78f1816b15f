#include "support/stage.h"

#include "support/grids.h"

namespace vct::test {

void Stage::frameAt(double seconds, Mode mode) {
    const Pose pose = poseAt(scene_.animation, seconds);
    renderer_.setPose(pose);
    renderer_.setLightDirection(posed(chooseLight(scene_), pose).towardsLight);
    renderer_.frame(mode, posed(chooseCamera(scene_, ""), pose));
}

std::size_t Stage::bytes() const {
    std::size_t sum = 0;
    for (const Renderer::Resource& resource : renderer_.resources())
        sum += resource.bytes;
    return sum;
}

void expectFresh(Stage& stage, const Context& context, const Scene& scene, const Settings& settings,
                 double seconds, Mode mode) {
    const std::string what = std::to_string(seconds) + " s, " + modeName(mode);
    stage.frameAt(seconds, mode);
    const Scene frozen = frozenAt(scene, seconds);
    Stage fresh(context, frozen, settings);
    fresh.frame(mode);
    expectSameGrid(gridOf(stage.renderer()), gridOf(fresh.renderer()), what);
    expectSamePicture(stage.renderer().radiance(), fresh.renderer().radiance(), what);
}

}  // namespace vct::test
