#include "cli/sky_option.h"

#include <cstdio>
#include <memory>

#include "cli/progress.h"
#include "engine/environment.h"
#include "image/environment_file.h"
#include "lab/options.h"
#include "scene/light_choice.h"

namespace vct::cli {

void SkyOption::addTo(CLI::App& command) {
    CLI::Option* sky = command.add_option("--sky", radiance,
                                          "Sky of one colour: radiance R,G,B from all directions outside the "
                                          "scene (default: black, or a plain sky if neither the scene nor an "
                                          "option has a light, which vct then prints)");
    sky->group(lightGroup);
    command
        .add_option(
            "--environment", environment,
            "Sky of a picture, in place of --sky: an equirectangular .hdr or .exr file (twice as wide "
            "as high) of linear radiance. Its centre is towards +X, its top towards +Y, and +Z is "
            "right of the centre. Give a sun of a few pixels as --light instead")
        ->excludes(sky)
        ->group(lightGroup);
}

void SkyOption::applyTo(Settings& settings) const {
    if (radiance) settings.skyRadiance = colorFromText("--sky", *radiance);
    if (!environment.empty())
        settings.environment =
            std::make_shared<const Environment>(readEnvironment(environment), "'" + environment + "'");
}

void SkyOption::addRoomLight(Scene& scene, const Camera& camera, const std::string& lightText) const {
    if (given() || !lightText.empty()) return;
    const std::optional<PunctualLight> light = chooseRoomLight(scene, camera);
    if (!light) return;
    scene.punctualLights.push_back(*light);
    say(roomLightNote(*light) + ". --light or --sky lights the scene from outside instead");
}

void SkyOption::lightScene(const Scene& scene, const std::string& lightText, DirectionalLight& light,
                           Settings& settings) const {
    if (!scene.lights.empty() || !scene.punctualLights.empty() || !lightText.empty()) return;
    if (given()) {
        light.intensity = 0.0F;
        return;
    }
    const glm::vec3 sky = chooseSky(scene);
    if (sky == glm::vec3(0.0F)) return;
    settings.skyRadiance = sky;
    const glm::dvec3 direction = -light.directionToLight / light.directionToLight.y;
    char text[320];
    std::snprintf(text, sizeof text,
                  "note: the scene has no light of its own; vct adds a sun and a sky, as with --light "
                  "direction=%g,%g,%g,intensity=%.9g --sky %g,%g,%g",
                  direction.x, direction.y, direction.z, double{light.intensity}, double{sky.r},
                  double{sky.g}, double{sky.b});
    say(text);
}

}  // namespace vct::cli
