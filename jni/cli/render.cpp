// vct render: a scene in; pictures, debug views and step timings out.
#include <cstdio>
#include <optional>
#include <set>

#include "cli/backend_option.h"
#include "cli/commands.h"
#include "cli/grid_option.h"
#include "cli/moments.h"
#include "cli/numbers.h"
#include "cli/output.h"
#include "cli/pictures.h"
#include "cli/progress.h"
#include "cli/shader_folder.h"
#include "core/error.h"
#include "core/number_text.h"
#include "engine/renderer.h"
#include "lab/debug_view.h"
#include "lab/options.h"
#include "lab/timings.h"
#include "platform/context.h"
#include "scene/camera.h"
#include "scene/gltf.h"
#include "scene/scene_features.h"

namespace vct::cli {

namespace {

struct RenderOptions {
    std::string scene, timings, animation;
    PictureOptions pictures;
    MomentOptions moments;
    std::string mode = "gi-cone-shadow";
    std::string preset = "thesis";
    std::string size = "400x400";
    std::string camera, light;
    std::string sky = "0,0,0";
    // Over the preset's, where given.
    std::optional<std::string> shadow, specular, voxelization;
    BackendOption backend;
    // Over the preset's, where given.
    GridOption grid;
    std::optional<int> shadowMap, lightFrames;
    std::optional<unsigned> activeVoxels;
    std::optional<float> coneAngleDeg, aoDistance;
    unsigned seedOrder = 0;
    bool revoxelize = false;
    bool lightParts = false;
};

Settings settingsFrom(const RenderOptions& options) {
    Settings settings = presetSettings(options.preset);
    settings.size = sizeFromText(options.size);
    options.grid.applyNumber(settings);
    settings.shadowMapSize = options.shadowMap.value_or(settings.shadowMapSize);
    settings.shadowConeAngleDeg = options.coneAngleDeg.value_or(settings.shadowConeAngleDeg);
    settings.aoDistance = options.aoDistance.value_or(settings.aoDistance);
    if (options.voxelization) settings.voxelization = voxelizationFromText(*options.voxelization);
    if (options.shadow) settings.shadow = shadowFromText(*options.shadow);
    if (options.specular) settings.specular = specularFromText(*options.specular);
    settings.lightFrames = options.lightFrames.value_or(settings.lightFrames);
    settings.skyRadiance = colorFromText("--sky", options.sky);
    settings.revoxelize = options.revoxelize;
    settings.activeVoxelLimit = options.activeVoxels.value_or(settings.activeVoxelLimit);
    validate(settings);
    return settings;
}

// A scene, and a camera and a light as they are at rest, on a renderer.
struct Placed {
    const RenderOptions& options;
    const Settings& settings;
    const Scene& scene;
    Camera camera;
    DirectionalLight light;
    Renderer& renderer;

