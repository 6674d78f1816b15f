// The ways around faults that real phones have, seen in what the app's frames ask of GL.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>

#include "gl/call_log.h"
#include "stand_in/stand_in.h"

namespace vct::test {
namespace {

TEST(DriverFaultsOfTheApp, ElementsAreBoundAfterTheirVertexArrayAndNothingIsQueried) {
    StandIn android;
    android.intentExtra = "show grid=64 mode=phong pixels=4";
    android.startUntilSceneShown(400, 800);
    std::optional<gl::CallLog> log;
    std::vector<gl::Call> calls;
    android.then([&] { log.emplace(); });
    android.frames(2);
    android.then([&] {
        calls = log->calls();
        log.reset();
    });
    android.run();
    EXPECT_EQ(android.errors(), "");
    bool bound = false;
    int draws = 0, finishes = 0;
    for (const gl::Call& call : calls) {
        const std::string name = call.name;
        if (name == "BindVertexArray") bound = false;
        if (name == "BindBuffer" && call.arguments[0] == GL_ELEMENT_ARRAY_BUFFER) bound = true;
        // The display fills its elements by the binding, too.
        if (name == "DrawElements" ||
            (name == "BufferData" && call.arguments[0] == GL_ELEMENT_ARRAY_BUFFER)) {
            EXPECT_TRUE(bound) << name;
            ++draws;
        }
        finishes += name == "Finish";
        EXPECT_EQ(name.find("Query"), std::string::npos) << name;
    }
    EXPECT_GT(draws, 4);
    EXPECT_GT(finishes, 0) << "steps were timed";
}

}  // namespace
}  // namespace vct::test
