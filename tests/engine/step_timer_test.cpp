#include "lab/step_timer.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "gl/objects.h"
#include "platform/platform.h"

namespace vct::test {
namespace {

// Work for the driver, which may do it when it likes.
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
    timer.startRecording();
    for (int i = 0; i < frames; ++i)
        frame();
    return timer.stopRecording();
}

TEST(StepTimer, AddsUpWhatAStepTakesInEachFrame) {
    const Context context = openContext(Backend::egl);
    const StepTimes times = timesOf(0, 4);
    const auto samples = [&](Step step) { return times.stepMs[static_cast<std::size_t>(step)]; };
    ASSERT_EQ(samples(Step::voxelize).size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_GT(samples(Step::voxelize)[i], 3.0);
        EXPECT_GT(samples(Step::trace)[i], 0.0);
        EXPECT_EQ(samples(Step::mipmap)[i], 0.0);
    }
    EXPECT_TRUE(times.gpuMs[0].empty());
    EXPECT_NE(whyGpuTimesAreWrong(times), "");
}

TEST(StepTimer, AsksTheGpusClockToo) {
    const Context context = openContext(Backend::egl);
    const int bits = context.capabilities.gpuTimerBits;
    if (bits == 0) GTEST_SKIP() << "the driver has no GL_EXT_disjoint_timer_query";
    const StepTimes times = timesOf(bits, 3);
    const auto voxelize = static_cast<std::size_t>(Step::voxelize),
               trace = static_cast<std::size_t>(Step::trace);
    ASSERT_EQ(times.gpuMs[trace].size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_GT(times.gpuMs[trace][i], 0.0);
        // What the CPU did alone is not in it.
        EXPECT_LT(times.gpuMs[voxelize][i], times.stepMs[voxelize][i] - 2.5);
        EXPECT_EQ(times.gpuMs[static_cast<std::size_t>(Step::mipmap)][i], 0.0);
    }
}

}  // namespace
}  // namespace vct::test
