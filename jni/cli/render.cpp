// vct render: a scene in; pictures, debug views and step timings out.
#include <cstdio>
#include <optional>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/pictures.h"
#include "cli/progress.h"
#include "cli/sky_option.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/number_text.h"
#include "engine/directional/gather_schedule.h"
#include "engine/renderer.h"
#include "lab/debug_view.h"
#include "lab/options.h"
#include "lab/timings.h"
#include "scene/camera.h"
#include "scene/gltf.h"
#include "scene/scene_features.h"

namespace vct::cli {

namespace {

struct RenderOptions {
    SceneOptions scene;
    std::string out, timings, animation;
    std::string mode = "gi-cone-shadow";
    std::string preset = defaultPreset;
    std::string toneMap = "neutral";
    SkyOption sky;
    // Over the preset's, where given.
    std::optional<std::string> shadow, specular;
    std::optional<int> shadowMap, lightFrames;
    std::optional<unsigned> activeVoxels;
    std::optional<float> coneAngleDeg;
    float lightRadius = 0.0F;
    float emission = 1.0F;
    // Which moments of an animated scene.
    std::optional<double> timeS, fps;
    std::optional<int> frames;
    std::string exposure = "auto";  // of PNGs; or a number
    int samples = 1;                // per pixel, of pictures of one moment
    unsigned seedOrder = 0;
    bool revoxelize = false, debugViews = false, lightParts = false, contactSheet = false;
};

Settings settingsFrom(const RenderOptions& options) {
    Settings settings = options.scene.settings(options.preset);
    settings.shadowMapSize = options.shadowMap.value_or(settings.shadowMapSize);
    settings.shadowConeAngleDeg = options.coneAngleDeg.value_or(settings.shadowConeAngleDeg);
    settings.lightRadius = options.lightRadius;
    if (options.shadow) settings.shadow = parsed("--shadow", shadowFromText, *options.shadow);
    if (options.specular) settings.specular = parsed("--specular", specularFromText, *options.specular);
    settings.lightFrames = options.lightFrames.value_or(settings.lightFrames);
    options.sky.applyTo(settings);
    settings.revoxelize = options.revoxelize;
    settings.activeVoxelLimit = options.activeVoxels.value_or(settings.activeVoxelLimit);
    validate(settings);
    return settings;
}

// Seconds, one per frame. Empty: the scene at rest, one frame.
std::vector<double> momentsOf(const RenderOptions& options, const Scene& scene) {
    if (!options.timeS && !options.frames) return {};
    if (scene.animation.channels.empty())
        throw Error("the scene " + scene.path +
                    " has no animation of its nodes, so it looks the same at all times; leave out --time, "
                    "--frames and --fps");
    std::vector<double> moments;
    for (int frame = 0; frame < options.frames.value_or(1); ++frame)
        moments.push_back(options.timeS.value_or(0.0) + (frame == 0 ? 0.0 : frame / *options.fps));
    return moments;
}

// A scene, and a camera and a light as they are at rest, on a renderer.
struct Placed {
    const RenderOptions& options;
    const Scene& scene;
    Camera camera;
    DirectionalLight light;
    Renderer& renderer;

