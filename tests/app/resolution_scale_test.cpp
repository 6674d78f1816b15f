// The resolution follows the time of frames, made-up ones and real ones.
#include "app/resolution_scale.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "app/choices.h"
#include "stand_in/stand_in.h"

namespace vct::app {
namespace {

// A device whose frames take a fixed time and a time for the pixels of the window.
struct MadeUpDevice {
    double fixedMs, windowMs;
    double noise = 0.0;  // a share, up and down
    std::mt19937 random{1};

    double frameMs(double divisor) {
        std::uniform_real_distribution<double> share(1.0 - noise, 1.0 + noise);
        return (fixedMs + windowMs / (divisor * divisor)) * share(random);
    }
    // Returns the number of changes of the size.
    int run(ResolutionScale& scale, int frames) {
        int changes = 0;
        for (int i = 0; i < frames; ++i) {
            const double before = scale.divisor();
            const bool told = scale.follow(frameMs(before));
            EXPECT_EQ(told, scale.divisor() != before);
            changes += told;
        }
        return changes;
    }
};

// Once the size has converged, frames that differ by a tenth do not change it, at any speed of the device.
TEST(ResolutionScale, DoesNotOscillate) {
    for (double windowMs = 4.0; windowMs < 400.0; windowMs *= 1.07) {
        ResolutionScale scale;
        MadeUpDevice device{2.0, windowMs, 0.1};
        device.run(scale, 400);
        EXPECT_EQ(device.run(scale, 2000), 0) << windowMs << " ms at the window's size";
        const double ms = device.fixedMs + windowMs / (scale.divisor() * scale.divisor());
        EXPECT_TRUE(ms < ResolutionScale::maxMs || scale.divisor() == ResolutionScale::maxDivisor) << ms;
    }
}

// To wait for the GPU costs time, and a scene that becomes slow must not stay so for long.
TEST(ResolutionScale, WantsFewTimesUntilFramesBecomeSlow) {
    ResolutionScale scale;
    const auto timesOf = [&](MadeUpDevice device, int frames) {
        int times = 0;
        for (int i = 0; i < frames; ++i)
            if (scale.wantsTime()) {
                ++times;
                scale.follow(device.frameMs(scale.divisor()));
            }
        return times;
    };
    timesOf({1.0, 10.0}, 200);
    ASSERT_EQ(scale.divisor(), 1.0);
    EXPECT_EQ(timesOf({1.0, 10.0}, 800), 100);
    timesOf({1.0, 20.0}, 24);
    EXPECT_GT(scale.divisor(), 1.0);
    EXPECT_GT(timesOf({1.0, 10.0}, 300), 30) << "frames of another size are timed again";
    EXPECT_EQ(scale.divisor(), 1.0);
}

TEST(ResolutionScale, OneSlowFrameInTwentyChangesNothing) {
    ResolutionScale scale;
    MadeUpDevice fast{1.0, 10.0};
    fast.run(scale, 120);
    ASSERT_EQ(scale.divisor(), 1.0);
    for (int i = 0; i < 200; ++i)
        EXPECT_FALSE(scale.follow(i % 20 == 0 ? 300.0 : 11.0));
}

// A phone whose case warms up with the pixels of its frames, by a time constant of 40 s, until the system
// lowers the GPU's clock. Returns the share of the last minutes in which it does.
double throttledShare(bool tellsHeadroom, double wattsAtWindow) {
    ResolutionScale scale;
    double headroom = 0.3, throttled = 0.0;
    constexpr int seconds = 900;
    for (int second = 0; second < seconds; ++second) {
        const double pixels = 1.0 / (scale.divisor() * scale.divisor());
        const double before = headroom;
        headroom += (0.3 + wattsAtWindow * pixels - headroom) / 40.0;
        const bool isThrottled = headroom > 0.9;
        if (second >= seconds / 2) throttled += isThrottled;
        for (int frame = 0; frame < 60; ++frame)
            scale.follow((isThrottled ? 2.0 : 1.0) * 10.0 * pixels);
        const double forecast = headroom + 10.0 * (headroom - before);
        if (tellsHeadroom && second % static_cast<int>(ResolutionScale::heatPeriodS) == 0)
            scale.followHeat(static_cast<float>(forecast));
    }
    return throttled / (seconds / 2.0);
}

TEST(ResolutionScale, FallsBeforeTheDeviceThrottles) {
    EXPECT_GT(throttledShare(false, 0.9), 0.3) << "the model has no need of it";
    for (double watts = 0.2; watts < 4.0; watts *= 1.3)
        EXPECT_EQ(throttledShare(true, watts), 0.0) << watts;
}

TEST(ResolutionScale, RisesAgainWhenTheDeviceHasCooled) {
    ResolutionScale scale;
    MadeUpDevice fast{1.0, 10.0};
    fast.run(scale, 200);
    ASSERT_EQ(scale.divisor(), 1.0);
    EXPECT_FALSE(scale.followHeat(0.75F)) << "warm, and not too hot";
    EXPECT_TRUE(scale.followHeat(0.85F));
    EXPECT_TRUE(scale.isLimitedByHeat());
    const double limited = scale.divisor();
    EXPECT_GT(limited, 1.0);
    EXPECT_EQ(fast.run(scale, 200), 0) << "fast frames do not raise it above what heat allows";
    EXPECT_FALSE(scale.followHeat(0.75F));
    EXPECT_EQ(fast.run(scale, 200), 0);
    scale.followHeat(0.6F);
    fast.run(scale, 200);
    EXPECT_EQ(scale.divisor(), 1.0);
    EXPECT_FALSE(scale.isLimitedByHeat());
    for (int i = 0; i < 20; ++i)
        scale.followHeat(1.2F);
    EXPECT_EQ(scale.divisor(), ResolutionScale::maxDivisor);
}

TEST(ResolutionScale, IsTheAppsChoiceUntilAnotherFixesTheSize) {
    EXPECT_TRUE(scaleFollowsTime(showRequestFromText("show").choices));
    const Choices choices = showRequestFromText("show pixels=auto").choices;
    EXPECT_TRUE(scaleFollowsTime(choices));
    EXPECT_EQ(settingsFor(choices, {100, 50}, 2.5).size, glm::ivec2(40, 20));
    for (const char* fixed : {"1", "2", "3", "4", "thesis"}) {
        const Choices other = showRequestFromText(std::string("show pixels=") + fixed).choices;
        EXPECT_FALSE(scaleFollowsTime(other)) << fixed;
        EXPECT_EQ(settingsFor(other, {100, 50}, 2.5).size, settingsFor(other, {100, 50}, 1.0).size) << fixed;
    }
    EXPECT_ANY_THROW(showRequestFromText("show pixels=5"));
}

}  // namespace
}  // namespace vct::app

