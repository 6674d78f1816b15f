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
constexpr double depthMargin = 1.01;

// The shadow map's axes: unit vectors in world space, of which `right` and `up` are perpendicular to the
// light but not to each other.
struct LightAxes {
    glm::dvec3 right, up, towards;  // `towards` the light
};

// Edges along two axes of the world cast shadows along the map's texels, so that these shadows have no teeth.
// The third axis is the one along which the light travels farthest: its edges cast the narrowest shadows.
LightAxes lightAxes(const DirectionalLight& light) {
    const glm::dvec3 towards = light.directionToLight;
    const glm::dvec3 size = glm::abs(towards);
    const int along = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const auto across = [&](int axis) {
        glm::dvec3 edge(0.0);
        edge[axis % 3] = 1.0;
        return glm::normalize(glm::cross(towards, edge));
    };
    return {across(along + 1), (towards[along] < 0.0 ? -1.0 : 1.0) * across(along + 2), towards};
}

// Projects the box around `centre` along the light to [0, 1]^3.
glm::dmat4 orthographic(const LightAxes& axes, const glm::dvec3& centre, double halfWidth, double halfHeight,
                        double range) {
    glm::dmat4 m(1.0);
    for (int i = 0; i < 3; ++i) {
        m[i][0] = axes.right[i] / (2.0 * halfWidth);
        m[i][1] = axes.up[i] / (2.0 * halfHeight);
        m[i][2] = -axes.towards[i] / range;
    }
    m[3] = glm::dvec4(glm::dvec3(0.5) - glm::dmat3(m) * centre, 1.0);
    return m;
}

// Perpendicular axes of an orthographic shadow map: unit vectors in volume space. The first and the last are
// those of the map.
struct ConeAxes {
    glm::dvec3 right, up, away;
};

ConeAxes coneAxes(const glm::dmat4& shadowFromVolume) {
    const glm::dmat3 rows = glm::transpose(glm::dmat3(shadowFromVolume));
    const glm::dvec3 right = glm::normalize(rows[0]), away = glm::normalize(rows[2]);
    return {right, glm::cross(right, away), away};
}

// The radius of the sun's cone per depth, in map coordinates: along the first axis, and perpendicular to it.
glm::dvec2 coneRadius(const glm::dmat4& shadowFromVolume, double halfAngleRad) {
    const ConeAxes axes = coneAxes(shadowFromVolume);
    const glm::dmat3 map(shadowFromVolume);
    return std::tan(halfAngleRad) * glm::dvec2((map * axes.right).x, (map * axes.up).y) / (map * axes.away).z;
}

// The tile of the shadow map around a cascade. Depths are those of the scene's whole map, so that objects
// between the sun and the cascade cast shadows. The tile moves in steps of whole texels, so that edges of
// shadows do not crawl while the camera moves.
glm::dmat4 shadowTileFromWorld(const LightAxes& axes, const Bounds& boundsWorld, const Volume& volume,
                               const Cascades& cascades, int cascade, int tileSize) {
    const double side = cascades.side(cascade) * volume.side;
    const glm::dvec3 cubeCentre = volume.minWorld + cascades.corner(cascade) * volume.side + 0.5 * side;
    const glm::dvec3 centre = 0.5 * (boundsWorld.min + boundsWorld.max);
    const double share = 0.5 / (1.0 - 2.0 * VCT_SHADOW_TILE_MARGIN);
    const auto halfAlong = [&](const glm::dvec3& axis) {
        return share * side * (std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z));
    };
    const double halfWidth = halfAlong(axes.right), halfHeight = halfAlong(axes.up);
    glm::dmat4 m = orthographic(axes, centre, halfWidth, halfHeight,
                                glm::length(boundsWorld.max - boundsWorld.min) * depthMargin);
    for (int i = 0; i < 2; ++i) {
        const double toCube = (glm::dmat3(m) * (cubeCentre - centre))[i];
        m[3][i] -= std::round(toCube * tileSize) / tileSize;
    }
    return m;
}

}  // namespace

glm::dmat4 shadowFromWorld(const DirectionalLight& light, const Bounds& boundsWorld, int shadowMapSize) {
    const LightAxes axes = lightAxes(light);
    const glm::dvec3 centre = 0.5 * (boundsWorld.min + boundsWorld.max);
    const glm::dvec3 half = 0.5 * (boundsWorld.max - boundsWorld.min);
    const double diagonal = 2.0 * glm::length(half);
    // The map's half extents are those of the box along its axes, and one texel more for the filter. A plane
    // seen edge-on still gets a map of finite size.
    const double margin = 1.0 + 2.0 / shadowMapSize;
    const double smallest = 1e-3 * (diagonal > 0.0 ? diagonal : 1.0);
    const double halfWidth = std::max(glm::dot(glm::abs(axes.right), half), smallest) * margin;
    const double halfHeight = std::max(glm::dot(glm::abs(axes.up), half), smallest) * margin;
    return orthographic(axes, centre, halfWidth, halfHeight, (diagonal > 0.0 ? diagonal : 1.0) * depthMargin);
}

