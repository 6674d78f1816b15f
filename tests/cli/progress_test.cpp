#include "cli/progress.h"

#include <gtest/gtest.h>

#include <chrono>
#include <string>

namespace vct::test {
namespace {

// And no longer than what is done: waiting for the next two seconds would say so.
TEST(Progress, IsSaidAtOnceAndAgainAfterTwoSeconds) {
    testing::internal::CaptureStderr();
    {
        const cli::Progress progress("stages");
        std::this_thread::sleep_for(std::chrono::milliseconds(2500));
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "stages\nstages: 2 s so far\n");
}

}  // namespace
}  // namespace vct::test
