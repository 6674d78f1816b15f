#include "engine/step_timer.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "gl/objects.h"
#include "platform/platform.h"

namespace vct::test {
namespace {

// Work that the driver may defer.
void drawMuch() {
    const gl::Texture target = gl::Texture::make2d("target", GL_RGBA8, 1024, 1024);
    const gl::Framebuffer framebuffer("target", {&target}, nullptr);
    framebuffer.bind();
    const float black[4] = {};
    for (int i = 0; i < 20; ++i)
        gl::ClearBufferfv(GL_COLOR, 0, black);
}

StepTimes timesOf(int gpuTimerBits, int frames) {
    StepTimer timer(gpuTimerBits);
    const auto frame = [&] {
        timer.beginFrame();
        timer.timeOnCpu(Step::voxelize, [] { std::this_thread::sleep_for(std::chrono::milliseconds(3)); });
        timer.time(Step::voxelize, drawMuch);
        timer.time(Step::trace, drawMuch);
        timer.endFrame();
    };
    frame();  // does not count
    timer.startRecording(Clocks::cpuAndGpu);
    for (int i = 0; i < frames; ++i)
        frame();
    return timer.stopRecording();
}

std::vector<double> samplesOf(const std::array<std::vector<double>, stepCount>& stepTime, Step step) {
    return stepTime[static_cast<std::size_t>(step)];
}

TEST(StepTimer, SumsTheTimesOfAStepInEachFrameByBothClocks) {
    const Context context = openContext(Backend::egl);
    const int bits = context.capabilities.gpuTimerBits;
    const StepTimes times = timesOf(bits, 4);
    ASSERT_EQ(samplesOf(times.stepMs, Step::voxelize).size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        const double voxelizeMs = samplesOf(times.stepMs, Step::voxelize).at(i);
        EXPECT_GT(voxelizeMs, 3.0);
        EXPECT_GT(samplesOf(times.stepMs, Step::trace).at(i), 0.0);
        EXPECT_EQ(samplesOf(times.stepMs, Step::mipmap).at(i), 0.0);
        if (bits == 0) continue;
        EXPECT_GT(samplesOf(times.gpuMs, Step::trace).at(i), 0.0);
        // The GPU's time leaves out the work of the CPU alone.
        EXPECT_LT(samplesOf(times.gpuMs, Step::voxelize).at(i), voxelizeMs - 2.5);
        EXPECT_EQ(samplesOf(times.gpuMs, Step::mipmap).at(i), 0.0);
    }
    const StepTimes withoutGpu = timesOf(0, 1);
    EXPECT_TRUE(withoutGpu.gpuMs[0].empty());
    EXPECT_NE(whyGpuTimesAreWrong(withoutGpu), "");
}

}  // namespace
}  // namespace vct::test
