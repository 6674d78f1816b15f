#include "scene/framing.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "scene/camera.h"
#include "scene/first_surfaces.h"

namespace vct {
namespace {

constexpr double fullTurn = 6.283185307179586;

// Of a square picture; another shape has the same area at distance 1.
constexpr double outsideTanHalf = 0.364;     // 40 degrees
constexpr double insideTanHalf = 0.7;        // 70 degrees
constexpr double widestFramedTanHalf = 1.2;  // 100 degrees
constexpr double margin = 0.04;              // of the picture's half, free at each side

constexpr int outsideResolution = 96, aroundResolution = 12;
// Of all directions, those in which a closed room has a surface before its middle. A box of 4 x 2 x 4 m that
// is open at the front has 90 %, a room of 4 x 5 x 2.7 m with a window 98 %.
constexpr double closedShare = 0.96;
constexpr double openShare =
    0.6;  // likewise of a room that is open at a side; a field under the sky has half
constexpr double roomShare = 0.1;   // of the bounds' volume, at least, is before a room's middle
constexpr double muchMore = 1.5;    // times the surface that is seen from the front
constexpr double fromBelow = 0.67;  // what a view from below counts, as things rarely stand on glass

struct View {
    glm::dvec3 eye;
    glm::dvec3 target;
    double fovDeg;  // vertical
};

double diagonalOf(const Scene& scene) {
    const double diagonal = glm::length(scene.boundsWorld.max - scene.boundsWorld.min);
    return diagonal > 0.0 && std::isfinite(diagonal) ? diagonal : 1.0;
}

// In tenths of a degree, so that the option that repeats it is short.
double fovFor(double tanHalfSquare, double aspect) {
    const double tanHalf = std::min(tanHalfSquare / std::sqrt(aspect), widestFramedTanHalf);
    return std::max(std::round(10.0 * glm::degrees(2.0 * std::atan(tanHalf))), 1.0) / 10.0;
}

// Columns: right, up and back of a camera that is turned towards the eye from the target by these angles.
glm::dmat3 axesFrom(const glm::dvec3& directionToEye) {
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), directionToEye));
    return {right, glm::cross(directionToEye, right), directionToEye};
}

glm::dvec3 towards(double azimuthRad, double heightOverWidth) {
    return glm::normalize(glm::dvec3(std::sin(azimuthRad), heightOverWidth, std::cos(azimuthRad)));
}

// How far a scene reaches beyond the four planes of a view's sides, were the eye at the centre of its bounds.
struct Reach {
    glm::dmat3 axes;
    glm::dvec2 tanHalf;
    glm::dvec2 upper{-HUGE_VAL}, lower{-HUGE_VAL};
    double highest = -HUGE_VAL;  // along `back`

    void include(const glm::dvec3& fromCentre) {
        const glm::dvec3 p = glm::transpose(axes) * fromCentre;
        upper = glm::max(upper, glm::dvec2(p) + tanHalf * p.z);
        lower = glm::max(lower, tanHalf * p.z - glm::dvec2(p));
        highest = std::max(highest, p.z);
    }
    // The nearest place from which all of it is between the planes; from the centre of the bounds.
    glm::dvec3 eye() const {
        const glm::dvec2 back = 0.5 * (upper + lower) / tanHalf;
        return axes * glm::dvec3(0.5 * (upper - lower), std::max(back.x, back.y));
    }
};

void includeScene(const Scene& scene, std::vector<Reach>& reaches) {
    const glm::dvec3 centre = 0.5 * (scene.boundsWorld.min + scene.boundsWorld.max);
    const auto include = [&](const glm::dvec3& world) {
        for (Reach& reach : reaches)
            reach.include(world - centre);
    };
    const auto moves = [](const Instance& instance) { return instance.moves(); };
    // What moves is in the bounds wherever it goes, and its vertices are at rest.
    if (scene.instances.empty() || std::any_of(scene.instances.begin(), scene.instances.end(), moves)) {
        for (const glm::dvec3& corner : cornersOf(scene.boundsWorld))
            include(corner);
        return;
    }
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        std::vector<bool> used(mesh.vertices.size());
        for (const std::uint32_t index : mesh.indices)
            used[index] = true;
        for (std::size_t i = 0; i < used.size(); ++i)
            if (used[i])
                include(glm::dvec3(instance.worldFromObject *
                                   glm::dvec4(mesh.centre + glm::dvec3(mesh.vertices[i].position), 1.0)));
    }
}

