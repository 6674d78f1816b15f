#include "core/number_text.h"

#include <gtest/gtest.h>

namespace vct::test {
namespace {

TEST(NumberText, IsAsPeopleWriteIt) {
    EXPECT_EQ(numberText(2.0), "2");
    EXPECT_EQ(numberText(0.25F), "0.25");
    EXPECT_EQ(numberText(-0.1F), "-0.1");
    EXPECT_EQ(numberText(1e-7), "1e-07");
}

}  // namespace
}  // namespace vct::test
