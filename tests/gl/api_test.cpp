#include "gl/api.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "support/errors.h"

namespace vct::gl {
namespace {

void stub() {}

TEST(Load, NamesEveryMissingEntryPointAtOnce) {
    const auto lacking = [](const char* name, const void*) -> Proc {
        const bool missing =
            !std::strcmp(name, "glDispatchCompute") || !std::strcmp(name, "glBindImageTexture");
        return missing ? nullptr : stub;
    };
    const std::string text = test::errorOf([&] { load(lacking, nullptr); });
    test::expectMentions(text, {"glDispatchCompute", "glBindImageTexture"});
    EXPECT_EQ(text.find("glViewport"), std::string::npos) << text;
}

}  // namespace
}  // namespace vct::gl