// The views from outside; the first is the usual one.
std::vector<FirstSurfaces> viewsFromOutside(const Scene& scene, double fovDeg, double aspect) {
    std::vector<Reach> reaches;
    const glm::dvec3 usual = glm::normalize(glm::dvec3(0.3, 0.5, 1.0));
    const double tanHalf = (1.0 - margin) * std::tan(0.5 * glm::radians(fovDeg));
    for (const double height : {0.48, -0.48})
        for (int turn = 0; turn < 8; ++turn)
            reaches.push_back(
                {axesFrom(towards(std::atan2(usual.x, usual.z) + turn * fullTurn / 8.0, height)),
                 {tanHalf * aspect, tanHalf}});
    reaches.front().axes = axesFrom(usual);
    includeScene(scene, reaches);
    const glm::dvec3 centre = 0.5 * (scene.boundsWorld.min + scene.boundsWorld.max);
    std::vector<FirstSurfaces> views;
    for (const Reach& reach : reaches) {
        // A point, or a line towards the eye, has no size that asks for a distance.
        glm::dvec3 eye = reach.eye();
        const double least = reach.highest + 1e-3 * diagonalOf(scene);
        eye += std::max(least - glm::dot(eye, reach.axes[2]), 0.0) * reach.axes[2];
        views.emplace_back(centre + eye, reach.axes, tanHalf * aspect, tanHalf, outsideResolution);
    }
    drawFirstSurfaces(scene, views);
    return views;
}

// Square metres of the surfaces that are seen; those that are turned far away count less.
double areaSeen(const FirstSurfaces& view) {
    double area = 0.0;
    for (std::size_t i = 0; i < view.samples.size(); ++i) {
        const FirstSurfaces::Sample& sample = view.samples[i];
        if (sample.depth == 0.0) continue;
        const glm::dvec3 d = sample.depth * view.direction(i);
        const double cosine = -glm::dot(sample.normal, d) / glm::length(d);
        area += glm::dot(d, d) * view.solidAngle(i) / std::max(cosine, 0.5);
    }
    return area;
}

const FirstSurfaces& bestFromOutside(const std::vector<FirstSurfaces>& views) {
    std::size_t best = 0;
    double most = muchMore * areaSeen(views[0]);
    for (std::size_t i = 1; i < views.size(); ++i) {
        const double area = areaSeen(views[i]) * (i < views.size() / 2 ? 1.0 : fromBelow);
        if (area <= most) continue;
        best = i;
        most = area;
    }
    return views[best];
}

// A place inside, and all that is seen around it.
using Around = std::vector<FirstSurfaces>;

struct Enclosure {
    double closed = 0.0;  // share of all directions
    double volume = 0.0;  // of what is before the place
};

Enclosure enclosureOf(const Around& around) {
    Enclosure enclosure;
    for (const FirstSurfaces& view : around) {
        for (std::size_t i = 0; i < view.samples.size(); ++i) {
            const double depth = view.samples[i].depth;
            if (depth == 0.0) continue;
            const double distance = depth * glm::length(view.direction(i));
            enclosure.closed += view.solidAngle(i) / (2.0 * fullTurn);
            enclosure.volume += view.solidAngle(i) * distance * distance * distance / 3.0;
        }
    }
    return enclosure;
}

// Whether what is seen from outside mostly turns its back on a place inside: walls that hide the room, or a
// bottle's outside.
bool hidesItsInside(const FirstSurfaces& outside, const glm::dvec3& inside) {
    int met = 0, hiding = 0;
    for (std::size_t i = 0; i < outside.samples.size(); ++i) {
        const FirstSurfaces::Sample& sample = outside.samples[i];
        if (sample.depth == 0.0) continue;
        ++met;
        const glm::dvec3 point = outside.eye + sample.depth * outside.direction(i);
        if (glm::dot(sample.normal, inside - point) < 0.0) ++hiding;
    }
    return 2 * hiding > met;
}

std::size_t thingsSeen(const std::vector<FirstSurfaces>& views) {
    std::set<int> instances;
    for (const FirstSurfaces& view : views)
        for (const FirstSurfaces::Sample& sample : view.samples)
            if (sample.instance >= 0) instances.insert(sample.instance);
    return instances.size();
}

