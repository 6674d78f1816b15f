#include "cli/sky_option.h"

#include <cstdio>
#include <memory>

#include "cli/progress.h"
#include "engine/environment.h"
#include "image/environment_file.h"
#include "lab/options.h"
#include "scene/light_choice.h"

namespace vct::cli {

namespace {

std::string radianceText(const glm::vec3& value) {
    char text[96];
    std::snprintf(text, sizeof text, "%.6g,%.6g,%.6g", double{value.r}, double{value.g}, double{value.b});
    return text;
}

std::string sunText(const DirectionalLight& sun) {
    const glm::dvec3 direction = -sun.directionToLight / sun.directionToLight.y;
    char text[160];
    std::snprintf(text, sizeof text, "--light direction=%g,%g,%g,intensity=%.9g", direction.x, direction.y,
                  direction.z, double{sun.intensity});
    return text;
}

}  // namespace

void SkyOption::addTo(CLI::App& command) {
    CLI::Option* sky =
        command.add_option("--sky", radiance,
                           "Sky of one colour: its radiance from all directions outside the scene, "
                           "as R,G,B, as one number, as #rrggbb, or as black, grey, white or "
                           "blue (default: a plain sky where there is a sun, or no light at "
                           "all, which vct then prints; otherwise black)");
    sky->group(lightGroup);
    CLI::Option* behind = command.add_option(
        "--background", background,
        "Radiance behind the scene, written as that of --sky, without effect on its light (default: the sky, "
        "or a part of it if "
        "vct chose the sky and surfaces would vanish in front of it, or a dim sky for a scene with point "
        "lights and no sky)");
    behind->group(lightGroup);
    command
        .add_option(
            "--environment", environment,
            "Sky of a picture, in place of --sky: an equirectangular .hdr or .exr file (twice as wide "
            "as high) of linear radiance. Its centre is towards +X, its top towards +Y, and +Z is "
            "right of the centre. Give a sun of a few pixels as --light instead")
        ->excludes(sky)
        ->excludes(behind)
        ->group(lightGroup);
}

void SkyOption::applyTo(Settings& settings) const {
    if (radiance) settings.skyRadiance = colorFromText("--sky", *radiance);
    if (background) settings.background = colorFromText("--background", *background);
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

void SkyOption::lightScene(const Scene& scene, const Camera& camera, double aspect,
                           const std::string& lightText, DirectionalLight& light, Settings& settings) const {
    const bool hasSun = !scene.lights.empty() || !lightText.empty();
    if (given()) {
        if (!hasSun && scene.punctualLights.empty()) light.intensity = 0.0F;
        return;
    }
    if (!hasSun && !scene.punctualLights.empty()) {
        if (isLitByRoomLight(scene)) return;
        DirectionalLight sun = defaultLight();
        if (light.intensity > 0.0F) sun.intensity = light.intensity;
        if (!background) settings.background = dimSky(sun);
        say("note: the lights of the file are the scene's only light, without a sun and a sky, as with --sky "
            "0,0,0 --background " +
            radianceText(*settings.background) + "; " + sunText(sun) + " --sky " +
            radianceText(plainSky(sun)) + " adds both");
        return;
    }
    const glm::vec3 sky = chooseSky(scene, light);
    if (sky == glm::vec3(0.0F)) return;
    settings.skyRadiance = sky;
    if (!background) settings.background = chooseBackground(scene, camera, aspect, sky);
    const bool contrasts = !background && settings.background != sky;
    say(std::string("note: ") +
        (hasSun ? "the sun comes without a sky; vct adds a plain one, "
         : isInStudio(scene)
             ? "the scene has no light of its own; vct adds a studio, a key light and a soft sky, "
             : "the scene has no light of its own; vct adds a sun and a sky, ") +
        (contrasts ? "and a background against which white surfaces show, " : "") + "as with " +
        (hasSun ? "" : sunText(light) + " ") + "--sky " + radianceText(sky) +
        (contrasts ? " --background " + radianceText(*settings.background) : "") +
        (hasSun ? "; --sky 0,0,0 leaves the sun alone" : ""));
}

}  // namespace vct::cli
