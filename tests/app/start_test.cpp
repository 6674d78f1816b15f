// The start of the app: the self-test and the first picture of a scene take many short frames.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "stand_in/stand_in.h"
#include "support/gl_spy.h"
#include "support/temporary_folder.h"

namespace vct::test {
namespace {

// Counts, for each frame, the programs that were linked and those that were used for the first time.
struct Frames {
    explicit Frames(const StandIn& android) : android_(android) {}

    int links = 0;
    int maxLinks() const { return largest(links_); }
    int maxFirstUses() const { return largest(firstUses_); }
    std::size_t programs() const { return used_.size(); }  // that were used

  private:
    static int largest(const std::map<int, int>& counts) {
        int found = 0;
        for (const auto& [frame, count] : counts)
            found = std::max(found, count);
        return found;
    }

    const StandIn& android_;
    std::map<int, int> links_, firstUses_;  // by frame
    std::set<GLuint> used_;
    const GlSpy<&gl::LinkProgram> linked_{[this](GLuint program) {
        ++links;
        ++links_[android_.shown];
        used_.erase(program);  // GL gives the names of deleted programs to new ones
    }};
    const GlSpy<&gl::UseProgram> isUsed_{[this](GLuint program) {
        if (used_.insert(program).second) ++firstUses_[android_.shown];
    }};
};

TEST(Start, NoFrameLinksOrFirstUsesTwoPrograms) {
    StandIn android;
    android.testsDriver = true;
    android.intentExtra = "show scene=night.glb grid=64 pixels=4";
    android.start(96, 64);
    std::unique_ptr<Frames> frames;
    android.frames(1);
    android.then([&] { frames = std::make_unique<Frames>(android); });
    android.framesUntilLogged("self-test passed");
    int linksOfTheTest = 0;
    android.then([&] {
        EXPECT_GT(frames->links, 30);
        EXPECT_LE(frames->maxLinks(), 1);
        EXPECT_LE(frames->maxFirstUses(), 2) << "the panel's program is one of them";
        linksOfTheTest = frames->links;
    });
    android.framesUntilLogged(" triangles");
    android.then([&] {
        EXPECT_LE(frames->maxLinks(), 1);
        EXPECT_GT(frames->links, linksOfTheTest);
        frames.reset();
    });
    android.run();
    EXPECT_EQ(android.errors(), "");
    EXPECT_EQ(android.misuse, std::vector<std::string>{});
}

TEST(Start, ABenchmarkUsesItsProgramsBeforeItMeasures) {
    const TemporaryFolder files;
    StandIn android;
    android.files = files.path();
    android.intentExtra = "bench scene=cornell.glb preset=mobile grid=64 size=40x40 repeat=1";
    android.start(96, 64);
    std::unique_ptr<Frames> frames;
    android.frames(1);
    android.then([&] { frames = std::make_unique<Frames>(android); });
    android.framesUntilLogged("bench: 1 of");
    std::size_t programs = 0;
    android.then([&] {
        EXPECT_LE(frames->maxFirstUses(), 2) << "one of them shows the frame";
        programs = frames->programs();
        EXPECT_GT(programs, 30U);
    });
    android.framesUntilLogged("measured: ");
    android.then([&] {
        EXPECT_EQ(frames->programs(), programs);
        frames.reset();
    });
    android.run();
    EXPECT_EQ(android.errors(), "");
    EXPECT_EQ(android.misuse, std::vector<std::string>{});
}

}  // namespace
}  // namespace vct::test
