// The app's life, step by step.
#include <gtest/gtest.h>

#include "stand_in/stand_in.h"

namespace vct::test {
namespace {

void expectClean(const StandIn& android) {
    EXPECT_EQ(android.errors(), "");
    EXPECT_EQ(android.misuse, std::vector<std::string>{});
}

TEST(Lifecycle, StartsShowsASceneAndEnds) {
    StandIn android;
    android.startUntilSceneShown(96, 64);
    android.run();
    EXPECT_GT(android.shown, 2);
    EXPECT_EQ(android.contextsMade, 1);
    expectClean(android);
}

}  // namespace
}  // namespace vct::test
