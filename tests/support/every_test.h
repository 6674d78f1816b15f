// Tests that take long and show little more than shorter ones run in `scripts/test.sh --all`.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>

namespace vct::test {

inline bool runsEveryTest() {
    return std::getenv("VCT_TEST_ALL") != nullptr;
}

}  // namespace vct::test

// For the body of a test, as skipping leaves the function.
#define VCT_ONLY_AMONG_ALL()                                                                                 \
    do {                                                                                                     \
        if (!vct::test::runsEveryTest()) GTEST_SKIP() << "scripts/test.sh --all runs it, or VCT_TEST_ALL=1"; \
    } while (false)