shared::FrameUniforms frameUniforms(const Camera& camera, const DirectionalLight& light, float radianceUnit,
                                    const Bounds& boundsWorld, const Volume& volume, const Settings& settings,
                                    const Bounds& visibleWorld) {
    const double aspect = aspectOf(settings.size);
    const glm::dmat4 worldFromVolume = glm::inverse(volume.volumeFromWorld());
    const glm::dmat4 clipFromVolume =
        clipFromWorld(camera, boundsWorld, aspect, visibleWorld) * worldFromVolume;
    shared::FrameUniforms frame{};
    frame.clipFromVolume = glm::mat4(clipFromVolume);
    // Window coordinates are gl_FragCoord's xy and the depth buffer's depth.
    const glm::dvec3 window(settings.size.x, settings.size.y, camera.reversedDepth ? 2.0 : 1.0);
    const glm::dmat4 clipFromWindow =
        glm::translate(glm::dmat4(1.0), glm::dvec3(-1.0, -1.0, camera.reversedDepth ? 0.0 : -1.0)) *
        glm::scale(glm::dmat4(1.0), 2.0 / window);
    frame.farDepth = camera.reversedDepth ? 0.0F : 1.0F;
    frame.volumeFromWindow = glm::mat4(glm::inverse(clipFromVolume) * clipFromWindow);
    const glm::dmat4 shadowFromVolume =
        shadowFromWorld(light, boundsWorld, settings.shadowMapSize) * worldFromVolume;
    frame.shadowFromVolume = glm::mat4(shadowFromVolume);
    frame.eye = glm::vec4(glm::vec3(eyeInVolume(camera, volume)), 1.0F);
    frame.directionToLight = glm::vec4(glm::vec3(light.directionToLight), 0.0F);
    const float sun = sunlitRadiance(light) / radianceUnit;
    frame.lightColor = glm::vec4(sun * light.color, sun > 0.0F ? sun : 1.0F);
    const auto relative = [&](const glm::vec3& radiance) { return glm::vec4(radiance / radianceUnit, 0.0F); };
    frame.skyRadiance = relative(settings.skyRadiance);
    frame.background = relative(settings.background.value_or(settings.skyRadiance));
    const double halfAngleRad = 0.5 * settings.shadowConeAngleDeg * pi / 180.0;
    const glm::dvec2 radius = coneRadius(shadowFromVolume, halfAngleRad);
    frame.shadowConeRadius = glm::vec2(radius);
    frame.shadowConeSine = static_cast<float>(std::sin(halfAngleRad));
    frame.aoDistance =
        settings.aoDistance * static_cast<float>(Cascades(settings.cascades, volume.grid).side(0));
    frame.shadowConeTexel = glm::vec2(1.0 / (radius * static_cast<double>(settings.shadowMapSize)));
    const double tangent = std::tan(halfAngleRad);
    const ConeAxes axes = coneAxes(shadowFromVolume);
    frame.shadowSlopeFromNormal =
        glm::mat4(glm::dmat4(glm::transpose(glm::dmat3(tangent * axes.right, tangent * axes.up, axes.away))));
    const glm::dmat3 map(shadowFromVolume);
    frame.shadowShear = static_cast<float>((map * axes.right).y / (map * axes.up).y);
    frame.gridSide = volume.grid;
    frame.volumeInWorld = glm::vec4(volume.minWorld, 1.0 / volume.side);
    return frame;
}

glm::dvec3 eyeInVolume(const Camera& camera, const Volume& volume) {
    return glm::dvec3(volume.volumeFromWorld() * camera.worldFromCamera[3]);
}

void setCascades(shared::FrameUniforms& frame, const Cascades& now, const Cascades& last,
                 const DirectionalLight& light, const Bounds& boundsWorld, const Volume& volume,
                 const Settings& settings) {
    for (int i = 0; i < now.count(); ++i) {
        const double voxels = frame.gridSide / now.side(i);
        frame.cascade[i] = glm::vec4(now.corner(i), voxels);
        frame.lastCascade[i] = glm::vec4(last.corner(i), voxels);
    }
    if (now.count() == 1) return;
    const glm::dmat4 worldFromVolume = glm::inverse(volume.volumeFromWorld());
    const LightAxes axes = lightAxes(light);
    for (int tile = 0; tile < VCT_SHADOW_TILES; ++tile) {
        const int cascade = now.ofShadowTile(tile);
        const glm::dvec3 offset(tile & 1, tile >> 1, 0.0), scale(0.5, 0.5, 1.0);
        const glm::dmat4 mapFromTile =
            glm::scale(glm::dmat4(1.0), scale) * glm::translate(glm::dmat4(1.0), offset);
        const glm::dmat4 mapFromVolume =
            mapFromTile *
            shadowTileFromWorld(axes, boundsWorld, volume, now, cascade, settings.shadowMapSize) *
            worldFromVolume;
        frame.shadowTileFromVolume[tile] = glm::mat4(mapFromVolume);
        const glm::vec2 radius(coneRadius(mapFromVolume, 0.5 * settings.shadowConeAngleDeg * pi / 180.0));
        frame.shadowTileCone[tile] = glm::vec4(radius, 1.0F / (radius * (2.0F * settings.shadowMapSize)));
    }
}

}  // namespace vct
