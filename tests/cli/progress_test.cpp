#include "cli/progress.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>

namespace vct::test {
namespace {

TEST(Progress, IsSaidAtOnceAndAgainAfterTwoSeconds) {
    testing::internal::CaptureStderr();
    {
        const cli::Progress progress("stages");
        std::this_thread::sleep_for(std::chrono::milliseconds(2500));
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "stages\nstages: 2 s so far\n");
}

TEST(Progress, DoesNotHoldUpWhatIsDone) {
    const auto start = std::chrono::steady_clock::now();
    { const cli::Progress progress("stages"); }
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

}  // namespace
}  // namespace vct::test