    // Moves the renderer's scene and light to a moment; returns the camera there.
    Camera moveTo(double seconds) const {
        const Pose pose = poseAt(scene.animation, seconds);
        renderer.setPose(pose);
        renderer.setLightDirection(posed(light, pose).directionToLight);
        return posed(camera, pose);
    }
};

// The mean of `count` pictures whose samples lie all over each pixel's square: the R2 sequence (Roberts 2018,
// "The Unreasonable Effectiveness of Quasirandom Sequences"), from the middle on. The light must stand still.
Image meanOfSamples(Renderer& renderer, Output mode, const Camera& camera, int count) {
    const glm::dvec2 step(0.7548776662466927, 0.5698402909980532);
    Image sum = renderer.radiance();
    for (int i = 1; i < count; ++i) {
        renderer.setPictureShift(glm::vec2(glm::fract(0.5 + static_cast<double>(i) * step) - 0.5));
        renderer.render({{mode}, camera});
        const Image sample = renderer.radiance();
        for (std::size_t pixel = 0; pixel < sum.pixels.size(); ++pixel)
            sum.pixels[pixel] += sample.pixels[pixel];
    }
    renderer.setPictureShift(glm::vec2(0.0F));
    for (glm::vec3& pixel : sum.pixels)
        pixel /= static_cast<float>(count);
    return sum;
}

// The driver's targets of a picture in main memory, and its copies while it is encoded: 50 bytes per pixel
// with llvmpipe and mode 1, and some more for other modes.
void requirePictureMemory(glm::ivec2 size) {
    constexpr std::size_t bytesPerPixel = 64;
    requireMainMemory(bytesPerPixel * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y),
                      "a picture of " + std::to_string(size.x) + " x " + std::to_string(size.y) + " pixels",
                      "ask for a smaller picture");
}

// One mode, seen by a camera that comes to a scene whose light is there. With timings a still picture is
// drawn several times; of a sequence each frame is one sample. Reading back and writing is not timed.
void renderMode(const Placed& placed, Output mode, const std::vector<double>& moments,
                PictureWriter& pictures, TimingsReport& report) {
    const RenderOptions& options = placed.options;
    Renderer& renderer = placed.renderer;
    const std::string name = outputName(mode);
    const Camera camera = moments.empty() ? placed.camera : placed.moveTo(moments.front());
    const auto write = [&](const std::string& file) {
        report.activeVoxels = renderer.activeVoxels();  // throws where the list overflowed
        pictures.write(file, meanOfSamples(renderer, mode, camera, options.samples));
    };
    {
        const Settings& settings = renderer.settings();
        const Progress progress(
            "mode " + name + ", " + std::to_string(settings.size.x) + "x" + std::to_string(settings.size.y) +
            ", " + std::to_string(settings.grid) + "^3" +
            (options.samples > 1 ? ", " + std::to_string(options.samples) + " samples per pixel" : ""));
        renderer.render({{mode}, camera, LightSteps::all});
        if (!options.timings.empty()) {
            for (int i = 0; i < warmUpFrames; ++i)
                renderer.render({{mode}, camera});
            renderer.timer().startRecording(Clocks::cpuAndGpu);
            for (int i = 0; i < timedFrames && !options.frames; ++i)
                renderer.render({{mode}, camera});
        }
        if (!options.frames) write(name);
    }
    // Written frame by frame: a sequence may be longer than the memory.
    for (std::size_t frame = 0; options.frames && frame < moments.size(); ++frame) {
        char line[96], suffix[32];
        std::snprintf(line, sizeof line, "mode %s, frame %zu of %zu, %.3f s", name.c_str(), frame + 1,
                      moments.size(), moments[frame]);
        std::snprintf(suffix, sizeof suffix, "_%04zu", frame);
        const Progress progress(line);
        renderer.render({{mode}, placed.moveTo(moments[frame])});
        write(name + suffix);
    }
    if (!options.timings.empty()) report.modes.emplace_back(mode, renderer.timer().stopRecording());
}

void render(const RenderOptions& options) {
    const std::vector<Output> modes = parsed("--mode", modesFromText, options.mode);
    Settings settings = settingsFrom(options);
    if (options.frames && (options.debugViews || options.lightParts || options.contactSheet))
        throw Error(
            "--debug-views, --light-parts and --contact-sheet are of one moment; leave out --frames and "
            "--fps, "
            "and choose it by --time");
    if (options.frames && options.samples > 1)
        throw Error("--samples is of one moment; leave it out, or leave out --frames and --fps");
    std::optional<float> exposure;
    if (options.exposure != "auto") exposure = std::stof(options.exposure);
    // Before anything slow: an output that cannot be written should be known at once.
    PictureWriter pictures(options.out, exposure, parsed("--tone-map", toneMapFromText, options.toneMap),
                           options.contactSheet);
    if (!options.timings.empty()) requireWritableFile(options.timings);

    requirePictureMemory(settings.size);

    const std::string& path = options.scene.path;
    Scene scene = options.scene.load(options.animation);
    for (Material& material : scene.materials)
        material.emissive *= options.emission;
    for (const std::string& warning : scene.warnings)
        say("warning: " + warning);
    shuffleTriangles(scene, options.seedOrder);
    const std::vector<double> moments = momentsOf(options, scene);
    const Camera camera = options.scene.cameraOf(scene);
    DirectionalLight light = lightFromText(options.scene.light, scene);
    options.sky.lightScene(scene, options.scene.light, light, settings);
    say(path + ": " + std::to_string(scene.triangleCount()) + " triangles, " +
        std::to_string(scene.instances.size()) + " instances");
    if (!scene.animation.channels.empty() && moments.empty())
        say("note: the scene is animated and shown at rest; --time S shows a moment of its " +
            numberText(scene.animation.durationS) + " s, --frames N --fps F a sequence");

    if (settings.specular == Specular::none && featuresOf(scene).glossy)
        say("warning: glossy materials (roughness below 1) are drawn diffuse; --preset mobile and quality "
            "can reflect (--specular cone)");

    const Context context = options.scene.backend.open();
    say(context.capabilities.renderer + ", " + context.capabilities.version);
    options.scene.fitGrid(settings, scene, context.capabilities);
    if (const std::string note = voxelizationNote(settings.voxels, context.capabilities); !note.empty())
        say(note);
    Renderer renderer(scene, light, settings, context.capabilities, shaders());

    if (settings.voxels == Voxels::directional)
        say("indirect light settles in " + std::to_string(settings.lightFrames) +
            " frames (--light-frames), and is refined in " +
            std::to_string(GatherSchedule(settings.gather, settings.lightFrames).convergenceSteps() -
                           settings.lightFrames) +
            " more; pictures show the refined light");
    TimingsReport report;
    const Placed placed{options, scene, camera, light, renderer};
    if (!exposure) {
        // By the mode that has the most of the light, where all are asked for.
        const Progress progress(std::string("the exposure, by mode ") + outputName(modes.back()));
        renderer.render(
            {{modes.back()}, moments.empty() ? camera : placed.moveTo(moments.front()), LightSteps::all});
        pictures.chooseExposure(renderer.radiance());
    }
    for (const Output mode : modes)
        renderMode(placed, mode, moments, pictures, report);
    pictures.writeContactSheet();
    report.resources = renderer.resources();
    const Camera seen = moments.empty() ? camera : posed(camera, poseAt(scene.animation, moments.front()));
    if (options.lightParts)
        for (const DebugView& part : lightParts(renderer, seen))
            pictures.write(part.name, part.image, part.isShare);
    if (options.debugViews) {
        const Progress progress("debug views");
        pictures.writeDebugViews(debugViews(renderer, seen));
    }
    pictures.nameOlderPictures();
    if (options.timings.empty()) return;
    report.scene = path;
    report.triangles = scene.triangleCount();
    report.backend = backendName(options.scene.backend.backend);
    report.preset = options.preset;
    report.settings = settings;
    if (options.frames) report.timedFrames = *options.frames;
    writeJson(options.timings, timingsJson(report, context.capabilities));
    std::fputs(timingsTable(report.modes).c_str(), stdout);
    if (!settings.revoxelize && !options.frames)
        say("Nothing moved: shadow map (CS) and voxels (V, M) were made once, before these frames; "
            "--revoxelize times them too");
}

constexpr const char* renderFooter =
    "Writes DIR/<mode>.png (to look at: exposed, tone-mapped, sRGB) and DIR/<mode>.exr (linear radiance) for "
    "each mode, "
    "with --frames "
    "DIR/<mode>_0000.png "
    "and so on.\nOther pictures in DIR stay.\n"
    "Examples:\n"
    "  vct render assets/cornell.glb --out out --mode all --debug-views --timings out/timings.json\n"
    "  vct render my.glb --out out --camera eye=0,1.6,4,target=0,1,0,fov=50 --grid 128\n"
    "  vct render my.glb --out out --light direction=-1,-2,-1,color=1,0.9,0.8,intensity=5\n"
    "  vct render assets/patio.glb --out out --environment assets/patio.hdr --samples 16\n"
    "  vct render assets/moving.glb --out out --mode gi --time 1.5\n"
    "  vct render assets/moving.glb --out out --mode gi --frames 96 --fps 24";

}  // namespace

