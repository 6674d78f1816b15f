#include "engine/passes/punctual_lights.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "core/error.h"
#include "engine/frame_uniforms.h"
#include "engine/passes/shadow_map.h"
#include "engine/programs.h"
#include "gl/debug.h"
#include "gl/render_pass.h"
#include "scene/camera.h"

namespace vct {

namespace {

using Type = PunctualLight::Type;

// Texels along a side. All maps together take at most as much memory as one map of 1536^2 texels, 4.7 MB.
constexpr int maxMapSize = 512;
constexpr int maxTotalSize = 1536;
// Texels at each border of a map that only the filter reads.
constexpr int margin = 2;
// The near plane, relative to the far plane. Nearer surfaces cast no shadow.
constexpr double nearShare = 1e-3;

std::size_t checkedCount(const Scene& scene) {
    const std::size_t count = scene.punctualLights.size() + scene.punctualLightRoom;
    if (count > VCT_MAX_PUNCTUAL_LIGHTS)
        throw Error("the scene has " + std::to_string(count) + " lights besides the sun, and the limit is " +
                    std::to_string(VCT_MAX_PUNCTUAL_LIGHTS) + "; remove the weakest");
    return count;
}

// The view of a cube's face: +x, -x, +y, -y, +z, -z, as in shaders/shared/punctual_lights.glsl.
glm::dmat4 viewOfCube(int face, const glm::dvec3& position) {
    glm::dvec3 forward(0.0), up(0.0);
    forward[face / 2] = face % 2 == 0 ? 1.0 : -1.0;
    up[(face / 2 + 1) % 3] = 1.0;
    return glm::lookAt(position, position + forward, up);
}

}  // namespace

gl::ProgramDescription lightMapProgram(unsigned features) {
    gl::ProgramDescription program = shadowMapProgram(features);
    program.name = "light_map";
    program.shaders = {"passes/light_map.vert", "passes/light_map.frag"};
    return program;
}

PunctualLights::PunctualLights(const gl::ShaderLibrary& shaders, const GpuScene& gpuScene, const Scene& scene,
                               const Volume& volume, double unitLux, const LightSize& size)
    : measure_(scene),
      lights_(checkedCount(scene)),
      states_(lights_.size(), {glm::dmat4(1.0), false}),
      volume_(volume),
      boundsWorld_(scene.boundsWorld),
      unitLux_(unitLux),
      size_(size),
      programs_(shaders, gpuScene, lightMapProgram),
      uniforms_("punctual lights", GL_UNIFORM_BUFFER, sizeof values_, nullptr, GL_DYNAMIC_DRAW) {
    maps_ = 6 * static_cast<int>(scene.punctualLightRoom);
    for (std::size_t i = 0; i < scene.punctualLights.size(); ++i) {
        const PunctualLight& light = scene.punctualLights[i];
        lights_[i] = {light, measure_.of(light)};
        states_[i] = {light.worldFromLight, true};
        maps_ += shadowMapsOf(light);
    }
    maps_ = std::min(maps_, VCT_MAX_LIGHT_MAPS);
    assignMaps();
    mapSize_ = std::min(maxMapSize, maxTotalSize / static_cast<int>(std::ceil(std::sqrt(maps_))));
    depth_ = gl::Texture::make2dArray("light maps", GL_DEPTH_COMPONENT16, mapSize_, mapSize_, maps_);
    for (int map = 0; map < maps_; ++map)
        framebuffers_.emplace_back("light map " + std::to_string(map), depth_, map);
}

// The index of the first of `count` maps that no light has; -1: there are none.
int PunctualLights::freeMaps(int count) const {
    int first = 0;
    for (int map = 0; map < maps_ && map - first < count; ++map)
        for (const Light& light : lights_)
            if (light.maps > 0 && map >= light.firstMap && map < light.firstMap + light.maps) first = map + 1;
    return first + count <= maps_ ? first : -1;
}

// Lights keep the maps that they have, unless these are in the way.
void PunctualLights::assignMaps() {
    std::vector<MeasuredLight> measured;
    for (const Light& light : lights_)
        if (light.definition) measured.push_back({light.measure, shadowMapsOf(*light.definition)});
    const std::vector<bool> chosen = lightsWithMaps(measured, maps_);
    std::vector<int> wanted;
    std::size_t next = 0;
    for (Light& light : lights_) {
        wanted.push_back(light.definition && chosen[next] ? measured[next].maps : 0);
        next += light.definition ? 1 : 0;
        if (wanted.back() != light.maps) light.maps = 0;
    }
    const auto assign = [&] {
        for (std::size_t i = 0; i < lights_.size(); ++i) {
            if (lights_[i].maps == wanted[i]) continue;
            lights_[i].firstMap = freeMaps(wanted[i]);
            if (lights_[i].firstMap < 0) return false;
            lights_[i].maps = wanted[i];
        }
        return true;
    };
    if (assign()) return;
    for (Light& light : lights_)
        light.maps = 0;
    assign();
}

void PunctualLights::setLight(std::size_t index, const std::optional<PunctualLight>& definition) {
    Light& light = lights_.at(index);
    light.definition = definition;
    light.measure = definition ? measure_.of(*definition) : 0.0;
    states_[index] = {definition ? definition->worldFromLight : glm::dmat4(1.0), definition.has_value()};
    assignMaps();
    uploaded_.clear();
}

void PunctualLights::setSize(const LightSize& size) {
    size_ = size;
    uploaded_.clear();
}

void PunctualLights::setPose(const Pose& pose) {
    for (std::size_t i = 0; i < lights_.size(); ++i)
        if (lights_[i].definition)
            states_[i].worldFromLight = posed(*lights_[i].definition, pose).worldFromLight;
}

std::vector<glm::dvec4> PunctualLights::positions() const {
    std::vector<glm::dvec4> positions;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const glm::dmat4& world = states_[i].worldFromLight;
        const bool isDirectional = lights_[i].definition && lights_[i].definition->type == Type::directional;
        positions.push_back(isDirectional ? glm::dvec4(glm::dvec3(world[2]), 0.0)
                                          : volume_.volumeFromWorld() * world[3]);
    }
    return positions;
}

