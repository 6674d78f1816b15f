// The look-up of irradiance (lookUpGlsl(), bindLookUp()), against path tracing: references/points/ holds
// points of rooms with their irradiance (tools/evaluation/points.py).
#include <iostream>
#include <set>

#include "api/described_scene.h"
#include "api/gl_state.h"
#include "image/environment_file.h"
#include "support/errors.h"

namespace vct::test {
namespace {

// A scene without textures from assets/, as a program describes it.
struct DescribedAsset {
    Scene loaded;
    std::vector<std::vector<float>> numbers;  // positions and normals of each mesh
    Image sky;
    SceneDescription scene;

    explicit DescribedAsset(const std::string& name) : loaded(loadGltf(asset(name + ".glb"))) {
        for (const Material& m : loaded.materials)
            scene.materials.push_back({{m.baseColor.r, m.baseColor.g, m.baseColor.b},
                                       {m.emissive.r, m.emissive.g, m.emissive.b},
                                       m.metallic,
                                       m.roughness,
                                       m.doubleSided});
        for (const Mesh& mesh : loaded.meshes) {
            std::vector<float> positions, normals;
            for (const Vertex& vertex : mesh.vertices)
                for (int i = 0; i < 3; ++i) {
                    positions.push_back(vertex.position[i] + static_cast<float>(mesh.centre[i]));
                    normals.push_back(vertex.normal[i]);
                }
            numbers.push_back(std::move(positions));
            numbers.push_back(std::move(normals));
            scene.meshes.push_back({numbers[numbers.size() - 2], numbers.back(), mesh.indices,
                                    static_cast<std::size_t>(mesh.material)});
        }
        for (const Instance& instance : loaded.instances)
            scene.instances.push_back({static_cast<std::size_t>(instance.mesh),
                                       Matrix::of(glm::value_ptr(instance.worldFromObject))});
        scene.sun.illuminance = 0;
        for (const DirectionalLight& sun : loaded.lights) {
            scene.sun.directionToSun = {sun.directionToLight.x, sun.directionToLight.y,
                                        sun.directionToLight.z};
            scene.sun.illuminance = sun.intensity;
            if (sun.intensity > 0) scene.sun.color = {sun.color.r, sun.color.g, sun.color.b};
        }
        for (const PunctualLight& light : loaded.punctualLights)
            scene.lights.push_back(described(light));
        if (name == "patio") {
            sky = readEnvironment(asset("patio.hdr"));
            scene.sky = SkyPicture{sky.width, sky.height, {&sky.pixels[0].x, 3 * sky.pixels.size()}};
        }
    }

    static LightDescription described(const PunctualLight& light) {
        LightDescription result;
        const bool isSpot = light.type == PunctualLight::Type::spot;
        result.type = isSpot ? LightDescription::Type::spot : LightDescription::Type::point;
        const glm::dmat4& m = light.worldFromLight;
        result.position = {m[3].x, m[3].y, m[3].z};
        result.direction = {-m[2].x, -m[2].y, -m[2].z};
        result.color = {light.color.r, light.color.g, light.color.b};
        result.intensity = light.intensity;
        result.innerConeDegrees = static_cast<float>(glm::degrees(light.innerConeRad));
        result.outerConeDegrees = static_cast<float>(glm::degrees(light.outerConeRad));
        return result;
    }

