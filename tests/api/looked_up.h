// The look-up of irradiance at points, in a scene that was described from an engine's Scene.
#pragma once

#include "api/described_scene.h"

namespace vct::test {

// A scene without textures, as a program describes it.
struct DescribedScene {
    Scene loaded;
    std::vector<std::vector<float>> numbers;  // positions and normals of each mesh
    SceneDescription scene;

    explicit DescribedScene(Scene from) : loaded(std::move(from)) {
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

    View view() const { return view(loaded.cameras.front()); }
    View view(const Camera& camera) const { return viewOf(camera, loaded.boundsWorld); }
};

// Names that a program may have, too.
inline const char* const ownNames = R"(
struct Cone { vec3 faces; };
uniform vec3 irradiance, normal, frame;
const vec3 allGeometry = vec3(1.0), wallDistances = vec3(2.0);
vec3 radianceOf(Cone emitters) { return emitters.faces * irradiance * normal + frame; }
float levelAt(vec3 position) { return position.x; }
)";

// Positions and normals to irradiance, or to another value of `points[i]` and `points[i + 1u]`, by a compute
// shader of the program's own. `before`: text before that of the look-up.
inline std::vector<glm::vec3> lookedUp(
    const GlobalIllumination& light, const Image& points,
    const std::string& value = "irradianceAt(points[i].xyz, points[i + 1u].xyz)",
    const std::string& before = "") {
    const LookUpBindings bindings{3, 2, 1};
    const std::string source = "#version 310 es\nprecision highp float;\nprecision highp int;\n" + before +
                               light.lookUpGlsl(bindings) + ownNames + R"(
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Points { vec4 points[]; };
void main() {
    uint i = 2u * gl_GlobalInvocationID.x;
    points[i] = vec4()" + value +
                               R"(, 1.0);
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

}  // namespace vct::test
