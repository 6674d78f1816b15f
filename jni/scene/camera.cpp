#include "scene/camera.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>

#include "core/error.h"
#include "core/number_text.h"
#include "scene/framing.h"

namespace vct {
namespace {

// Objects nearer to a camera than this share of the distance to its target may be cut off.
constexpr double nearestOfDistance = 1.0 / 50.0;
constexpr double widestTanHalf = 11.43;  // limit of fitted(): 170 degrees

std::string printed(const glm::dvec3& v) {
    char text[128];
    std::snprintf(text, sizeof text, "%.12g,%.12g,%.12g", v.x, v.y, v.z);
    return text;
}

// Rounds a number as printing it in an option and reading it back does.
double read(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.12g", value);
    return std::strtod(text, nullptr);
}

// Rounds to whole multiples of a step, so that a --camera option needs few digits and reproduces the camera
// exactly.
glm::dvec3 rounded(const glm::dvec3& v, double step) {
    const glm::dvec3 multiple = glm::round(v / step) * step + 0.0;
    return {read(multiple.x), read(multiple.y), read(multiple.z)};
}

std::string cameraList(const Scene& scene) {
    std::string list;
    for (std::size_t i = 0; i < scene.cameras.size(); ++i)
        list += (i == 0 ? "" : ", ") + std::to_string(i) + " \"" + scene.cameras[i].name + "\"";
    return list;
}

double distanceTo(const Bounds& bounds, const glm::dvec3& p) {
    return glm::length(glm::max(glm::max(bounds.min - p, p - bounds.max), glm::dvec3(0.0)));
}

double diagonalOf(const Bounds& bounds) {
    return std::max(glm::length(bounds.max - bounds.min), 1e-30);
}

// Moves a camera or a light (`world`) to its node. If the node's scale is 0 and it has no axes, the axes of
// `world` stay.
void follow(glm::dmat4& world, const Pose& pose, int node) {
    const glm::dmat4& worldFromNode = pose.worldFromNode.at(static_cast<std::size_t>(node));
    const std::optional<glm::dmat4> axes = withoutScale(worldFromNode);
    if (axes) world = *axes;
    world[3] = worldFromNode[3];
}

}  // namespace

Camera lookAt(const glm::dvec3& eye, const glm::dvec3& target, double verticalFovDeg,
              const std::optional<glm::dvec3>& upwards) {
    if (!(verticalFovDeg > 0.0 && verticalFovDeg < 180.0))
        throw Error("the camera's field of view is " + numberText(verticalFovDeg) +
                    " degrees; give a value between 0 and 180");
    const glm::dvec3 back = eye - target;
    const double distance = glm::length(back);
    if (!(distance > 0.0) || !std::isfinite(distance))
        throw Error("the camera's eye and target (" + printed(eye) + " and " + printed(target) +
                    ") define no direction; give two different points");
    const glm::dvec3 z = back / distance;
    const bool vertical = std::abs(z.y) > 1.0 - 1e-12;  // to about a millionth of a radian
    const glm::dvec3 up = upwards.value_or(vertical ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, 1.0, 0.0));
    const glm::dvec3 right = glm::cross(up, z);
    if (!(glm::length(right) > 1e-9 * glm::length(up)))
        throw Error("the camera's up (" + printed(up) +
                    ") is parallel to its view direction; give another, or leave it out");
    const glm::dvec3 x = glm::normalize(right);

    Camera camera;
    camera.nearest = nearestOfDistance * distance;
    camera.worldFromCamera = glm::dmat4(glm::dvec4(x, 0.0), glm::dvec4(glm::cross(z, x), 0.0),
                                        glm::dvec4(z, 0.0), glm::dvec4(eye, 1.0));
    camera.verticalFovRad = glm::radians(verticalFovDeg);
    return camera;
}

Camera lookAtRounded(const glm::dvec3& eye, const glm::dvec3& target, double verticalFovDeg, double size) {
    const double step = std::pow(10.0, std::floor(std::log10(size)) - 3.0);
    return lookAt(rounded(eye, step), rounded(target, step), verticalFovDeg);
}

std::string cameraOption(const Camera& camera, const Bounds& bounds) {
    const glm::dvec3 eye(camera.worldFromCamera[3]), back(camera.worldFromCamera[2]);
    const double diagonal = std::max(glm::length(bounds.max - bounds.min), 1e-9);
    // clipFromWorld() does not distinguish nearest distances of more than a part of the diagonal.
    const double distance = std::isfinite(camera.nearest)
                                ? std::min(camera.nearest / nearestOfDistance, 1e3 * diagonal)
                                : diagonal;
    const glm::dvec3 target = eye - distance * back;
    if (target == eye)
        throw Error("camera \"" + camera.name + "\" is too far from the origin (" + printed(eye) +
                    ") to be written as an option; move it nearer");
    // The subtraction leaves rounding noise in the target (-1e-17 instead of 0), which is set to 0.
    const double noise = 1e-14 * (glm::length(eye) + distance);
    const auto tidy = [&](double value) { return std::abs(value) < noise ? 0.0 : value; };
    char fov[32];
    std::snprintf(fov, sizeof fov, "%.12g", glm::degrees(camera.verticalFovRad));
    std::string text = "eye=" + printed(eye) +
                       ",target=" + printed({tidy(target.x), tidy(target.y), tidy(target.z)}) + ",fov=" + fov;
    const glm::dvec3 up(camera.worldFromCamera[1]);
    const Camera level = lookAt(eye, target, 40.0);
    if (glm::distance(glm::dvec3(level.worldFromCamera[1]), up) > 1e-9) text += ",up=" + printed(up);
    return text;
}

