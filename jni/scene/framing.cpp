#include "scene/framing.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "scene/camera.h"
#include "scene/first_surfaces.h"
#include "scene/light_choice.h"
#include "scene/lit_surfaces.h"
#include "scene/subject.h"

namespace vct {
namespace {

constexpr double fullTurn = 6.283185307179586;

// Tangents of half the field of view of a square picture. Another aspect ratio gets the same area at
// distance 1.
constexpr double outsideTanHalf = 0.364;     // 40 degrees
constexpr double insideTanHalf = 0.7;        // 70 degrees
constexpr double widestFramedTanHalf = 1.2;  // 100 degrees
constexpr double margin = 0.04;              // free at each side, in shares of half the picture

constexpr int outsideResolution = 96, aroundResolution = 12;
// Smallest share of all directions in which a closed room has a surface, seen from a point inside. A box of 4
// x 2 x 4 m that is open at the front has 90 %, a room of 4 x 5 x 2.7 m with a window 98 %.
constexpr double closedShare = 0.96;
// The same share for a room that is open at a side. A field under the sky has half.
constexpr double openShare = 0.6;
// A room whose walls hide its inside is closed in these shares of all directions, on average over several
// places: it has a window or a door, but no open side.
constexpr double windowedShares[] = {0.9, 0.998};
constexpr double minRoomSize = 1.9;     // metres: smaller ones are containers
constexpr double windowedVolume = 0.5;  // smallest visible volume inside such a room, in shares of the bounds
constexpr double roomShare = 0.1;    // smallest visible volume inside a room, in shares of the bounds' volume
constexpr double muchMore = 1.5;     // another side must show so many times the surface seen from the front
constexpr double fromBelow = 0.67;   // weight of views from below, because objects rarely stand on glass
constexpr double unlitWeight = 0.1;  // weight of surfaces that no light of the scene reaches
// A view from outside with a smaller share of lit surface than this is dark.
constexpr double darkShare = 0.18;

// A closed room with a smaller share of lit surface than this is dark; samples may seem lit by mistake.
constexpr double minLitInside = 0.05;

struct View {
    glm::dvec3 eye;
    glm::dvec3 target;
    double fovDeg;    // vertical
    double litShare;  // share of the visible surfaces that light reaches
};

double extentOf(const Bounds& bounds) {
    const double diagonal = glm::length(bounds.max - bounds.min);
    return diagonal > 0.0 && std::isfinite(diagonal) ? diagonal : 1.0;
}

// Vertical field of view in degrees, rounded to tenths, so that the text of the camera is short.
double fovFor(double tanHalfSquare, double aspect) {
    const double tanHalf = std::min(tanHalfSquare / std::sqrt(aspect), widestFramedTanHalf);
    return std::max(std::round(10.0 * glm::degrees(2.0 * std::atan(tanHalf))), 1.0) / 10.0;
}

// Axes of a camera (columns: right, up, back) whose eye lies in this direction from its target.
glm::dmat3 axesFrom(const glm::dvec3& directionToEye) {
    const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), directionToEye));
    return {right, glm::cross(directionToEye, right), directionToEye};
}

glm::dvec3 towards(double azimuthRad, double heightOverWidth) {
    return glm::normalize(glm::dvec3(std::sin(azimuthRad), heightOverWidth, std::cos(azimuthRad)));
}

// Finds how far a scene extends beyond the four side planes of a view whose eye is at the centre of the
// scene's bounds.
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
    // The nearest eye position, relative to the centre of the bounds, from which the whole scene is between
    // the planes.
    glm::dvec3 eye() const {
        const glm::dvec2 back = 0.5 * (upper + lower) / tanHalf;
        return axes * glm::dvec3(0.5 * (upper - lower), std::max(back.x, back.y));
    }
};