    // Moves the renderer's scene and light to a moment; returns the camera there.
    Camera moveTo(double seconds) const {
        const Pose pose = poseAt(scene.animation, seconds);
        renderer.setPose(pose);
        renderer.setLightDirection(posed(light, pose).towardsLight);
        return posed(camera, pose);
    }
};

StepTimes timedRun(Renderer& renderer, Mode mode, const Camera& camera) {
    renderer.renderConverged(mode, camera);
    for (int i = 0; i < warmUpFrames; ++i)
        renderer.frame(mode, camera);
    renderer.timer().startRecording();
    for (int i = 0; i < timedFrames; ++i)
        renderer.frame(mode, camera);
    return renderer.timer().stopRecording();
}

// Every mode at one moment, or at rest; returns the files that it made.
std::set<std::string> renderPictures(const Placed& placed, const std::vector<Mode>& modes,
                                     const std::vector<double>& moment, OutputFolder& out,
                                     TimingsReport& report) {
    const RenderOptions& options = placed.options;
    const Settings& settings = placed.settings;
    Renderer& renderer = placed.renderer;
    const Camera camera = moment.empty() ? placed.camera : placed.moveTo(moment.front());
    ExposureCheck checkExposure(options.pictures.exposure);
    Pictures pictures;
    for (Mode mode : modes) {
        const Progress progress(std::string("mode ") + modeName(mode) + ", " +
                                std::to_string(settings.size.x) + "x" + std::to_string(settings.size.y) +
                                ", " + std::to_string(settings.grid) + "^3");
        if (options.timings.empty())
            renderer.renderConverged(mode, camera);
        else
            report.modes.emplace_back(mode, timedRun(renderer, mode, camera));
        report.activeVoxels = renderer.activeVoxels();
        pictures.modes.emplace_back(modeName(mode), renderer.radiance());
        checkExposure(modeName(mode), pictures.modes.back().second);
    }
    report.resources = renderer.resources();
    if (options.lightParts) {
        const Progress progress("light parts");
        for (DebugView& part : lightParts(renderer, camera))
            pictures.lightParts.emplace_back(part.name, std::move(part.image));
    }
    if (options.pictures.debugViews) {
        const Progress progress("debug views");
        pictures.debugViews = debugViews(renderer, camera);
    }
    const Progress progress("writing the pictures");
    return write(pictures, options.pictures, out);
}

// Every mode at each moment, written frame by frame: a sequence may be longer than the memory. With timings
// each frame is one sample; reading it back and writing it is not timed.
std::set<std::string> renderSequence(const Placed& placed, const std::vector<Mode>& modes,
                                     const std::vector<double>& moments, OutputFolder& out,
                                     TimingsReport& report) {
    Renderer& renderer = placed.renderer;
    const bool timed = !placed.options.timings.empty();
    std::set<std::string> made;
    ExposureCheck checkExposure(placed.options.pictures.exposure);
    for (Mode mode : modes) {
        // A camera that comes to a scene whose light is there.
        renderer.renderConverged(mode, placed.moveTo(moments.front()));
        if (timed) {
            for (int i = 0; i < warmUpFrames; ++i)
                renderer.frame(mode, placed.moveTo(moments.front()));
            renderer.timer().startRecording();
        }
        for (std::size_t frame = 0; frame < moments.size(); ++frame) {
            char line[96];
            std::snprintf(line, sizeof line, "mode %s, frame %zu of %zu, %.3f s", modeName(mode), frame + 1,
                          moments.size(), moments[frame]);
            const Progress progress(line);
            renderer.frame(mode, placed.moveTo(moments[frame]));
            report.activeVoxels = renderer.activeVoxels();
            const std::string name = modeName(mode) + frameSuffix(frame);
            const Image image = renderer.radiance();
            writePicture(name, image, placed.options.pictures, out);
            checkExposure(name, image);
            out.keep();
            made.insert({name + ".exr", name + ".png"});
        }
        if (timed) report.modes.emplace_back(mode, renderer.timer().stopRecording());
    }
    report.timedFrames = static_cast<int>(moments.size());
    report.resources = renderer.resources();
    return made;
}

void render(const RenderOptions& options) {
    const std::vector<Mode> modes = modesFromText(options.mode);
    Settings settings = settingsFrom(options);
    const Backend backend = backendFromName(options.backend.name);
    const bool sequence = options.moments.frames.has_value();
    if (sequence && (options.pictures.debugViews || options.lightParts || options.pictures.contactSheet))
        throw Error(
            "--debug-views, --light-parts and --contact-sheet are of one moment; leave out --frames and "
            "--fps, "
            "and choose it by --time");
    // Before anything slow: an output that cannot be written should be known at once.
    OutputFolder out(options.pictures.out);
    if (!options.timings.empty()) requireWritableFile(options.timings);

    Scene scene = loadGltf(options.scene, readFileFromDisk, options.animation);
    for (const std::string& warning : scene.warnings)
        say("warning: " + warning);
    shuffleTriangles(scene, options.seedOrder);
    const std::vector<double> moments = momentsOf(options.moments, scene);
    const Camera camera = cameraFromText(options.camera, scene);
    const DirectionalLight light = lightFromText(options.light, scene);
    if (scene.lights.empty() && options.light.find("direction") == std::string::npos)
        say("warning: the scene has no directional light; one from the upper front right is used (--light)");
    say(options.scene + ": " + std::to_string(scene.triangleCount()) + " triangles, " +
        std::to_string(scene.instances.size()) + " instances");
    if (!scene.animation.channels.empty() && moments.empty())
        say("note: the scene is animated and shown at rest; --time S shows a moment of its " +
            numberText(scene.animation.durationS) + " s, --frames N --fps F a sequence");

    if (settings.specular == Specular::none && featuresOf(scene).glossy)
        say("warning: glossy materials (roughness below 1) are drawn diffuse; --preset mobile and quality "
            "can reflect (--specular cone)");

    const Context context = openContext(backend, options.backend.device);
    context.capabilities.requireAll();
    say(context.capabilities.renderer + ", " + context.capabilities.version);
    options.grid.applyScene(settings, scene, context.capabilities.texturesInMainMemory);
    Renderer renderer(scene, light, settings, context.capabilities, gl::shadersFromFolder(shaderFolder()));

    if (settings.voxels == Voxels::directional)
        say("received light: it stands still after " + std::to_string(settings.lightFrames) +
            " frames (--light-frames)");
    TimingsReport report;
    const Placed placed{options, settings, scene, camera, light, renderer};
    const std::set<std::string> made =
        (sequence ? renderSequence : renderPictures)(placed, modes, moments, out, report);
    nameOlderPictures(made, options.pictures);
    if (!options.timings.empty()) {
        report.scene = options.scene;
        report.triangles = scene.triangleCount();
        report.backend = options.backend.name;
        report.preset = options.preset;
        report.settings = settings;
        writeJson(options.timings, timingsJson(report, context.capabilities));
        std::fputs(timingsTable(report.modes).c_str(), stdout);
        if (!settings.revoxelize && !sequence)
            say("Nothing moved: shadow map (CS) and voxels (V, M) were made once, before these frames; "
                "--revoxelize times them too");
    }
}

constexpr const char* renderFooter =
    "Writes DIR/<mode>.png (sRGB) and DIR/<mode>.exr (linear) for each mode, with --frames "
    "DIR/<mode>_0000.png "
    "and so on.\nOther pictures in DIR stay.\n"
    "Examples:\n"
    "  vct render assets/cornell.glb --out out --mode all --debug-views --timings out/timings.json\n"
    "  vct render my.glb --out out --camera eye=0,1.6,4,target=0,1,0,fov=50 --grid 128\n"
    "  vct render my.glb --out out --light direction=-1,-2,-1,color=1,0.9,0.8,intensity=5\n"
    "  vct render assets/moving.glb --out out --mode gi --preset mobile --time 1.5\n"
    "  vct render assets/moving.glb --out out --mode gi --preset mobile --frames 96 --fps 24";

}  // namespace

void addRender(CLI::App& app, int&) {
    CLI::App* command =
        app.add_subcommand("render", "Render a glTF scene: pictures, debug views, step timings");
    auto options = std::make_shared<RenderOptions>();
    command->footer(renderFooter);
    command->add_option("scene", options->scene, "Scene, .gltf or .glb")->required();
    command->add_option("--out", options->pictures.out, "Folder for the pictures; made if missing")
        ->required();
    command
        ->add_option("--mode", options->mode,
                     "phong, shadow-map, ao, gi, gi-cone-shadow (or 1 to 5), several with commas, or all")
        ->capture_default_str();
    command->add_option("--preset", options->preset, "Set of settings: " + presetList())
        ->capture_default_str();
    options->grid.addTo(*command);
    command->add_option(
        "--voxelization", options->voxelization,
        "What finds the axis along which a triangle is voxelized: geometry-shader, or "
        "sorted-axes (when the scene is loaded, and again for what moves); default: the preset's");
    command->add_option("--size", options->size, "Picture, WIDTHxHEIGHT")->capture_default_str();
    command->add_option("--shadow-map", options->shadowMap, "Texels along a side (default: the preset's)");
    command->add_option("--cone-angle", options->coneAngleDeg,
                        "The sun's full angle for mode 5 in degrees, 0.1 to 170 (default: the preset's)");
    command->add_option("--ao-distance", options->aoDistance,
                        "Reach of ambient occlusion, of the volume's side (default: the preset's)");
    command->add_option("--shadow", options->shadow,
                        "Soft shadow of mode 5: cone (through the voxels) or soft-map (the shadow map, "
                        "filtered as wide as the penumbra); default: the preset's");
    command->add_option(
        "--specular", options->specular,
        "What materials with a roughness below 1 reflect besides diffuse light: none, or cone "
        "(the sun, and one cone along the mirror direction); default: the preset's");
    command->add_option(
        "--light-frames", options->lightFrames,
        "Frames after a change, until what surfaces receive stands still, as a still picture shows "
        "it (default: the preset's)");
    command->add_option("--camera", options->camera,
                        "eye=X,Y,Z,target=X,Y,Z,fov=DEG, or a camera of the scene by name or index "
                        "(default: its first)");
    command->add_option(
        "--light", options->light,
        "direction=X,Y,Z (the way it travels),color=R,G,B,intensity=LUX over the scene's light; "
        "each part may be left out");
    options->moments.addTo(*command);
    command->add_option("--animation", options->animation,
                        "Which of the scene's animations to play, by name or index (default: its first)");
    command->add_option("--sky", options->sky, "Radiance R,G,B of what lies outside the volume")
        ->capture_default_str();
    command->add_option("--exposure", options->pictures.exposure, "Scales the PNGs, never the EXRs")
        ->check(positive)
        ->capture_default_str();
    command->add_flag("--debug-views", options->pictures.debugViews,
                      "Also write every intermediate into DIR/debug_views/");
    command->add_flag(
        "--light-parts", options->lightParts,
        "Also write indirect_light, ambient_occlusion and cone_shadow, each alone, as PNG and EXR");
    command->add_flag("--contact-sheet", options->pictures.contactSheet,
                      "Also write DIR/contact_sheet.png, the modes side by side");
    command->add_option("--timings", options->timings,
                        "Time each step over 5 frames (docs/timings.md) and write FILE.json; "
                        "--revoxelize for those that nothing changes");
    command->add_flag("--revoxelize", options->revoxelize,
                      "Make shadow map and voxels anew in every frame, also where neither light nor pose has "
                      "changed: to measure what that takes");
    options->backend.addTo(*command);
    command
        ->add_option("--active-voxels", options->activeVoxels,
                     "Room in the active-voxel list (default: 16 grid^2)")
        ->check(positive);
    command->add_option("--seed-order", options->seedOrder,
                        "Shuffle the triangles; the result must not change");
    command->callback([options] { render(*options); });
}

}  // namespace vct::cli
