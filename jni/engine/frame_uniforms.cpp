#include "engine/frame_uniforms.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "engine/environment.h"
#include "engine/radiance_unit.h"
#include "scene/camera.h"

namespace vct {

namespace {
constexpr double pi = 3.14159265358979323846;
}

glm::dmat4 shadowFromWorld(const DirectionalLight& light, const Bounds& boundsWorld, int shadowMapSize) {
    const glm::dvec3 towards = light.directionToLight;
    const glm::dvec3 helper = std::abs(towards.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0);
    const glm::dvec3 right = glm::normalize(glm::cross(helper, towards));
    const glm::dvec3 up = glm::cross(towards, right);
    const glm::dvec3 centre = 0.5 * (boundsWorld.min + boundsWorld.max);
    const glm::dvec3 half = 0.5 * (boundsWorld.max - boundsWorld.min);
    const double diagonal = 2.0 * glm::length(half);
    // The map's half extents are those of the box along its axes, and one texel more for the filter. A plane
    // seen edge-on still gets a map of finite size.
    const double margin = 1.0 + 2.0 / shadowMapSize;
    const double smallest = 1e-3 * (diagonal > 0.0 ? diagonal : 1.0);
    const double halfWidth = std::max(glm::dot(glm::abs(right), half), smallest) * margin;
    const double halfHeight = std::max(glm::dot(glm::abs(up), half), smallest) * margin;
    const double range = (diagonal > 0.0 ? diagonal : 1.0) * 1.01;

    glm::dmat4 m(1.0);
    for (int i = 0; i < 3; ++i) {
        m[i][0] = right[i] / (2.0 * halfWidth);
        m[i][1] = up[i] / (2.0 * halfHeight);
        m[i][2] = -towards[i] / range;
    }
    m[3] = glm::dvec4(glm::dvec3(0.5) - glm::dmat3(m) * centre, 1.0);
    return m;
}

shared::FrameUniforms frameUniforms(const Camera& camera, const DirectionalLight& light, float radianceUnit,
                                    const Bounds& boundsWorld, const Volume& volume, const Settings& settings,
                                    const Bounds& visibleWorld) {
    const double aspect = aspectOf(settings.size);
    const glm::dmat4 worldFromVolume = glm::inverse(volume.volumeFromWorld());
    const glm::dmat4 clipFromVolume =
        clipFromWorld(camera, boundsWorld, aspect, visibleWorld) * worldFromVolume;
    const glm::dvec4 eye = volume.volumeFromWorld() * camera.worldFromCamera[3];

    shared::FrameUniforms frame{};
    frame.clipFromVolume = glm::mat4(clipFromVolume);
    // Window coordinates are gl_FragCoord's xy and the depth buffer's depth.
    const glm::dmat4 clipFromWindow =
        glm::translate(glm::dmat4(1.0), glm::dvec3(-1.0)) *
        glm::scale(glm::dmat4(1.0), 2.0 / glm::dvec3(settings.size.x, settings.size.y, 1.0));
    frame.volumeFromWindow = glm::mat4(glm::inverse(clipFromVolume) * clipFromWindow);
    const glm::dmat4 shadowFromVolume =
        shadowFromWorld(light, boundsWorld, settings.shadowMapSize) * worldFromVolume;
    frame.shadowFromVolume = glm::mat4(shadowFromVolume);
    frame.eye = glm::vec4(eye);
    frame.directionToLight = glm::vec4(glm::vec3(light.directionToLight), 0.0F);
    const float sun = sunlitRadiance(light) / radianceUnit;
    frame.lightColor = glm::vec4(sun * light.color, sun > 0.0F ? sun : 1.0F);
    const auto relative = [&](const glm::vec3& radiance) { return glm::vec4(radiance / radianceUnit, 0.0F); };
    frame.skyRadiance = relative(settings.skyRadiance);
    frame.background = relative(settings.background.value_or(settings.skyRadiance));
    const float sky =
        settings.environment
            ? settings.environment->largestIrradiance()
            : std::max({settings.skyRadiance.r, settings.skyRadiance.g, settings.skyRadiance.b});
    frame.largestSky = sky / radianceUnit;
    const double halfAngleRad = 0.5 * settings.shadowConeAngleDeg * pi / 180.0;
    // The columns are the map's axes in volume space; their lengths are map coordinates per volume side.
    const glm::dmat3 axes = glm::transpose(glm::dmat3(shadowFromVolume));
    const glm::dvec2 radius = std::tan(halfAngleRad) *
                              glm::dvec2(glm::length(axes[0]), glm::length(axes[1])) / glm::length(axes[2]);
    frame.shadowConeRadius = glm::vec2(radius);
    frame.shadowConeSine = static_cast<float>(std::sin(halfAngleRad));
    frame.aoDistance = settings.aoDistance;
    frame.gridSide = volume.grid;
    frame.volumeInWorld = glm::vec4(volume.minWorld, 1.0 / volume.side);
    return frame;
}

}  // namespace vct
