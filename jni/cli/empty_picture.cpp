#include "cli/empty_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "scene/camera.h"
#include "scene/first_surfaces.h"
#include "scene/framing.h"

namespace vct::cli {
namespace {

bool isEven(const Image& image) {
    constexpr float tolerance = 1e-3F;
    glm::vec3 least(HUGE_VALF), most(0.0F);
    for (const glm::vec3& pixel : image.pixels) {
        least = glm::min(least, pixel);
        most = glm::max(most, pixel);
    }
    return glm::all(glm::lessThanEqual(most - least, tolerance * most));
}

bool hasLight(const Scene& scene, const DirectionalLight& light, const Settings& settings) {
    const auto shows = [](const PunctualLight& other) { return other.intensity > 0.0F; };
    const auto emits = [](const Material& material) { return material.emissive != glm::vec3(0.0F); };
    return (light.intensity > 0.0F && light.color != glm::vec3(0.0F)) ||
           settings.skyRadiance != glm::vec3(0.0F) || settings.environment ||
           std::any_of(scene.punctualLights.begin(), scene.punctualLights.end(), shows) ||
           std::any_of(scene.materials.begin(), scene.materials.end(), emits);
}

// True if a corner of the scene's bounds or their centre is in the picture.
bool isInPicture(const Bounds& bounds, const Camera& camera, double aspect) {
    const glm::dmat4 cameraFromWorld = glm::inverse(camera.worldFromCamera);
    const double tanHalf = std::tan(0.5 * camera.verticalFovRad);
    std::vector<glm::dvec3> points = cornersOf(bounds);
    points.push_back(0.5 * (bounds.min + bounds.max));
    return std::any_of(points.begin(), points.end(), [&](const glm::dvec3& point) {
        const glm::dvec3 p(cameraFromWorld * glm::dvec4(point, 1.0));
        return p.z < 0.0 && std::abs(p.y) < -p.z * tanHalf && std::abs(p.x) < -p.z * tanHalf * aspect;
    });
}

}  // namespace

std::string emptyPictureWarning(const Image& image, const Scene& scene, const Camera& camera,
                                const std::string& cameraText, const DirectionalLight& light,
                                const Settings& settings) {
    if (image.pixels.empty() || !isEven(image)) return "";
    const double aspect = aspectOf(settings.size), tanHalf = std::tan(0.5 * camera.verticalFovRad);
    const std::vector<FirstSurface> samples =
        FirstSurfaces(TriangleTree(scene), glm::dvec3(camera.worldFromCamera[3]),
                      glm::dmat3(camera.worldFromCamera), tanHalf * aspect, tanHalf,
                      std::clamp(std::max(settings.size.x, settings.size.y), 64, 512))
            .samples;
    const auto count = [&](double FirstSurface::* distance) {
        return std::count_if(samples.begin(), samples.end(),
                             [&](const FirstSurface& sample) { return sample.*distance > 0.0; });
    };
    const std::ptrdiff_t seen = count(&FirstSurface::distance);
    const bool black = image.pixels.front() == glm::vec3(0.0F);
    if (!black && seen == static_cast<std::ptrdiff_t>(samples.size())) return "";
    if (black && seen > 0) {
        if (hasLight(scene, light, settings))
            return "warning: the picture is black, because no light reaches the surfaces in it, or they are "
                   "black; choose another --camera, or light with --light and --sky";
        return std::string("warning: the picture is black, because ") +
               (scene.lights.empty() && scene.punctualLights.empty()
                    ? "there is no light"
                    : "all lights of the file have an intensity of 0") +
               "; give light with --light intensity=3 --sky 0.2,0.25,0.35";
    }
    // A camera that was chosen by vct shows the whole scene already.
    const bool isAutomatic = scene.cameras.empty() && cameraText.empty();
    const std::string remedy = isAutomatic ? "choose a view with --camera"
                                           : "a view of the scene is --camera " +
                                                 cameraOption(frameScene(scene, aspect), scene.boundsWorld);
    if (seen == 0 && count(&FirstSurface::backDistance) > 0)
        return "warning: the picture is empty, because only the backs of single-sided surfaces are in front "
               "of "
               "the camera, and these are invisible; " +
               remedy;
    if (seen == 0 && !isInPicture(scene.boundsWorld, camera, aspect))
        return "warning: the picture is empty, because the camera sees nothing of the scene; " + remedy;
    const glm::dvec3 size = scene.boundsWorld.max - scene.boundsWorld.min;
    char text[320];
    std::snprintf(
        text, sizeof text,
        "warning: the picture is empty, because nothing in it is larger than a pixel or differs from the "
        "background; the scene has %.3g x %.3g x %.3g m, so perhaps one of its objects is far from the "
        "others; choose a --camera near an object",
        size.x, size.y, size.z);
    return text;
}

}  // namespace vct::cli