    View view() const {
        const Camera& camera = loaded.cameras.front();
        const glm::dmat4 projection =
            clipFromWorld(camera, loaded.boundsWorld, double{width} / height) * camera.worldFromCamera;
        return {Matrix::of(glm::value_ptr(glm::inverse(camera.worldFromCamera))),
                Matrix::of(glm::value_ptr(projection))};
    }
};

// Names that a program may have, too.
const char* const ownNames = R"(
struct Cone { vec3 faces; };
uniform vec3 irradiance, normal, frame;
vec3 radianceOf(Cone emitters) { return emitters.faces * irradiance * normal + frame; }
float levelAt(vec3 position) { return position.x; }
)";

// Positions and normals to irradiance, by a compute shader of the program's own.
std::vector<glm::vec3> lookedUp(const GlobalIllumination& light, const Image& points) {
    const LookUpBindings bindings{3, 2};
    const std::string source = "#version 310 es\nprecision highp float;\nprecision highp int;\n" +
                               light.lookUpGlsl(bindings) + ownNames + R"(
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Points { vec4 points[]; };
void main() {
    uint i = 2u * gl_GlobalInvocationID.x;
    points[i] = vec4(irradianceAt(points[i].xyz, points[i + 1u].xyz), 1.0);
})";
    const char* text = source.c_str();
    const GLuint shader = gl::CreateShader(GL_COMPUTE_SHADER), program = gl::CreateProgram();
    gl::ShaderSource(shader, 1, &text, nullptr);
    gl::CompileShader(shader);
    std::string log(4096, '\0');
    gl::GetShaderInfoLog(shader, 4096, nullptr, log.data());
    gl::AttachShader(program, shader);
    gl::LinkProgram(program);
    gl::DeleteShader(shader);
    std::vector<glm::vec4> values;
    for (int i = 0; i < points.height; ++i) {
        values.emplace_back(points.at(0, i), 0);
        values.emplace_back(points.at(1, i), 0);
    }
    const gl::Buffer buffer("points", GL_SHADER_STORAGE_BUFFER, values.size() * sizeof values[0],
                            values.data(), GL_STATIC_COPY);
    buffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
    light.bindLookUp(bindings);
    gl::UseProgram(program);
    gl::DispatchCompute(static_cast<GLuint>(points.height), 1, 1);
    gl::MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    gl::DeleteProgram(program);
    EXPECT_EQ(gl::GetError(), GLenum{GL_NO_ERROR}) << log.c_str();
    buffer.read(values.data(), buffer.bytes());
    std::vector<glm::vec3> result;
    for (std::size_t i = 0; i < values.size(); i += 2)
        result.emplace_back(values[i]);
    return result;
}

struct Room {
    const char* name;
    const char* preset;
};
void PrintTo(const Room& room, std::ostream* stream) {
    *stream << room.name << ", " << room.preset;
}

class LookUp : public ::testing::TestWithParam<Room> {
  protected:
    std::unique_ptr<Platform> context_ = createContext(Backend::egl, false);
};

TEST_P(LookUp, AgreesWithPathTracing) {
    const DescribedAsset room(GetParam().name);
    const Image points =
        readImage(VCT_SOURCE_DIR "/references/points/" + std::string(GetParam().name) + ".exr");
    Options options = optionsOf(GetParam().preset);
    options.grid = 0;
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
        EXPECT_LE(relMse, first == 0 ? 0.02 : 0.05) << place;
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
    light.bindLookUp({5, 4});
    std::set<std::string> changed, expected;
    for (const auto& [name, values] : readGlState())
        if (values != before.at(name)) changed.insert(name);
    for (int i = 0; i < 5; ++i)
        expected.insert("textures and sampler of unit " + std::to_string(5 + i));
    for (int i = 0; i < 3; ++i)
        expected.insert("uniform buffer " + std::to_string(4 + i));
    EXPECT_EQ(changed, expected);
    EXPECT_EQ(gl::GetError(), GLenum{GL_NO_ERROR});

    GlobalIllumination thesis(getProcAddress, described_.scene, optionsOf("thesis"));
    expectMentions(errorOf([&] { thesis.lookUpGlsl(); }), {"preset thesis has no look-up"});
}

INSTANTIATE_TEST_SUITE_P(Rooms, LookUp,
                         ::testing::Values(Room{"cornell", "mobile"}, Room{"corridor", "mobile"},
                                           Room{"lamp", "mobile"}, Room{"night", "mobile"},
                                           Room{"patio", "mobile"}),
                         [](const auto& room) {
                             return std::string(room.param.name) + "_" + room.param.preset;
                         });

}  // namespace
}  // namespace vct::test