std::vector<Around> placesAround(const Scene& scene, const std::vector<glm::dvec3>& sharesOfBounds) {
    std::vector<FirstSurfaces> views;
    for (const glm::dvec3& share : sharesOfBounds)
        for (const FirstSurfaces& view :
             viewsAround(glm::mix(scene.boundsWorld.min, scene.boundsWorld.max, share), aroundResolution))
            views.push_back(view);
    drawFirstSurfaces(scene, views);
    std::vector<Around> places;
    for (std::size_t i = 0; i < views.size(); i += 6)
        places.emplace_back(views.begin() + static_cast<std::ptrdiff_t>(i),
                            views.begin() + static_cast<std::ptrdiff_t>(i) + 6);
    return places;
}

// Whether the scene is a room, closed in so many of all directions, whose inside is what there is to see.
bool isRoom(const Scene& scene, const std::vector<FirstSurfaces>& outside, double minClosed) {
    const glm::dvec3 size = scene.boundsWorld.max - scene.boundsWorld.min;
    // The very middle may be inside a column; a place with a column before an opening may look closed.
    const std::vector<Around> places = placesAround(
        scene, {{0.5, 0.5, 0.5}, {0.25, 0.5, 0.25}, {0.75, 0.5, 0.25}, {0.25, 0.5, 0.75}, {0.75, 0.5, 0.75}});
    const Around* widest = nullptr;
    double most = roomShare * size.x * size.y * size.z;
    for (const Around& around : places) {
        const Enclosure enclosure = enclosureOf(around);
        if (enclosure.volume < roomShare * size.x * size.y * size.z) continue;
        if (enclosure.closed < minClosed) return false;
        if (enclosure.volume < most) continue;
        most = enclosure.volume;
        widest = &around;
    }
    if (widest == nullptr) return false;
    return !hidesItsInside(outside.front(), widest->front().eye) || thingsSeen(*widest) > thingsSeen(outside);
}

// Cubic metres before a view with these axes, from all that is around it.
double volumeBefore(const Around& around, const glm::dmat3& axes, const glm::dvec2& tanHalf) {
    const glm::dmat3 viewFromWorld = glm::transpose(axes);
    double volume = 0.0;
    for (const FirstSurfaces& view : around) {
        for (std::size_t i = 0; i < view.samples.size(); ++i) {
            const glm::dvec3 d = view.direction(i), p = viewFromWorld * d;
            if (p.z >= 0.0 || std::abs(p.x) > -p.z * tanHalf.x || std::abs(p.y) > -p.z * tanHalf.y) continue;
            volume += std::pow(view.samples[i].depth * glm::length(d), 3.0) * view.solidAngle(i);
        }
    }
    return volume;
}

View viewInside(const Scene& scene, double aspect) {
    const double fovDeg = fovFor(insideTanHalf, aspect);
    const double tanHalf = std::tan(0.5 * glm::radians(fovDeg));
    std::vector<glm::dvec3> shares;
    for (const double x : {0.12, 0.3, 0.5, 0.7, 0.88})
        for (const double z : {0.12, 0.3, 0.5, 0.7, 0.88})
            shares.emplace_back(x, 0.55, z);
    View best{{}, {}, fovDeg};
    double most = -1.0;
    for (const Around& around : placesAround(scene, shares)) {
        for (int turn = 0; turn < 16; ++turn) {
            const glm::dmat3 axes = axesFrom(towards(turn * fullTurn / 16.0, 0.1));  // looks down a little
            const double volume = volumeBefore(around, axes, {tanHalf * aspect, tanHalf});
            if (volume <= most) continue;
            most = volume;
            best.eye = around.front().eye;
            best.target = best.eye - 0.25 * diagonalOf(scene) * axes[2];
        }
    }
    return best;
}

}  // namespace

Camera frameScene(const Scene& scene, double aspect) {
    const double fovDeg = fovFor(outsideTanHalf, aspect);
    const std::vector<FirstSurfaces> outside = viewsFromOutside(scene, fovDeg, aspect);
    if (isRoom(scene, outside, closedShare)) {
        const View inside = viewInside(scene, aspect);
        return lookAtRounded(inside.eye, inside.target, inside.fovDeg, diagonalOf(scene));
    }
    const FirstSurfaces& best = bestFromOutside(outside);
    const glm::dvec3 centre = 0.5 * (scene.boundsWorld.min + scene.boundsWorld.max);
    const glm::dvec3 back = best.worldFromView[2];
    return lookAtRounded(best.eye, best.eye - glm::dot(best.eye - centre, back) * back, fovDeg,
                         diagonalOf(scene));
}

bool isOpenRoom(const Scene& scene) {
    return isRoom(scene, viewsFromOutside(scene, fovFor(outsideTanHalf, 1.0), 1.0), openShare);
}

}  // namespace vct
