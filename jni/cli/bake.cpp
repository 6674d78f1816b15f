// vct bake: computes the light of a scene, and keeps it in a file for programs that show it at once.
#include <filesystem>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "cli/sky_option.h"
#include "core/number_text.h"
#include "engine/renderer.h"
#include "lab/options.h"
#include "scene/camera.h"

namespace vct::cli {

namespace {

struct BakeOptions {
    SceneOptions scene;
    SkyOption sky;
    std::string preset = defaultPreset, out;
};

void bake(BakeOptions options) {
    if (options.out.empty())
        options.out = std::filesystem::path(options.scene.path).replace_extension(bakedLightExtension);
    Settings settings = options.scene.settings(options.preset);
    options.sky.applyTo(settings);
    validate(settings);
    requireWritableFile(options.out);
    Scene scene = options.scene.load();
    options.scene.fitSize(scene);
    settings.size = options.scene.size;
    const double aspect = aspectOf(settings.size);
    const Camera camera = cameraFromText(options.scene.camera, scene, aspect);
    options.sky.addRoomLight(scene, camera, options.scene.light);
    DirectionalLight sun = lightFromText(options.scene.light, scene);
    options.sky.lightScene(scene, camera, aspect, options.scene.light, sun, settings);

    const Context context = options.scene.backend.open();
    options.scene.fitGrid(settings, scene, context.capabilities);
    Renderer renderer(scene, sun, settings, context.capabilities, shaders());
    renderer.requireBakeable();
    {
        Progress progress("baking the light");
        renderer.render({.outputs = {Output::gi},
                         .camera = camera,
                         .lightSteps = LightSteps::all,
                         .onLightStep = [&progress](int done, int steps) {
                             progress.setPart("step " + std::to_string(done) + " of " +
                                              std::to_string(steps));
                         }});
    }
    if (featuresOf(scene).movingObjects)
        say("note: the light of moving objects is not baked; each run computes it");
    const BakedLight light{lightKey(scene, sun, settings), renderer.bakeLight()};
    const std::vector<std::uint8_t> bytes = bytesOf(light);
    replaceFile(options.out, {bytes.begin(), bytes.end()});
    say("wrote " + options.out + ": the light of " + std::to_string(light.faces.size()) + " faces, " +
        numberText(static_cast<double>(bytes.size()) / 1e6) + " MB");
}

constexpr const char* bakeFooter =
    "The file holds the light of what does not move, for one preset, sun and sky. `vct view` and the app "
    "load it from beside the scene, `vct render` with --baked-light, and programs with "
    "GlobalIllumination::useBakedLight(). It is refused for another scene or other options.\n"
    "Example:\n"
    "  vct bake my.glb      writes my.vctlight";

}  // namespace

void addBake(CLI::App& app, int&) {
    CLI::App* command =
        app.add_subcommand("bake", "Compute the light of a scene and keep it in a file, to show it at once");
    const auto options = std::make_shared<BakeOptions>();
    command->footer(bakeFooter);
    command->add_option("--out", options->out,
                        "File for the light (default: beside the scene, with the ending .vctlight)");
    command->add_option("--preset", options->preset, presetHelp)->capture_default_str();
    options->scene.addTo(*command)->required();
    options->sky.addTo(*command);
    command->callback([options] { bake(*options); });
}

}  // namespace vct::cli