namespace vct::test {
namespace {

// A small window leaves time for all of its pixels on any machine.
TEST(ResolutionInTheApp, RisesToTheWindowAndKeepsWhatTheSceneHas) {
    StandIn android;
    android.intentExtra = "show display=off steps=off grid=64 mode=ao preset=thesis";
    android.startUntilSceneShown(48, 32);
    android.then([&] { android.traceSections.clear(); });
    android.framesUntilLogged("pixels as the time allows: 48x32 of 48x32", 2000);
    android.frames(2);
    android.run();
    const auto& sections = android.traceSections;
    EXPECT_NE(std::find(sections.begin(), sections.end(), "shade"), sections.end());
    EXPECT_EQ(std::find(sections.begin(), sections.end(), "voxelize"), sections.end());
    EXPECT_EQ(android.errors(), "");
    EXPECT_EQ(android.misuse, std::vector<std::string>{});
}

TEST(ResolutionInTheApp, FallsOnAHotDevice) {
    StandIn android;
    android.intentExtra = "show display=off steps=off grid=64 mode=phong preset=mobile";
    android.headroom = 0.95F;
    android.startUntilSceneShown(96, 64);
    android.run();
    EXPECT_TRUE(android.logged("pixels as the heat allows: 24x16 of 96x64"));
    EXPECT_EQ(android.errors(), "");
}

// A display that refreshes more often does not make frames more frequent.
TEST(Pacing, IsSixtyFramesASecondOrAWholePartOfTheDisplays) {
    const auto shownInASecond = [](int hertz) {
        StandIn android;
        android.intentExtra = "show display=off steps=off grid=64 mode=phong pixels=4";
        android.refreshNs = 1'000'000'000 / hertz;
        android.startUntilSceneShown(32, 24);
        int before = 0;
        android.then([&] { before = android.shown; });
        android.frames(hertz);
        android.run();
        EXPECT_EQ(android.misuse, std::vector<std::string>{});
        return android.shown - before;
    };
    EXPECT_EQ(shownInASecond(60), 60);
    EXPECT_EQ(shownInASecond(120), 60);
    EXPECT_EQ(shownInASecond(90), 45);
    EXPECT_EQ(shownInASecond(30), 30);
}

}  // namespace
}  // namespace vct::test