void includeSubject(const Scene& scene, const Subject& subject, std::vector<Reach>& reaches) {
    const glm::dvec3 centre = 0.5 * (subject.boundsWorld.min + subject.boundsWorld.max);
    const auto include = [&](const glm::dvec3& world) {
        for (Reach& reach : reaches)
            reach.include(world - centre);
    };
    const auto moves = [](const Instance& instance) { return instance.moves(); };
    // The vertices of moving objects are those of the rest pose, but the bounds contain all poses.
    if (scene.instances.empty() || std::any_of(scene.instances.begin(), scene.instances.end(), moves)) {
        for (const glm::dvec3& corner : cornersOf(subject.boundsWorld))
            include(corner);
        return;
    }
    for (std::size_t number = 0; number < scene.instances.size(); ++number) {
        if (subject.isGround[number]) continue;
        const Instance& instance = scene.instances[number];
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

// Views of the whole subject from outside; the first one is the default.
std::vector<FirstSurfaces> viewsFromOutside(const Scene& scene, const TriangleTree& tree,
                                            const Subject& subject, double fovDeg, double aspect) {
    std::vector<Reach> reaches;
    const glm::dvec3 usual = glm::normalize(glm::dvec3(0.3, 0.5, 1.0));
    const double tanHalf = (1.0 - margin) * std::tan(0.5 * glm::radians(fovDeg));
    for (const double height : {0.48, -0.48})
        for (int turn = 0; turn < 8; ++turn)
            reaches.push_back(
                {axesFrom(towards(std::atan2(usual.x, usual.z) + turn * fullTurn / 8.0, height)),
                 {tanHalf * aspect, tanHalf}});
    reaches.front().axes = axesFrom(usual);
    includeSubject(scene, subject, reaches);
    const glm::dvec3 centre = 0.5 * (subject.boundsWorld.min + subject.boundsWorld.max);
    std::vector<FirstSurfaces> views;
    for (const Reach& reach : reaches) {
        // A point, or a line towards the eye, has no width, so its distance must be limited separately.
        glm::dvec3 eye = reach.eye();
        const double least = reach.highest + 1e-3 * extentOf(subject.boundsWorld);
        eye += std::max(least - glm::dot(eye, reach.axes[2]), 0.0) * reach.axes[2];
        views.emplace_back(tree, centre + eye, reach.axes, tanHalf * aspect, tanHalf, outsideResolution);
    }
    return views;
}

// True if the scene's light reaches the surface of this sample. In a scene without a light of its own,
// vct's sun and sky reach all surfaces that are seen from outside.
bool isLit(const LitSurfaces& light, const FirstSurfaces& view, std::size_t sample) {
    return !light.exists() || light.reaches(view.position(sample), view.samples[sample]);
}

// Share of the visible surfaces that light reaches.
double litShare(const FirstSurfaces& view, const LitSurfaces& light) {
    int met = 0, lit = 0;
    for (std::size_t i = 0; i < view.samples.size(); ++i) {
        if (view.samples[i].distance == 0.0) continue;
        ++met;
        lit += isLit(light, view, i);
    }
    return met > 0 ? static_cast<double>(lit) / met : 0.0;
}

// Visible surface area in square metres. Surfaces at grazing angles and unlit ones count less than their
// area.
double areaSeen(const FirstSurfaces& view, const LitSurfaces& light) {
    double area = 0.0;
    for (std::size_t i = 0; i < view.samples.size(); ++i) {
        const FirstSurface& sample = view.samples[i];
        if (sample.distance == 0.0) continue;
        const glm::dvec3 d = sample.distance * view.direction(i);
        const double cosine = -glm::dot(sample.normal, d) / glm::length(d);
        area += glm::dot(d, d) * view.solidAngle(i) / std::max(cosine, 0.5) *
                (isLit(light, view, i) ? 1.0 : unlitWeight);
    }
    return area;
}

const FirstSurfaces& bestFromOutside(const std::vector<FirstSurfaces>& views, const LitSurfaces& light) {
    std::size_t best = 0;
    double most = muchMore * areaSeen(views[0], light);
    for (std::size_t i = 1; i < views.size(); ++i) {
        const double area = areaSeen(views[i], light) * (i < views.size() / 2 ? 1.0 : fromBelow);
        if (area <= most) continue;
        best = i;
        most = area;
    }
    return views[best];
}

// The surfaces seen from a point in all directions.
using Around = std::vector<FirstSurfaces>;

struct Enclosure {
    double closed = 0.0;  // share of all directions that have a surface
    double solid = 0.0;   // share of all directions whose first side is a back; most, inside an object
    double volume = 0.0;  // volume between the point and the surfaces

    bool isInsideAnObject() const { return solid > 0.5; }
};

Enclosure enclosureOf(const Around& around) {
    Enclosure enclosure;
    for (const FirstSurfaces& view : around) {
        for (std::size_t i = 0; i < view.samples.size(); ++i) {
            const FirstSurface& sample = view.samples[i];
            const double share = view.solidAngle(i) / (2.0 * fullTurn);
            if (sample.backDistance > 0.0) enclosure.solid += share;
            if (sample.distance == 0.0) continue;
            const double distance = sample.distance * glm::length(view.direction(i));
            enclosure.closed += share;
            enclosure.volume += view.solidAngle(i) * distance * distance * distance / 3.0;
        }
    }
    return enclosure;
}

// True if most surfaces seen from outside face away from a point inside: walls that hide a room, or the
// outside of a bottle.
bool hidesItsInside(const FirstSurfaces& outside, const glm::dvec3& inside) {
    int met = 0, hiding = 0;
    for (std::size_t i = 0; i < outside.samples.size(); ++i) {
        const FirstSurface& sample = outside.samples[i];
        if (sample.distance == 0.0) continue;
        ++met;
        if (glm::dot(sample.normal, inside - outside.position(i)) < 0.0) ++hiding;
    }
    return 2 * hiding > met;
}

std::size_t thingsSeen(const std::vector<FirstSurfaces>& views) {
    std::set<int> instances;
    for (const FirstSurfaces& view : views)
        for (const FirstSurface& sample : view.samples)
            if (sample.instance >= 0) instances.insert(sample.instance);
    return instances.size();
}

std::vector<Around> placesAround(const Scene& scene, const TriangleTree& tree,
                                 const std::vector<glm::dvec3>& sharesOfBounds) {
    std::vector<Around> places;
    for (const glm::dvec3& share : sharesOfBounds)
        places.push_back(viewsAround(tree, glm::mix(scene.boundsWorld.min, scene.boundsWorld.max, share),
                                     aroundResolution));
    return places;
}

// Several points are tested, because the centre may be inside a column, and a column in front of an opening
// may make one point look enclosed.
const std::vector<glm::dvec3> roomPoints{
    {0.5, 0.5, 0.5}, {0.25, 0.5, 0.25}, {0.75, 0.5, 0.25}, {0.25, 0.5, 0.75}, {0.75, 0.5, 0.75}};

// True if the scene is a room: it is closed in at least this share of all directions, and either its surfaces
// seen from outside do not hide the inside, or more objects are visible from inside than from outside.
bool isRoom(const Scene& scene, const TriangleTree& tree, const std::vector<FirstSurfaces>& outside,
            double minClosed) {
    const glm::dvec3 size = scene.boundsWorld.max - scene.boundsWorld.min;
    const std::vector<Around> places = placesAround(scene, tree, roomPoints);
    const Around* widest = nullptr;
    double most = roomShare * size.x * size.y * size.z;
    for (const Around& around : places) {
        const Enclosure enclosure = enclosureOf(around);
        if (enclosure.isInsideAnObject() || enclosure.volume < roomShare * size.x * size.y * size.z) continue;
        if (enclosure.closed < minClosed) return false;
        if (enclosure.volume < most) continue;
        most = enclosure.volume;
        widest = &around;
    }
    if (widest == nullptr) return false;
    return !hidesItsInside(outside.front(), widest->front().eye) || thingsSeen(*widest) > thingsSeen(outside);
}

// True if the scene is a room with windows or a door whose walls hide its inside.
bool isWindowedRoom(const Scene& scene, const TriangleTree& tree, const FirstSurfaces& outside) {
    const glm::dvec3 size = scene.boundsWorld.max - scene.boundsWorld.min;
    if (std::min({size.x, size.y, size.z}) < minRoomSize) return false;
    double closed = 0.0, most = 0.0;
    int free = 0;
    for (const Around& around : placesAround(scene, tree, roomPoints)) {
        const Enclosure enclosure = enclosureOf(around);
        if (enclosure.isInsideAnObject()) continue;
        closed += enclosure.closed;
        most = std::max(most, enclosure.volume);
        ++free;
    }
    return closed > windowedShares[0] * free && closed < windowedShares[1] * free &&
           most > windowedVolume * size.x * size.y * size.z &&
           hidesItsInside(outside, 0.5 * (scene.boundsWorld.min + scene.boundsWorld.max));
}

// The surfaces in a view from inside.
struct Prospect {
    double volume = 0.0;          // cubic metres: three times the visible volume; unlit surfaces count less
    double met = 0.0, lit = 0.0;  // solid angle of all surfaces, and of those that light reaches
};

// `lit` has a value per sample of all views.
Prospect prospectOf(const Around& around, const std::vector<bool>& lit, const glm::dmat3& axes,
                    const glm::dvec2& tanHalf) {
    const glm::dmat3 viewFromWorld = glm::transpose(axes);
    Prospect prospect;
    std::size_t number = 0;
    for (const FirstSurfaces& view : around) {
        for (std::size_t i = 0; i < view.samples.size(); ++i) {
            const bool sampleIsLit = lit[number++];
            const glm::dvec3 d = view.direction(i), p = viewFromWorld * d;
            if (p.z >= 0.0 || std::abs(p.x) > -p.z * tanHalf.x || std::abs(p.y) > -p.z * tanHalf.y) continue;
            if (view.samples[i].distance == 0.0) continue;
            const double solidAngle = view.solidAngle(i);
            prospect.met += solidAngle;
            if (sampleIsLit) prospect.lit += solidAngle;
            prospect.volume += std::pow(view.samples[i].distance * glm::length(d), 3.0) * solidAngle *
                               (sampleIsLit ? 1.0 : unlitWeight);
        }
    }
    return prospect;
}

// The view of the most volume, from a place that is closed in at least this share of all directions and not
// inside an object.
std::optional<View> viewInside(const Scene& scene, const TriangleTree& tree, double aspect,
                               const LitSurfaces& light, double minClosed) {
    const double fovDeg = fovFor(insideTanHalf, aspect);
    const double tanHalf = std::tan(0.5 * glm::radians(fovDeg));
    std::vector<glm::dvec3> shares;
    for (const double x : {0.12, 0.3, 0.5, 0.7, 0.88})
        for (const double z : {0.12, 0.3, 0.5, 0.7, 0.88})
            shares.emplace_back(x, 0.55, z);
    std::optional<View> best;
    double most = 0.0;
    for (const Around& around : placesAround(scene, tree, shares)) {
        const Enclosure enclosure = enclosureOf(around);
        if (enclosure.isInsideAnObject() || enclosure.closed < minClosed) continue;
        std::vector<bool> lit;
        for (const FirstSurfaces& view : around)
            for (std::size_t i = 0; i < view.samples.size(); ++i)
                lit.push_back(isLit(light, view, i));
        for (int turn = 0; turn < 16; ++turn) {
            const glm::dmat3 axes = axesFrom(towards(turn * fullTurn / 16.0, 0.1));  // slightly downwards
            const Prospect prospect = prospectOf(around, lit, axes, {tanHalf * aspect, tanHalf});
            if (prospect.volume <= most) continue;
            most = prospect.volume;
            const glm::dvec3 eye = around.front().eye;
            best = {eye, eye - 0.25 * extentOf(scene.boundsWorld) * axes[2], fovDeg,
                    prospect.lit / prospect.met};
        }
    }
    return best;
}

}  // namespace

Camera frameScene(const Scene& scene, double aspect) {
    const double fovDeg = fovFor(outsideTanHalf, aspect);
    const Subject subject = subjectOf(scene);
    const TriangleTree tree(scene);
    const std::vector<FirstSurfaces> outside = viewsFromOutside(scene, tree, subject, fovDeg, aspect);
    const LitSurfaces light(scene, tree, isLitByEmitters(scene));
    const FirstSurfaces& best = bestFromOutside(outside, light);
    // A lamp behind walls with a window does not light their outside.
    const double lit = litShare(best, light);
    const bool closed =
        isRoom(scene, tree, outside, closedShare) || (!light.exists() && isWindowedRoom(scene, tree, best));
    if (closed || lit < darkShare) {
        const std::optional<View> inside = viewInside(scene, tree, aspect, light, closed ? 0.0 : openShare);
        if (inside && inside->litShare > (closed ? minLitInside : lit))
            return lookAtRounded(inside->eye, inside->target, inside->fovDeg, extentOf(scene.boundsWorld));
    }
    const glm::dvec3 centre = 0.5 * (subject.boundsWorld.min + subject.boundsWorld.max);
    const glm::dvec3 back = best.worldFromView[2];
    return lookAtRounded(best.eye, best.eye - glm::dot(best.eye - centre, back) * back, fovDeg,
                         extentOf(subject.boundsWorld));
}

bool isOpenRoom(const Scene& scene) {
    const TriangleTree tree(scene);
    return isRoom(scene, tree,
                  viewsFromOutside(scene, tree, subjectOf(scene), fovFor(outsideTanHalf, 1.0), 1.0),
                  openShare);
}

}  // namespace vct
