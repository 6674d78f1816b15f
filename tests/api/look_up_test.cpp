// The look-up of irradiance (lookUpGlsl(), bindLookUp()), against path tracing: references/points/ holds
// points of rooms with their irradiance (tools/evaluation/points.py).
#include <cmath>
#include <ctime>
#include <iostream>
#include <limits>
#include <random>
#include <set>

#include "api/gl_state.h"
#include "api/looked_up.h"
#include "engine/volume.h"
#include "image/environment_file.h"
#include "support/errors.h"
#include "support/every_test.h"

namespace vct::test {
namespace {

struct Room {
    const char* name;
    const char* preset;
    int cascades = 1;
};
void PrintTo(const Room& room, std::ostream* stream) {
    *stream << room.name << ", " << room.preset << ", " << room.cascades << " cascades";
}

class LookUp : public ::testing::TestWithParam<Room> {
  protected:
    std::unique_ptr<Platform> context_ = createContext(Backend::egl, false);
};

TEST_P(LookUp, AgreesWithPathTracing) {
    const std::string name = GetParam().name;
    // An open and a closed room are enough in most runs.
    if (name != "patio" && (name != "corridor" || GetParam().cascades > 1)) VCT_ONLY_AMONG_ALL();
    DescribedScene room(loadGltf(asset(name + ".glb")));
    Image sky;
    if (name == "patio") {
        sky = readEnvironment(asset("patio.hdr"));
        room.scene.sky = SkyPicture{sky.width, sky.height, {&sky.pixels[0].x, 3 * sky.pixels.size()}};
    }
    const Image points = readImage(VCT_SOURCE_DIR "/references/points/" + name + ".exr");
    Options options = optionsOf(GetParam().preset);
    options.grid = 0;
    if (GetParam().cascades > 1) {
        const double coarsest = volumeAround(room.loaded.boundsWorld, 64).voxelSize();
        options.voxelSize = static_cast<float>(std::ldexp(1.01 * coarsest, 1 - GetParam().cascades));
    }
    GlobalIllumination light(getProcAddress, room.scene, options);
    light.render(room.view(), GlobalIllumination::Light::converged);
    const std::vector<glm::vec3> found = lookedUp(light, points);
    const auto unit = static_cast<float>(light.radianceUnit());
    // The first half of the points lies on surfaces, the second in the air.
    for (const int first : {0, points.height / 2}) {
        double squares = 0.0, sum = 0.0, expectedSum = 0.0;
        for (int i = first; i < first + points.height / 2; ++i)
            for (int c = 0; c < 3; ++c) {
                const double value = unit * found[static_cast<std::size_t>(i)][c],
                             expected = points.at(2, i)[c];
                squares += (value - expected) * (value - expected) / (expected * expected + 0.01);
                sum += value;
                expectedSum += expected;
            }
        const double relMse = 2.0 * squares / (3.0 * points.height);
        const char* place = first == 0 ? "on surfaces" : "in the air";
        std::cout << place << ": relMSE " << relMse << ", bias " << 100 * (sum / expectedSum - 1) << " %\n";
        EXPECT_LE(relMse, first == 0 ? 0.02 : 0.07) << place;
    }
}

TEST_F(Embedded, LookUpTakesTheBindingsOfTheProgramAndNoOthers) {
    const std::vector<float> sky(6, 0.3F);
    described_.scene.skyRadiance = {0, 0, 0};
    described_.scene.sky = SkyPicture{2, 1, sky};
    GlobalIllumination light(getProcAddress, described_.scene, optionsOf("mobile"));
    expectMentions(errorOf([&] { light.bindLookUp(); }), {"has no light yet"});
    light.render(described_.view());
    const GlState before = readGlState();
    light.bindLookUp({5, 4, 2});
    std::set<std::string> changed, expected;
    for (const auto& [name, values] : readGlState())
        if (values != before.at(name)) changed.insert(name);
    for (int i = 0; i < 8; ++i)
        expected.insert("textures and sampler of unit " + std::to_string(5 + i));
    for (int i = 0; i < 2; ++i)
        expected.insert("uniform buffer " + std::to_string(4 + i));
    expected.insert("storage buffer 2");
    EXPECT_EQ(changed, expected);
    EXPECT_EQ(gl::GetError(), GLenum{GL_NO_ERROR});

    GlobalIllumination thesis(getProcAddress, described_.scene, optionsOf("thesis"));
    expectMentions(errorOf([&] { thesis.lookUpGlsl(); }), {"preset thesis has no look-up"});
}

// From so far away a float cannot tell voxels apart, and a ray that began there would never leave a voxel. A
// phone ends programs whose shaders take seconds. llvmpipe ends a loop after 65536 steps.
TEST_F(Embedded, RaysFromAnywhereEnd) {
    GlobalIllumination light(getProcAddress, described_.scene, optionsOf("mobile"));
    light.render(described_.view());
    // The processor's time for rays from points at a distance, in voxels, towards points among the voxels.
    const auto secondsFrom = [&](float distance) {
        std::mt19937 random(1);
        std::uniform_real_distribution<float> place(4, 60), turn(-1, 1);
        Image rays(2, 2048);
        for (int i = 0; i < rays.height; ++i) {
            const glm::vec3 target(place(random), place(random), place(random));
            rays.at(1, i) = glm::normalize(glm::vec3(turn(random), turn(random), turn(random)));
            rays.at(0, i) = target - distance * rays.at(1, i);
        }
        const std::clock_t start = std::clock();
        lookedUp(
            light, rays,
            "vec3(vct_traceRay(points[i].xyz, 0, points[i + 1u].xyz, 1e9, 0.5, vct_allGeometry).distance)");
        return double(std::clock() - start) / CLOCKS_PER_SEC;
    };
    secondsFrom(1);  // compiles the program
    for (const float distance : {1e2F, 1e4F, 1e5F, 1e9F, std::numeric_limits<float>::quiet_NaN()})
        EXPECT_LT(secondsFrom(distance), 2.0) << distance;
}

// A pixel without faces around it costs little more than others. Up to eight of the places have three faces.
TEST_F(Embedded, TheLookUpTriesSixteenPlacesAtMost) {
    GlobalIllumination light(getProcAddress, described_.scene, optionsOf("mobile"));
    light.render(described_.view());
    Image points(2, 4096);
    std::mt19937 random(1);
    std::uniform_real_distribution<float> place(-0.1F, 1.1F), turn(-1, 1);
    for (int i = 0; i < points.height; ++i) {
        points.at(0, i) = {place(random), place(random), place(random)};
        points.at(1, i) = glm::normalize(glm::vec3(turn(random), turn(random), turn(random)));
    }
    const std::vector<glm::vec3> fetches =
        lookedUp(light, points,
                 "(vct_irradianceInCascade(points[i].xyz, points[i + 1u].xyz, 0), vec3(float(fetches)))",
                 "int fetches = 0;\n#define textureLod(map, place, level) (++fetches, textureLod(map, place, "
                 "level))\n");
    float most = 0.0F;
    for (const glm::vec3& each : fetches)
        most = std::max(most, each.x);
    EXPECT_EQ(most, 3.0F + 8.0F + 7.0F * 3.0F);
}

INSTANTIATE_TEST_SUITE_P(Rooms, LookUp,
                         ::testing::Values(Room{"cornell", "mobile"}, Room{"corridor", "mobile"},
                                           Room{"lamp", "mobile"}, Room{"night", "mobile"},
                                           Room{"patio", "mobile"}, Room{"corridor", "mobile", 3}),
                         [](const auto& room) {
                             return std::string(room.param.name) + "_" + room.param.preset +
                                    (room.param.cascades > 1 ? "_in_cascades" : "");
                         });

}  // namespace
}  // namespace vct::test
