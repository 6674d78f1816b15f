// Workarounds for faults of real phones, observed in frames of the app.
#include <gtest/gtest.h>

#include <memory>

#include "stand_in/stand_in.h"
#include "support/element_buffers.h"

namespace vct::test {
namespace {

TEST(DriverFaultsOfTheApp, ElementsAreBoundAfterTheirVertexArrayAndNothingIsQueried) {
    StandIn android;
    android.intentExtra = "show grid=64 mode=phong pixels=4";
    android.startUntilSceneShown(400, 800);
    struct Spies {
        int finishes = 0;
        ElementBufferCheck elements;
        const GlSpy<&gl::Finish> finished{[this] { ++finishes; }};
        const GlSpy<&gl::BeginQuery> queried{[](GLenum, GLuint) { ADD_FAILURE() << "a query"; }};
    };
    std::unique_ptr<Spies> spies;
    android.then([&] { spies = std::make_unique<Spies>(); });
    android.frames(2);
    android.then([&] {
        EXPECT_GT(spies->elements.uses, 4);
        EXPECT_GT(spies->finishes, 0) << "steps were not timed";
        spies.reset();
    });
    android.run();
    EXPECT_EQ(android.errors(), "");
}

}  // namespace
}  // namespace vct::test
