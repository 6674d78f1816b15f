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
                                          "Radiance R,G,B of what lies outside the scene, in all directions "
                                          "(default: black; of a scene without any "
                                          "light a plain sky, which is said)");
    command
        .add_option("--environment", environment,
                    "Picture of all directions outside the scene, in place of --sky: .hdr or .exr, "
                    "equirectangular (twice as wide as high), of linear radiance. Its centre is towards +X, "
                    "its top +Y, right of the centre +Z. A sun of a few pixels is better given as --light")
        ->excludes(sky);
}

void SkyOption::applyTo(Settings& settings) const {
    if (radiance) settings.skyRadiance = colorFromText("--sky", *radiance);
    if (!environment.empty())
        settings.environment =
            std::make_shared<const Environment>(readEnvironment(environment), "'" + environment + "'");
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
    std::snprintf(
        text, sizeof text,
        "note: the scene has no light of its own; it is lit by a sun and a plain sky, as with --light "
        "direction=%g,%g,%g,intensity=%.9g --sky %g,%g,%g",
        direction.x, direction.y, direction.z, double{light.intensity}, double{sky.r}, double{sky.g},
        double{sky.b});
    say(text);
}

}  // namespace vct::cli
