#include "scene/triangle_tree.h"

#include <gtest/gtest.h>

#include "support/scenes.h"

namespace vct::test {
namespace {

const glm::dvec3 eye{0.3, 0.2, 3.0}, ahead{0, 0, -2};

TEST(TriangleTree, FindsTheFirstSideThatIsVisible) {
    Scene scene = emptyScene();
    addQuad(scene, {-1, -1, 1}, {0, 2, 0}, {2, 0, 0});   // its back is seen
    addQuad(scene, {-1, -1, -1}, {2, 0, 0}, {0, 2, 0});  // its front is seen
    addQuad(scene, {-1, -1, -2}, {2, 0, 0}, {0, 2, 0});
    const TriangleTree tree(finished(std::move(scene)));
    const FirstSurface found = tree.first(eye, ahead);
    EXPECT_NEAR(found.distance, 2.0, 1e-6);
    EXPECT_NEAR(found.backDistance, 1.0, 1e-6);
    EXPECT_EQ(found.instance, 1);
    EXPECT_NEAR(found.normal.z, 1.0, 1e-6);
    EXPECT_EQ(tree.first(eye, ahead, 1.9).distance, 0.0);
    EXPECT_EQ(tree.first(eye, -ahead).distance, 0.0);
}

TEST(TriangleTree, OfSurfacesThatCoincideTheLargerOneCounts) {
    for (const bool isLargeFirst : {false, true}) {
        Scene scene = emptyScene();
        for (const double side : {isLargeFirst ? 4.0 : 2.0, isLargeFirst ? 2.0 : 4.0})
            addQuad(scene, {-0.5 * side, -0.5 * side, 0}, {side, 0, 0}, {0, side, 0});
        const FirstSurface found = TriangleTree(finished(std::move(scene))).first(eye, ahead);
        EXPECT_NEAR(found.distance, 1.5, 1e-6);
        EXPECT_EQ(found.instance, isLargeFirst ? 0 : 1);
    }
}

}  // namespace
}  // namespace vct::test