void addRender(CLI::App& app, int&) {
    CLI::App* command =
        app.add_subcommand("render", "Render a glTF scene: pictures, debug views, step timings");
    auto options = std::make_shared<RenderOptions>();
    command->footer(renderFooter);
    command->add_option("--out", options->out, "Folder for the pictures; made if missing")->required();
    command
        ->add_option("--mode", options->mode,
                     "phong, shadow-map, ao, gi, gi-cone-shadow (or 1 to 5), several with commas, or all")
        ->capture_default_str();
    command->add_option("--preset", options->preset, "Set of settings: " + presetList())
        ->capture_default_str();
    options->scene.addTo(*command)->required();
    command->add_option("--shadow-map", options->shadowMap, "Texels along a side (default: the preset's)");
    command->add_option("--cone-angle", options->coneAngleDeg,
                        "The sun's full angle for mode 5 in degrees, 0.1 to 170 (default: the preset's)");
    command
        ->add_option("--light-radius", options->lightRadius,
                     "Radius of point and spot lights in metres, for soft shadows in mode 5; other "
                     "directional lights than the sun then have the sun's angle (default: hard shadows)")
        ->check(positive);
    command->add_option("--shadow", options->shadow,
                        "Soft shadow of mode 5: cone (through the voxels) or soft-map (the shadow map, "
                        "filtered as wide as the penumbra); default: the preset's");
    command->add_option(
        "--specular", options->specular,
        "What materials with a roughness below 1 reflect besides diffuse light: none, or cone "
        "(the sun, and one cone along the mirror direction); default: the preset's");
    command->add_option("--light-frames", options->lightFrames,
                        "Frames after a change until indirect light has settled (default: the preset's). "
                        "Still pictures also wait "
                        "for its refinement, which follows if these frames hold two rounds of directions");
    command
        ->add_option("--time", options->timeS,
                     "The moment of the scene's animation, in seconds; before its first key and after its "
                     "last it stands still (default: at rest, as the file puts the nodes)")
        ->check(CLI::Range(0.0, 1e6));
    CLI::Option* const frames =
        command
            ->add_option("--frames", options->frames,
                         "A sequence of so many pictures, from --time (default 0) on, --fps of them a second")
            ->check(CLI::Range(1, 10000));  // as many as four digits count
    CLI::Option* const fps =
        command->add_option("--fps", options->fps, "Pictures for each second of the animation")
            ->check(positive);
    frames->needs(fps);
    fps->needs(frames);
    command->add_option("--animation", options->animation,
                        "Which of the scene's animations to play, by name or index (default: its first)");
    options->sky.addTo(*command);
    command
        ->add_option("--emission", options->emission, "Scales what all surfaces emit; 0 switches lamps off")
        ->check(CLI::Range(0.0, 1e6))
        ->capture_default_str();
    addPngOptions(*command, options->exposure, options->toneMap);
    command
        ->add_option(
            "--samples", options->samples,
            "Pictures of one moment that differ by parts of a pixel, of which the mean is written: smooth "
            "edges, in so many times the time of G-buffer and last pass; 16 is plenty")
        ->check(CLI::Range(1, 4096))
        ->capture_default_str();
    command->add_flag("--debug-views", options->debugViews,
                      "Also write every intermediate into DIR/debug_views/");
    command->add_flag(
        "--light-parts", options->lightParts,
        "Also write indirect_light, ambient_occlusion and cone_shadow, each alone, as PNG and EXR");
    command->add_flag("--contact-sheet", options->contactSheet,
                      "Also write DIR/contact_sheet.png, the modes side by side");
    command->add_option("--timings", options->timings,
                        "Time each step over 5 frames (docs/timings.md) and write FILE.json; "
                        "--revoxelize for those that nothing changes");
    command->add_flag("--revoxelize", options->revoxelize,
                      "Make shadow map and voxels anew in every frame, also where neither light nor pose has "
                      "changed: to measure what that takes");
    command
        ->add_option("--active-voxels", options->activeVoxels,
                     "Room in the active-voxel list (default: 16 grid^2)")
        ->check(positive);
    command->add_option("--seed-order", options->seedOrder,
                        "Shuffle the triangles; the result must not change");
    command->callback([options] { render(*options); });
}

}  // namespace vct::cli