void PunctualLights::invalidate() {
    for (Light& light : lights_)
        light.cachedFor.reset();
    uploaded_.clear();
}

void PunctualLights::update(const GpuScene& scene, const SceneState& now, bool forceRebuild,
                            StepTimer& timer) {
    if (forceRebuild || uploaded_ != states_) timer.timeOnCpu(Step::shadowMap, [&] { upload(); });
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        Light& light = lights_[i];
        if (!states_[i].on || light.maps == 0) continue;
        const PunctualLight& definition = *light.definition;
        const MapSource source{definition.type, states_[i].worldFromLight, definition.outerConeRad,
                               definition.range, light.firstMap};
        std::vector<Placement> placements = placementsInRange(light, states_[i], now.placements);
        std::optional<std::vector<Bounds>> changed;
        if (!forceRebuild && light.cachedFor == source)
            changed = changedBoxes(light.cachedPlacements, placements);
        if (changed && changed->empty()) continue;
        light.cachedFor.reset();
        timer.time(Step::shadowMap, [&] { drawMaps(scene, light, changed); });
        light.cachedFor = source;
        light.cachedPlacements = std::move(placements);
    }
}

// Uploads the lights that are on.
void PunctualLights::upload() {
    values_.count = glm::ivec4(0);
    const std::vector<glm::dvec4> positions = this->positions();
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        if (!states_[i].on) continue;
        const PunctualLight& light = *lights_[i].definition;
        shared::PunctualLightUniforms& to = values_.light[values_.count.x++];
        to.position = glm::vec4(positions[i]);
        const bool placed = light.type != Type::directional;
        const double range = light.range / volume_.side;
        to.backwards = glm::vec4(glm::vec3(states_[i].worldFromLight[2]),
                                 placed && std::isfinite(range) ? 1.0 / (range * range) : 0.0);
        const double unit = unitLux_ * (placed ? volume_.side * volume_.side : 1.0);
        to.intensity = glm::vec4(light.color * static_cast<float>(light.intensity / unit), 0.0F);
        // KHR_lights_punctual, "Inner and Outer Cone Angles".
        double scale = 0.0, offset = 1.0;
        if (light.type == Type::spot) {
            const double cosOuter = std::cos(light.outerConeRad);
            scale = 1.0 / std::max(0.001, std::cos(light.innerConeRad) - cosOuter);
            offset = -cosOuter * scale;
        }
        const double usualSize =
            placed ? size_.radius : std::tan(0.5 * glm::radians(size_.directionalAngleDeg));
        to.cone =
            glm::vec4(scale, offset, light.size.value_or(usualSize) / (placed ? volume_.side : 1.0), 0.0);
        to.maps = glm::ivec4(lights_[i].firstMap, lights_[i].maps, 0, 0);
        placeMaps(lights_[i], states_[i]);
    }
    uniforms_.bind(GL_UNIFORM_BUFFER);
    gl::BufferSubData(GL_UNIFORM_BUFFER, 0, sizeof values_, &values_);
    uploaded_ = states_;
}

