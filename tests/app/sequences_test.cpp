// Random legal lives of the app: nothing leaks, no GL error happens and no dead window is used.
// VCT_SEQUENCE_SEED runs one of them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "stand_in/stand_in.h"
#include "support/every_test.h"
#include "support/gltf_builder.h"
#include "support/temporary_folder.h"

namespace vct::test {
namespace {

constexpr int shards = 4;
const int perShard = runsEveryTest() ? 100 : 40;

// The events follow Android's rules, such as start before resume, and touches only with a window.
class RandomLife {
  public:
    RandomLife(StandIn& android, unsigned seed) : android_(android), random_(seed) {
        android_.command(APP_CMD_START);
        const int events = 4 + pick(14);
        for (int i = 0; i < events; ++i)
            event();
    }

  private:
    int pick(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }

    void event() {
        switch (pick(16)) {
            case 0:
            case 1:
                android_.command(resumed_ ? APP_CMD_PAUSE : APP_CMD_RESUME);
                resumed_ = !resumed_;
                break;
            case 2:
            case 3:
            case 4:
                if (window_)
                    android_.loseWindow();
                else
                    android_.window(8 + pick(24), 8 + pick(24));
                window_ = !window_;
                break;
            case 5:
                if (window_) android_.resize(8 + pick(24), 8 + pick(24));
                break;
            case 6:
                android_.command(pick(2) == 0 ? APP_CMD_GAINED_FOCUS : APP_CMD_LOST_FOCUS);
                break;
            case 7:
                android_.command(APP_CMD_LOW_MEMORY);
                break;
            case 8:
                android_.command(APP_CMD_SAVE_STATE);
                break;
            case 9:
                if (window_) android_.command(APP_CMD_WINDOW_REDRAW_NEEDED);
                break;
            case 10:
                android_.then([this, n = 1 + pick(60)] { android_.loseContextAtGlError(n); });
                break;
            case 11:
                android_.then([this, n = 1 + pick(2)] { android_.loseContextAtSwap(n); });
                break;
            case 12:
            case 13:
                if (window_) fingers();
                break;
            default:
                // The self-test takes about a hundred frames, and the scene comes after it.
                android_.frames(pick(4) == 0 ? 150 : 1 + pick(3));
                break;
        }
    }

    void fingers() {
        const auto point = [this](int id) {
            return AInputEvent::Pointer{id, static_cast<float>(pick(32)), static_cast<float>(pick(32))};
        };
        android_.touch(AMOTION_EVENT_ACTION_HOVER_MOVE, {point(0)});
        android_.touch(AMOTION_EVENT_ACTION_DOWN, {point(0)});
        if (pick(2) == 0) {
            const int second = 1 << AMOTION_EVENT_ACTION_POINTER_INDEX_SHIFT;
            android_.touch(AMOTION_EVENT_ACTION_POINTER_DOWN | second, {point(0), point(1)});
            android_.touch(AMOTION_EVENT_ACTION_MOVE, {point(0), point(1)});
            android_.touch(AMOTION_EVENT_ACTION_POINTER_UP | second, {point(0), point(1)});
        }
        android_.touch(AMOTION_EVENT_ACTION_MOVE, {point(0)});
        if (pick(2) == 0) android_.frames(1);
        android_.touch(pick(5) == 0 ? AMOTION_EVENT_ACTION_CANCEL : AMOTION_EVENT_ACTION_UP, {point(0)});
    }

    StandIn& android_;
    std::mt19937 random_;
    bool resumed_ = false, window_ = false;
};

void runLife(unsigned seed, const std::string& scenes) {
    StandIn android;
    android.scenes = scenes;
    android.testsDriver = seed % 4 == 0;
    android.intentExtra = "show grid=64 mode=ao";
    RandomLife life(android, seed);
    android.run();
    const std::string who = "VCT_SEQUENCE_SEED=" + std::to_string(seed);
    EXPECT_EQ(android.errors(), "") << who;
    EXPECT_EQ(android.misuse, std::vector<std::string>{}) << who;
    EXPECT_TRUE(android.logged("the app ends")) << who;
}

class Sequences : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Shards, Sequences, testing::Range(0, shards));

TEST_P(Sequences, LeaveNothingBehind) {
    const TemporaryFolder scenes;
    GltfBuilder builder;
    builder.triangle();
    writeBytes(scenes.file("tiny.glb"), builder.glb());
    const char* seed = std::getenv("VCT_SEQUENCE_SEED");
    if (seed != nullptr) return runLife(static_cast<unsigned>(std::atoi(seed)), scenes.path());
    for (int i = 0; i < perShard && !HasFailure(); ++i)
        runLife(static_cast<unsigned>(GetParam() * perShard + i), scenes.path());
}

}  // namespace
}  // namespace vct::test
