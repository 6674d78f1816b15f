#include "gl/call_log.h"

#include <gtest/gtest.h>

#include "gl/debug.h"
#include "gl/objects.h"
#include "platform/platform.h"

namespace vct::test {
namespace {

TEST(CallLog, HasEveryCallWithItsArgumentsUntilItEnds) {
    const Context context = openContext(Backend::egl);
    const auto driversOwn = gl::Enable;
    std::vector<gl::Call> calls;
    {
        gl::CallLog log;
        gl::Enable(GL_BLEND);
        EXPECT_EQ(gl::GetError(), static_cast<GLenum>(GL_NO_ERROR));
        calls = log.calls();
    }
    gl::Disable(GL_BLEND);
    EXPECT_EQ(gl::Enable, driversOwn);
    ASSERT_EQ(calls.size(), 2U);
    EXPECT_STREQ(calls[0].name, "Enable");
    EXPECT_EQ(calls[0].arguments, std::vector<std::int64_t>{GL_BLEND});
    EXPECT_STREQ(calls[1].name, "GetError");
}

TEST(CallLog, SummaryCountsByNameAndGroupAndNamesBindings) {
    const Context context = openContext(Backend::egl);
    const gl::Texture texture = gl::Texture::make2d("t", GL_RGBA8, 4, 4);
    const gl::Buffer buffer("b", GL_UNIFORM_BUFFER, 512, nullptr, GL_STATIC_DRAW);
    gl::CallLog log;
    {
        const gl::DebugGroup outer("outer");
        gl::Enable(GL_BLEND);
        const gl::DebugGroup inner("inner");
        gl::Disable(GL_BLEND);
        texture.bind(5);
    }
    gl::BindBufferRange(GL_UNIFORM_BUFFER, 2, buffer.name(), 0, 256);
    const gl::CallSummary summary = gl::summarize(log.calls());
    EXPECT_EQ(summary.calls, 5);
    EXPECT_EQ(summary.byGroup,
              (std::vector<std::pair<std::string, int>>{{"outer", 1}, {"inner", 3}, {"", 1}}));
    EXPECT_EQ(summary.passes, std::set<std::string>{"outer"});
    EXPECT_EQ(summary.byName.at("BindTexture"), 1);
    EXPECT_EQ(summary.bindings, (std::set<std::string>{"texture 5: 2D", "uniform buffer 2: 256 bytes"}));
    EXPECT_EQ(summary.draws + summary.dispatches, 0);
}

TEST(CallLog, SummaryKnowsWhatIsDrawnWithAndEveryKindOfBinding) {
    const gl::CallSummary summary = gl::summarize({{"UseProgram", {7}, ""},
                                                   {"DrawElementsBaseVertex", {4}, ""},
                                                   {"DrawArrays", {4}, ""},
                                                   {"UseProgram", {8}, ""},
                                                   {"UseProgram", {9}, ""},
                                                   {"DispatchComputeIndirect", {0}, ""},
                                                   {"ActiveTexture", {GL_TEXTURE3}, ""},
                                                   {"BindTexture", {GL_TEXTURE_3D, 1}, ""},
                                                   {"BindSampler", {6, 1}, ""},
                                                   {"BindImageTexture", {2, 1, 4}, ""},
                                                   {"BindBufferBase", {GL_SHADER_STORAGE_BUFFER, 5, 1}, ""},
                                                   {"Uniform1ui", {1, 0}, ""}});
    EXPECT_EQ(summary.calls, 12);
    EXPECT_EQ(summary.draws, 2);
    EXPECT_EQ(summary.dispatches, 1);
    EXPECT_EQ(summary.programs, (std::set<std::int64_t>{7, 9})) << "8 drew nothing";
    EXPECT_EQ(summary.bindings, (std::set<std::string>{"texture 3: 3D", "sampler 6", "image 2, level 4",
                                                       "storage buffer 5", "uniform 1"}));
}

}  // namespace
}  // namespace vct::test
