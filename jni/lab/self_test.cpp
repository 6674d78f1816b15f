#include "lab/self_test.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/renderer.h"
#include "engine/voxelization.h"
#include "gl/debug.h"
#include "gl/read_back.h"
#include "lab/cpu_mips.h"
#include "lab/driver_checks.h"
#include "scene/framing.h"
#include "scene/gltf.h"

namespace vct {

namespace {

constexpr int testGrid = 64, testLevels = 7;

// A rectangle that faces along one axis, with a material of its own.
struct Sheet {
    int axis;              // axis of the normal
    double at;             // position along the axis
    glm::dvec2 low, high;  // corners along the next two axes, in cyclic order
    glm::vec3 albedo;
};

// World coordinates are voxel coordinates, because the bounds make the volume [0, 64]^3. Every sheet lies in
// the middle of its voxels and ends on their faces, and no colour is near a rounding limit of its eight bits,
// so that the result does not depend on a driver's last digit. No sheet shadows another. The last eight
// overlap in the same plane: there the largest packed voxel must win, in whatever order they are drawn.
const std::vector<Sheet>& sheets() {
    static const std::vector<Sheet> all = [] {
        std::vector<Sheet> result{
            {0, 2.5, {20, 20}, {44, 44}, {0.9F, 0.5F, 0.1F}},
            {0, 61.5, {20, 20}, {44, 44}, {0.25F, 0.4F, 0.8F}},
            {1, 12.5, {30, 10}, {52, 30}, {0.3F, 0.7F, 0.6F}},
            {2, 10.5, {12, 30}, {31, 50}, {0.6F, 0.6F, 0.6F}},
            {2, 53.5, {44, 14}, {60, 28}, {0.2F, 0.9F, 0.45F}},
        };
        for (int i = 0; i < 8; ++i)
            result.push_back({1,
                              51.5,
                              {27 - i, 32},
                              {33 + i, 38 + i},
                              glm::vec3(0.1F * static_cast<float>(i * 3 % 8 + 1))});
        return result;
    }();
    return all;
}

DirectionalLight light() {
    DirectionalLight result;
    result.directionToLight = glm::normalize(glm::dvec3(2.0, 3.0, 1.0));
    return result;
}

Scene testScene() {
    Scene scene;
    scene.path = "self-test";
    for (const Sheet& sheet : sheets()) {
        Material material;
        material.baseColor = glm::vec4(sheet.albedo, 1.0F);
        const int u = (sheet.axis + 1) % 3;
        const int v = (sheet.axis + 2) % 3;
        Mesh mesh;
        mesh.material = static_cast<int>(scene.materials.size());
        for (const glm::dvec2 corner : {sheet.low, glm::dvec2(sheet.high.x, sheet.low.y), sheet.high,
                                        glm::dvec2(sheet.low.x, sheet.high.y)}) {
            Vertex vertex{};
            vertex.position[sheet.axis] = static_cast<float>(sheet.at);
            vertex.position[u] = static_cast<float>(corner.x);
            vertex.position[v] = static_cast<float>(corner.y);
            vertex.normal[sheet.axis] = 1.0F;
            mesh.vertices.push_back(vertex);
        }
        mesh.indices = {0, 1, 2, 0, 2, 3};
        scene.materials.push_back(material);
        scene.instances.push_back({static_cast<int>(scene.meshes.size()), glm::dmat4(1.0)});
        scene.meshes.push_back(std::move(mesh));
    }
    computeBounds(scene);
    return scene;
}

// Computes the packed voxels of all sheets by eq. 4.4 of the thesis. If several sheets share a voxel, the
// largest word wins.
Words expectedBase() {
    Words words(static_cast<std::size_t>(testGrid) * testGrid * testGrid, 0U);
    for (const Sheet& sheet : sheets()) {
        const auto cosTheta = static_cast<float>(light().directionToLight[sheet.axis]);
        const glm::uvec3 color(
            cosTheta * sheet.albedo * static_cast<float>(VCT_BASE_COUNT * VCT_COLOR_STEPS) + 0.5F);
        const std::uint32_t word = shared::packVoxel(VCT_BASE_COUNT, VCT_BASE_COUNT, color);
        glm::ivec3 voxel;
        voxel[sheet.axis] = static_cast<int>(sheet.at);
        int& u = voxel[(sheet.axis + 1) % 3];
        int& v = voxel[(sheet.axis + 2) % 3];
        for (u = static_cast<int>(sheet.low.x); u < static_cast<int>(sheet.high.x); ++u)
            for (v = static_cast<int>(sheet.low.y); v < static_cast<int>(sheet.high.y); ++v) {
                std::uint32_t& known = words[(voxel.z * testGrid + voxel.y) * testGrid + voxel.x];
                known = std::max(known, word);
            }
    }
    return words;
}

std::string placeOf(std::size_t index, int side) {
    const auto n = static_cast<std::size_t>(side);
    return "(" + std::to_string(index % n) + ", " + std::to_string(index / n % n) + ", " +
           std::to_string(index / (n * n)) + ")";
}

std::string compare(const Words& found, const Words& expected, int level) {
    std::size_t wrong = 0, first = 0;
    for (std::size_t i = 0; i < expected.size(); ++i)
        if (found[i] != expected[i] && wrong++ == 0) first = i;
    if (wrong == 0) return "";
    char words[64];
    std::snprintf(words, sizeof words, "0x%08X, expected 0x%08X", found[first], expected[first]);
    return "level " + std::to_string(level) + ": " + std::to_string(wrong) +
           " voxels are wrong, the first at " + placeOf(first, testGrid >> level) + " is " + words;
}

// Compares voxels, mip levels and lists with the CPU's. Returns an error text, or "" if all are right.
std::string wrongVoxels(Renderer& renderer, Words expected, std::size_t& voxels) {
    const VoxelPyramid& pyramid = renderer.packed()->occupancy();
    const std::vector<std::uint32_t> counts = renderer.activeVoxels();
    for (int level = 0; level < pyramid.levels(); ++level) {
        const int side = testGrid >> level;
        if (level > 0) expected = mipOnCpu(expected, 2 * side);
        if (const std::string wrong = compare(readVoxels(pyramid.texture(), level), expected, level);
            !wrong.empty())
            return wrong;
        const std::vector<std::uint32_t> entries = entriesOnCpu(expected, side);
        const std::uint32_t count = counts[level];
        std::vector<std::uint32_t> listed = readEntries(pyramid, level, count);
        std::sort(listed.begin(), listed.end());
        if (listed != entries)
            return "level " + std::to_string(level) + ": the list has " + std::to_string(count) +
                   " entries, which differ from the " + std::to_string(entries.size()) + " occupied voxels";
        voxels += entries.size();
    }
    return "";
}

Settings testSettings(const std::string& preset) {
    Settings settings = presetSettings(preset);
    settings.grid = testGrid;
    settings.size = glm::ivec2(8);
    settings.shadowMapSize = 512;
    settings.revoxelize = true;
    return settings;
}

// Checks the number of faces: every voxel has one, because the sheets are single-sided.
std::string wrongFaces(const Renderer& renderer, const Words& expected) {
    const auto voxels = static_cast<std::uint32_t>(entriesOnCpu(expected, testGrid).size());
    const std::uint32_t found = renderer.activeVoxels().at(0);
    const std::size_t faces = renderer.directional()->voxels().readBaseFaces().size();
    if (found == voxels && faces == voxels) return "";
    return std::to_string(found) + " voxels with " + std::to_string(faces) + " faces, expected " +
           std::to_string(voxels) + " of each";
}

// Checks that the picture has light and only finite values.
std::string wrongLight(const Renderer& renderer) {
    float sum = 0.0F;
    for (const glm::vec3& pixel : renderer.radiance().pixels)
        sum += pixel.r + pixel.g + pixel.b;
    if (std::isfinite(sum) && sum > 0.0F) return "";
    return std::isfinite(sum) ? "the picture is black" : "the picture has pixels that are no numbers";
}

// Tests one preset. Returns an error text or "". Throws vct::Error if the preset cannot run at all.
std::string wrongIn(const std::string& preset, const gl::Capabilities& capabilities,
                    const gl::ReadShader& shaders, const std::shared_ptr<gl::ProgramCache>& programs,
                    std::size_t& voxels) {
    const Scene scene = testScene();
    const Settings settings = testSettings(preset);
    Renderer renderer(scene, light(), settings, capabilities, shaders, programs);
    const Camera camera = frameScene(scene, 1.0);
    const bool packed = settings.voxels == Voxels::packed;
    // The second frame begins with the voxels of the first one and must clear them.
    for (const char* frame : {"first frame, ", "second frame, "}) {
        if (packed) voxels = 0;
        renderer.render({{packed ? Output::ao : Output::giConeShadow}, camera});
        const std::string wrong =
            packed ? wrongVoxels(renderer, expectedBase(), voxels) : wrongFaces(renderer, expectedBase());
        if (!wrong.empty()) return frame + wrong;
    }
    return packed ? "" : wrongLight(renderer);
}

Settings cascadedSettings() {
    Settings settings = testSettings("mobile");
    settings.cascades = 2;
    return settings;
}

// Tests nested cubes of voxels, which large scenes have. Returns an error text or "".
std::string wrongWithCascades(const gl::Capabilities& capabilities, const gl::ReadShader& shaders,
                              const std::shared_ptr<gl::ProgramCache>& programs) {
    const Scene scene = testScene();
    Renderer renderer(scene, light(), cascadedSettings(), capabilities, shaders, programs);
    Camera camera = frameScene(scene, 1.0);
    // The second frame moves the cubes, and keeps the voxels that are in both places.
    for (const char* frame : {"first frame, ", "second frame, "}) {
        renderer.render({{Output::giConeShadow}, camera});
        const std::string wrong =
            renderer.activeVoxels().at(0) == 0 ? "there are no voxels" : wrongLight(renderer);
        if (!wrong.empty()) return frame + wrong;
        camera.worldFromCamera[3].x += 8.0;
    }
    return "";
}

// Advice for the case that a preset is wrong.
std::string remedyFor(const std::string& preset) {
    return preset == "thesis" ? "; use a newer driver, or the preset mobile" : "; use the preset thesis";
}

}  // namespace

SelfTest::SelfTest(const gl::Capabilities& capabilities, const gl::ReadShader& shaders,
                   std::shared_ptr<gl::ProgramCache> programs)
    : programs_(std::move(programs)) {
    const gl::ShaderLibrary library{shaders, capabilities.language(), {}, programs_};
    for (const DriverCheck& check : driverChecks(pixelSamplesFor(capabilities)))
        checks_.push_back({"driver", [check, library] { return check.run(library); },
                           check.isNeededByThesis
                               ? ". All presets need it; use a newer driver"
                               : ". The presets mobile and quality need it; use the preset thesis"});
    const auto meets = [&](const Settings& settings) {
        const std::vector<gl::Requirement> needs = needsOf(settings, capabilities);
        return std::all_of(needs.begin(), needs.end(), [](const auto& need) { return need.met; });
    };
    for (const std::string& preset : presetNames()) {
        if (meets(testSettings(preset)))
            checks_.push_back({"preset " + preset,
                               [this, preset, capabilities, shaders] {
                                   return wrongIn(preset, capabilities, shaders, programs_, packedVoxels_);
                               },
                               remedyFor(preset)});
        else
            notTested_ += "; " + preset + " was not tested, because the driver lacks something that it needs";
    }
    if (meets(cascadedSettings()))
        checks_.push_back(
            {"preset mobile with cascades",
             [this, capabilities, shaders] { return wrongWithCascades(capabilities, shaders, programs_); },
             remedyFor("mobile")});
}

bool SelfTest::advance() {
    const Check& check = checks_[check_];
    std::string wrong;
    try {
        if (!programs_->runLimited([&] { wrong = check.run(); })) {
            ++newPrograms_;
            return true;
        }
        ++check_;
        if (!wrong.empty())
            result_ = SelfTestResult{false, check.place + ": " + wrong + check.remedy};
        else if (check_ == checks_.size())
            result_ = SelfTestResult{
                true, std::to_string(packedVoxels_) + " voxels of " + std::to_string(testLevels) +
                          " levels and their lists equal the CPU's; all presets run, and the driver meets "
                          "their assumptions" +
                          notTested_};
    } catch (const gl::ContextLost&) {
        throw;
    } catch (const std::exception& error) {
        result_ = SelfTestResult{false, check.place + ": " + error.what()};
    }
    return !result_.has_value();
}

std::string SelfTest::progress() const {
    return checks_[std::min(check_, checks_.size() - 1)].place + " (" + std::to_string(check_ + 1) + " of " +
           std::to_string(checks_.size()) + " checks), " + std::to_string(newPrograms_) + " programs";
}

nlohmann::ordered_json selfTestJson(const SelfTestResult& result) {
    return {{"passed", result.passed}, {"text", result.text}};
}

}  // namespace vct