Camera fitted(Camera camera, double aspect) {
    if (!camera.aspectRatio || aspect >= *camera.aspectRatio) return camera;
    const double tanHalf = std::tan(0.5 * camera.verticalFovRad);
    const double wider = std::min(tanHalf * *camera.aspectRatio / aspect, std::max(tanHalf, widestTanHalf));
    camera.verticalFovRad = 2.0 * std::atan(wider);
    return camera;
}

Camera chooseCamera(const Scene& scene, const std::string& nameOrIndex, double aspect) {
    if (scene.cameras.empty() && nameOrIndex.empty()) {
        try {
            return frameScene(scene, aspect);
        } catch (const Error&) {
            throw Error("cannot frame the scene " + scene.path +
                        ": it is too far from the origin for its size (" + printed(scene.boundsWorld.min) +
                        " to " + printed(scene.boundsWorld.max) + "); move it nearer to the origin");
        }
    }
    if (scene.cameras.empty())
        throw Error("the scene " + scene.path + " has no camera, and \"" + nameOrIndex +
                    "\" was asked for; leave out --camera for a view of the whole scene");
    if (nameOrIndex.empty()) return fitted(scene.cameras.front(), aspect);
    for (const Camera& camera : scene.cameras) {
        if (camera.name == nameOrIndex) return fitted(camera, aspect);
    }
    const bool isNumber = nameOrIndex.size() <= 9 && std::all_of(nameOrIndex.begin(), nameOrIndex.end(),
                                                                 [](char c) { return c >= '0' && c <= '9'; });
    const std::size_t index = isNumber ? std::stoul(nameOrIndex) : scene.cameras.size();
    if (index >= scene.cameras.size())
        throw Error("the scene " + scene.path + " has no camera \"" + nameOrIndex + "\"; choose one of " +
                    cameraList(scene));
    return fitted(scene.cameras[index], aspect);
}

std::string cameraNote(const Scene& scene, const std::string& option, const Camera& camera, double aspect) {
    if (option.find('=') != std::string::npos) return "";
    if (scene.cameras.empty())
        return "the scene has no camera: seen by --camera " + cameraOption(camera, scene.boundsWorld);
    if (!camera.aspectRatio || std::abs(*camera.aspectRatio / aspect - 1.0) < 0.01) return "";
    return "camera \"" + camera.name + "\" is made for pictures " + numberText(*camera.aspectRatio) +
           " times as wide as high, and this one is " + numberText(aspect) + " times: it shows more " +
           (aspect < *camera.aspectRatio ? "above and below" : "at its sides");
}

Camera posed(Camera camera, const Pose& pose) {
    if (camera.node < 0) return camera;
    follow(camera.worldFromCamera, pose, camera.node);
    camera.worldFromCamera[3] += camera.setBack * camera.worldFromCamera[2];
    return camera;
}

DirectionalLight posed(DirectionalLight light, const Pose& pose) {
    if (light.node < 0) return light;
    const glm::dvec3 back(pose.worldFromNode.at(static_cast<std::size_t>(light.node))[2]);
    const double length = glm::length(back);
    if (length > 0.0) light.directionToLight = back / length;
    return light;
}

PunctualLight posed(PunctualLight light, const Pose& pose) {
    if (light.node < 0) return light;
    follow(light.worldFromLight, pose, light.node);
    return light;
}

double usualNearPlane(const Bounds& bounds) {
    return 1e-3 * diagonalOf(bounds);
}

glm::dmat4 clipFromWorld(const Camera& camera, const Bounds& bounds, double aspect, const Bounds& visible) {
    if (camera.clipFromWorld) return *camera.clipFromWorld;
    const glm::dmat3 worldFromCameraAxes(camera.worldFromCamera);
    const glm::dvec3 eye(camera.worldFromCamera[3]);
    const glm::dmat3 cameraFromWorldAxes = glm::transpose(worldFromCameraAxes);
    const glm::dmat4 cameraFromWorld =
        glm::dmat4(cameraFromWorldAxes) * glm::translate(glm::dmat4(1.0), -eye);

    const double diagonal = diagonalOf(bounds);
    double farthest = 0.0;  // along the view axis
    for (const glm::dvec3& corner : cornersOf(visible))
        farthest = std::max(farthest, -(cameraFromWorldAxes * (corner - eye)).z);

    // A point at distance d in a corner of the picture has a depth of only d cos(corner angle).
    const double tanHalf = std::tan(0.5 * camera.verticalFovRad);
    const double cosCorner = 1.0 / std::sqrt(1.0 + tanHalf * tanHalf * (1.0 + aspect * aspect));
    // Float precision does not allow a near plane below a ten-millionth of the scene's size.
    const double nearest = std::max(std::min(usualNearPlane(bounds), camera.nearest), 1e-7 * diagonal);
    const double near = std::max(std::min(0.5, 0.99 * cosCorner) * distanceTo(visible, eye), nearest);
    // At a million diagonals the scene is smaller than a pixel, and larger distances exceed float precision.
    farthest = std::min(farthest, 1e6 * diagonal);
    // The far plane must lie beyond the near plane even if the camera looks away from the scene.
    const double far = std::max(1.001 * farthest + 1e-3 * diagonal, 2.0 * near);
    return glm::perspectiveRH_NO(camera.verticalFovRad, aspect, near, far) * cameraFromWorld;
}

}  // namespace vct