void PunctualLights::placeMaps(const Light& light, const PunctualLightState& state) {
    if (light.maps == 0) return;
    const PunctualLight& definition = *light.definition;
    const bool usesCube = light.maps > 1;
    const glm::dmat4 volumeFromWorld = volume_.volumeFromWorld();
    // `range`: the length that the stored depths cover, in sides of the volume.
    const auto set = [&](int map, const glm::dmat4& mapFromVolume, double quarterTexel, double depthOfSide,
                         double storedNear, double range) {
        const double roundedPosition = 1e-4;  // of a position from the G-buffer
        values_.map[map] = {glm::mat4(mapFromVolume), glm::vec4(quarterTexel, depthOfSide, storedNear,
                                                                roundedPosition + range / 0x1FFFE)};
    };
    if (definition.type == Type::directional) {
        const DirectionalLight sun{glm::dvec3(state.worldFromLight[2])};
        const glm::dmat4 mapFromVolume =
            shadowFromWorld(sun, boundsWorld_, mapSize_ - 2 * margin) * glm::inverse(volumeFromWorld);
        // The depth range is at least as long as the map is wide, so a quarter of a texel is at most this.
        const double depthOfSide = glm::length(glm::transpose(glm::dmat3(mapFromVolume))[2]);
        set(light.firstMap, mapFromVolume, 0.25 / mapSize_, depthOfSide, 0.0, 1.0 / depthOfSide);
        return;
    }
    const glm::dvec3 position(volumeFromWorld * state.worldFromLight[3]);
    double farthest = 0.0;
    for (const glm::dvec3& corner : cornersOf(boundsWorld_))
        farthest = std::max(farthest,
                            glm::distance(glm::dvec3(volumeFromWorld * glm::dvec4(corner, 1.0)), position));
    const double far = 1.001 * std::min(farthest, definition.range / volume_.side);
    const double near = nearShare * far;
    const double tanHalf =
        (usesCube ? 1.0 : std::tan(definition.outerConeRad)) * mapSize_ / (mapSize_ - 2 * margin);
    const glm::dmat4 mapFromView = glm::translate(glm::dmat4(1.0), glm::dvec3(0.5)) *
                                   glm::scale(glm::dmat4(1.0), glm::dvec3(0.5)) *
                                   glm::perspectiveRH_NO(2.0 * std::atan(tanHalf), 1.0, near, far);
    // The depth of a perspective projection is a - b / w.
    const double b = far * near / (far - near);
    const double quarterTexel = 0.5 * tanHalf / mapSize_ * b;
    for (int i = 0; i < light.maps; ++i) {
        const glm::dmat4 view = usesCube
                                    ? viewOfCube(i, position)
                                    : glm::lookAt(position, position - glm::dvec3(state.worldFromLight[2]),
                                                  glm::dvec3(state.worldFromLight[1]));
        set(light.firstMap + i, mapFromView * view, quarterTexel, b, near / (far - near), far);
    }
}

std::vector<Placement> PunctualLights::placementsInRange(const Light& light, const PunctualLightState& state,
                                                         const std::vector<Placement>& placements) const {
    if (!std::isfinite(light.definition->range)) return placements;
    const glm::dvec3 position(volume_.volumeFromWorld() * state.worldFromLight[3]);
    std::vector<Placement> found;
    for (const Placement& placement : placements)
        if (glm::distance(glm::clamp(position, placement.box.min, placement.box.max), position) <=
            light.definition->range / volume_.side)
            found.push_back(placement);
    return found;
}

// `changed`: boxes outside of which the maps are up to date, if there are such.
void PunctualLights::drawMaps(const GpuScene& scene, const Light& light,
                              const std::optional<std::vector<Bounds>>& changed) {
    const gl::DebugGroup group("light maps");
    uniforms_.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_PUNCTUAL_LIGHTS);
    for (int map = light.firstMap; map < light.firstMap + light.maps; ++map) {
        const DrawRegion region(values_.map[map].mapFromVolume);
        if (changed && !region.meetsAny(*changed)) continue;
        const gl::RenderPass pass(framebuffers_[static_cast<std::size_t>(map)]);
        programs_.setUniform(VCT_UNIFORM_LIGHT_MAP, static_cast<GLuint>(map));
        scene.draw(GpuScene::Culling::none, programs_, region);
    }
}

void PunctualLights::bind() const {
    uniforms_.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_PUNCTUAL_LIGHTS);
    depth_.bind(VCT_TEX_LIGHT_MAPS);
}

Resources PunctualLights::resources() const {
    Resources resources;
    add(resources, uniforms_);
    add(resources, depth_);
    return resources;
}

}  // namespace vct
