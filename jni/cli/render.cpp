// vct render: renders a scene to pictures, debug views and step timings.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <set>

#include "cli/commands.h"
#include "cli/empty_picture.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/pictures.h"
#include "cli/progress.h"
#include "cli/sky_option.h"
#include "cli/without_effect.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/number_text.h"
#include "engine/directional/light_schedule.h"
#include "engine/environment.h"
#include "engine/frame_uniforms.h"
#include "engine/radiance_unit.h"
#include "engine/renderer.h"
#include "lab/debug_view.h"
#include "lab/options.h"
#include "lab/timings.h"
#include "scene/camera.h"
#include "scene/gltf.h"
#include "scene/near_plane.h"
#include "scene/scene_features.h"
#include "scene/subject.h"

namespace vct::cli {

namespace {

struct RenderOptions {
    std::set<std::string> given;  // names of the options on the command line
    SceneOptions scene;
    std::string out, timings, animation, bakedLight;
    std::string mode = "gi-cone-shadow";
    std::string preset = defaultPreset;
    std::string toneMap = "neutral";
    SkyOption sky;
    // These replace the preset's settings if they are given.
    std::optional<int> shadowMap, lightFrames;
    std::optional<unsigned> activeVoxels;
    std::optional<float> coneAngleDeg;
    float lightRadius = 0.0F;
    float emission = 1.0F;
    // Moments of an animated scene.
    std::optional<double> timeS, fps;
    std::optional<int> frames, turntable;
    bool converged = false;
    std::string exposure = "auto";  // exposure of the PNGs: a number or "auto"
    std::optional<int> samples;     // samples per pixel of a still picture
    bool revoxelize = false, debugViews = false, lightParts = false, contactSheet = false;
};

// Number of pictures in the sequence, if the run renders one.
std::optional<int> sequenceLength(const RenderOptions& options) {
    return options.turntable ? options.turntable : options.frames;
}

// True if each picture shows all of the light. The camera of a turntable does not change the light.
bool isConverged(const RenderOptions& options) {
    return !options.frames || options.converged;
}

// Samples per pixel. A picture beside its time, or of a sequence whose light follows the scene, is a single
// frame.
int samplesOf(const RenderOptions& options) {
    return options.samples.value_or(isConverged(options) && options.timings.empty() ? 4 : 1);
}

Settings settingsFrom(const RenderOptions& options) {
    Settings settings = options.scene.settings(options.preset);
    settings.shadowMapSize = options.shadowMap.value_or(settings.shadowMapSize);
    settings.shadowConeAngleDeg = options.coneAngleDeg.value_or(settings.shadowConeAngleDeg);
    settings.lightRadius = options.lightRadius;
    settings.lightFrames = options.lightFrames.value_or(settings.lightFrames);
    options.sky.applyTo(settings);
    settings.revoxelize = options.revoxelize;
    settings.activeVoxelLimit = options.activeVoxels.value_or(settings.activeVoxelLimit);
    validate(settings);
    return settings;
}

// The moment and the view of one picture.
struct Frame {
    std::optional<double> momentS;  // of the animation; at rest without it
    double turn = 0.0;              // of the camera around the scene, in full turns
};

// The frames of the sequence, or the only one.
std::vector<Frame> framesOf(const RenderOptions& options, const Scene& scene) {
    if ((options.timeS || options.frames) && scene.animation.channels.empty())
        throw Error("the scene " + scene.path +
                    " has no animation, so it looks the same at all times; leave out --time, --frames and "
                    "--fps, or let the camera move with --turntable N");
    const int count = sequenceLength(options).value_or(1);
    std::vector<Frame> frames(static_cast<std::size_t>(count), {options.timeS, 0.0});
    for (int i = 0; i < count; ++i) {
        if (options.turntable)
            frames[static_cast<std::size_t>(i)].turn = static_cast<double>(i) / count;
        else if (options.frames)
            frames[static_cast<std::size_t>(i)].momentS = options.timeS.value_or(0.0) + i / *options.fps;
    }
    return frames;
}

// Turns a camera about the vertical through a point.
Camera turned(Camera camera, const glm::dvec3& pivot, double turns) {
    const glm::dmat4 turn =
        glm::rotate(glm::dmat4(1.0), turns * 2.0 * glm::pi<double>(), glm::dvec3(0, 1, 0));
    camera.worldFromCamera = glm::translate(glm::dmat4(1.0), pivot) * turn *
                             glm::translate(glm::dmat4(1.0), -pivot) * camera.worldFromCamera;
    return camera;
}

// A renderer with its scene, and the camera and the sun in the scene's rest pose.
struct Placed {
    const RenderOptions& options;
    const Scene& scene;
    Camera camera;
    DirectionalLight light;
    Renderer& renderer;
    NearPlane nearPlane{scene};

    // Moves the renderer's scene and sun to the frame's moment; returns the camera of the frame.
    Camera moveTo(const Frame& frame) const {
        const double aspect = aspectOf(options.scene.size);
        const Bounds subject = subjectOf(scene).boundsWorld;
        const auto turnedTo = [&](const Camera& from) {
            return turned(from, 0.5 * (subject.min + subject.max), frame.turn);
        };
        if (!frame.momentS) return nearPlane.fitted(turnedTo(camera), aspect);
        const Pose pose = poseAt(scene.animation, *frame.momentS);
        renderer.setPose(pose);
        renderer.setLightDirection(posed(light, pose).directionToLight);
        return nearPlane.fitted(turnedTo(posed(camera, pose)), aspect, &pose);
    }
};

OnLightStep lightStepsIn(Progress& progress) {
    return [&progress](int done, int steps) {
        progress.setPart("light: step " + std::to_string(done) + " of " + std::to_string(steps));
    };
}

// Adds a picture's pixels to those of a sum.
void add(Image& sum, const Image& image) {
    for (std::size_t pixel = 0; pixel < sum.pixels.size(); ++pixel)
        sum.pixels[pixel] += image.pixels[pixel];
}

void divide(Image& sum, int count) {
    for (glm::vec3& pixel : sum.pixels)
        pixel /= static_cast<float>(count);
}

// Writes the mean of `count` pictures that are shifted by parts of a pixel, for smooth edges, and returns its
// radiance. The shifts cover the pixel's square evenly, beginning at its centre (R2 sequence; Roberts 2018,
// "The Unreasonable Effectiveness of Quasirandom Sequences"). The light must have converged. A PNG shows the
// mean of what the samples show: the mean of their radiance would leave steps along the edges of surfaces
// brighter than white.
Image writeMeanOfSamples(Renderer& renderer, Output mode, const Camera& camera, int count,
                         PictureWriter& pictures, const std::string& file, Progress& progress) {
    const glm::dvec2 step(0.7548776662466927, 0.5698402909980532);
    Image radiance = renderer.radiance(), shown = pictures.shown(radiance);
    for (int i = 1; i < count; ++i) {
        progress.setPart("sample " + std::to_string(i + 1) + " of " + std::to_string(count));
        renderer.setPictureShift(glm::vec2(glm::fract(0.5 + static_cast<double>(i) * step) - 0.5));
        renderer.render({{mode}, camera});
        const Image sample = renderer.radiance();
        add(radiance, sample);
        add(shown, pictures.shown(sample));
    }
    renderer.setPictureShift(glm::vec2(0.0F));
    divide(radiance, count);
    divide(shown, count);
    pictures.warnIfWhite(file, radiance);
    pictures.write(file, radiance, std::move(shown));
    return radiance;
}

// Throws if main memory is too small for a picture of this size: the driver's render targets, and the copies
// while it is encoded. They take 74 bytes per pixel with llvmpipe in mode 1, and more in other modes.
void requirePictureMemory(glm::ivec2 size) {
    constexpr std::size_t bytesPerPixel = 88;
    requireMainMemory(bytesPerPixel * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y),
                      "a picture of " + std::to_string(size.x) + " x " + std::to_string(size.y) + " pixels",
                      "ask for a smaller picture");
}

// Radiance of a white surface in the strongest of the scene's lights: sun, lamps or sky; 0 without these.
float whiteRadiance(const DirectionalLight& light, const Settings& settings) {
    const glm::vec3& sky = settings.skyRadiance;
    const float white = std::max({sunlitRadiance(light), sky.r, sky.g, sky.b});
    return settings.environment ? std::max(white, settings.environment->largestIrradiance()) : white;
}

// The name of a picture of a sequence, without extension.
std::string frameName(Output mode, int frame) {
    char suffix[16];
    std::snprintf(suffix, sizeof suffix, "_%04d", frame);
    return outputName(mode) + std::string(suffix);
}

// Throws if a folder stands where a picture of this run would be written.
void requireRoom(const RenderOptions& options, const std::vector<Output>& modes,
                 const PictureWriter& pictures) {
    for (const Output mode : modes) {
        if (!sequenceLength(options)) pictures.requireRoomFor(outputName(mode));
        for (int frame = 0; frame < sequenceLength(options).value_or(0); ++frame)
            pictures.requireRoomFor(frameName(mode, frame));
    }
    if (options.lightParts)
        for (const std::string& name : lightPartNames())
            pictures.requireRoomFor(name);
    if (options.contactSheet) pictures.requireRoomForContactSheet();
    if (options.debugViews) pictures.requireRoomForDebugViews();
}

// Renders and writes one mode. For timings, a still picture is rendered several times; in a sequence each
// frame is one sample. Reading back and writing are not timed. Returns the first picture.
Image renderMode(const Placed& placed, Output mode, const std::vector<Frame>& frames, PictureWriter& pictures,
                 TimingsReport& report) {
    const RenderOptions& options = placed.options;
    Renderer& renderer = placed.renderer;
    const std::string name = outputName(mode);
    const bool isSequence = sequenceLength(options).has_value();
    Image first;
    const auto write = [&](const std::string& file, const Camera& camera, Progress& progress) {
        report.activeVoxels = renderer.activeVoxels();  // throws if the active-voxel list overflowed
        Image image =
            writeMeanOfSamples(renderer, mode, camera, samplesOf(options), pictures, file, progress);
        if (first.pixels.empty()) first = std::move(image);
    };
    {
        const Settings& settings = renderer.settings();
        Progress progress(
            "mode " + name + ", " + std::to_string(settings.size.x) + "x" + std::to_string(settings.size.y) +
            ", " + std::to_string(settings.grid) + "^3" +
            (samplesOf(options) > 1 ? ", " + std::to_string(samplesOf(options)) + " samples per pixel" : ""));
        const Camera camera = placed.moveTo(frames.front());
        renderer.render({.outputs = {mode},
                         .camera = camera,
                         .lightSteps = LightSteps::all,
                         .onLightStep = lightStepsIn(progress)});
        if (!options.timings.empty()) {
            for (int i = 0; i < warmUpFrames; ++i)
                renderer.render({{mode}, camera});
            renderer.timer().startRecording(Clocks::cpuAndGpu);
            for (int i = 0; i < timedFrames && !isSequence; ++i)
                renderer.render({{mode}, camera});
            if (!isSequence) report.modes.emplace_back(mode, renderer.timer().stopRecording());
        }
        if (!isSequence) write(name, camera, progress);
    }
    // Each frame is written at once, because a long sequence may not fit into memory.
    for (std::size_t frame = 0; isSequence && frame < frames.size(); ++frame) {
        const Frame& shown = frames[frame];
        Progress progress("mode " + name + ", frame " + std::to_string(frame + 1) + " of " +
                          std::to_string(frames.size()) +
                          (options.turntable ? ", " + numberText(360.0 * shown.turn) + " degrees"
                                             : ", " + numberText(*shown.momentS) + " s"));
        const Camera camera = placed.moveTo(shown);
        renderer.render({.outputs = {mode},
                         .camera = camera,
                         .lightSteps = isConverged(options) ? LightSteps::all : LightSteps::one,
                         .onLightStep = isConverged(options) ? lightStepsIn(progress) : OnLightStep()});
        write(frameName(mode, static_cast<int>(frame)), camera, progress);
    }
    if (!options.timings.empty() && isSequence)
        report.modes.emplace_back(mode, renderer.timer().stopRecording());
    return first;
}

std::string inShell(const std::string& word) {
    if (word.find_first_of(" \t'\"\\$&;()*?<>|`#!~") == std::string::npos) return word;
    std::string quoted = "'";
    for (const char c : word)
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return quoted + "'";
}

// The command that makes a video of a sequence. The encoder takes even sizes only.
std::string videoLine(const RenderOptions& options, Output mode) {
    constexpr double turntableFps = 24.0;
    const std::string path = options.out + "/" + outputName(mode);
    const glm::ivec2 size = options.scene.size;
    return "ffmpeg -y -framerate " + numberText(options.fps.value_or(turntableFps)) + " -i " +
           inShell(path + "_%04d.png") + " -frames:v " + std::to_string(*sequenceLength(options)) +
           (size.x % 2 == 0 && size.y % 2 == 0 ? "" : " -vf 'crop=trunc(iw/2)*2:trunc(ih/2)*2'") +
           " -c:v libx264 -crf 18 -pix_fmt yuv420p " + inShell(path + ".mp4");
}

// Throws if --out names one picture and the run writes several.
void requireOnePicture(const RenderOptions& options, const std::vector<Output>& modes) {
    if (options.out.empty() || !namesOnePicture(options.out)) return;
    const std::pair<bool, const char*> reasons[] = {{modes.size() > 1, "--mode"},
                                                    {options.frames.has_value(), "--frames"},
                                                    {options.turntable.has_value(), "--turntable"},
                                                    {options.debugViews, "--debug-views"},
                                                    {options.lightParts, "--light-parts"},
                                                    {options.contactSheet, "--contact-sheet"}};
    for (const auto& [isGiven, what] : reasons)
        if (isGiven)
            throw Error("--out " + options.out + " names one picture, and this run writes more (" + what +
                        "); name a folder");
}

void render(RenderOptions options) {
    const std::vector<Output> modes = parsed("--mode", modesFromText, options.mode);
    requireOnePicture(options, modes);
    if (options.out.empty()) options.out = "out/" + std::filesystem::path(options.scene.path).stem().string();
    Settings settings = settingsFrom(options);
    if (options.fps && !sequenceLength(options))
        throw Error("--fps is the speed of a sequence; add --frames N or --turntable N");
    if (sequenceLength(options) && (options.debugViews || options.lightParts || options.contactSheet))
        throw Error(
            "--debug-views, --light-parts and --contact-sheet work for one moment only, not for a sequence; "
            "leave out --frames, --fps and --turntable, and choose the moment with --time");
    std::optional<float> exposure;
    if (options.exposure != "auto") exposure = std::stof(options.exposure);
    // Checks the outputs before any slow work.
    PictureWriter pictures(options.out, exposure, parsed("--tone-map", toneMapFromText, options.toneMap),
                           options.contactSheet);
    requireRoom(options, modes, pictures);
    if (!options.timings.empty()) requireWritableFile(options.timings);

    requirePictureMemory(settings.size);

    const std::string& path = options.scene.path;
    Scene scene = options.scene.load(options.animation);
    options.scene.fitSize(scene);
    settings.size = options.scene.size;
    const bool hasEmitters = featuresOf(scene).has(featureEmissive);
    for (Material& material : scene.materials)
        material.emissive *= options.emission;
    for (const std::string& warning : scene.warnings)
        say("warning: " + warning);
    const std::vector<Frame> frames = framesOf(options, scene);
    const Camera camera = options.scene.cameraOf(scene);
    options.sky.addRoomLight(scene, camera, options.scene.light);
    DirectionalLight light = lightFromText(options.scene.light, scene);
    options.sky.lightScene(scene, camera, aspectOf(settings.size), options.scene.light, light, settings);
    for (const std::string& sentence :
         optionsWithoutEffect({options.given, modes, options.lightParts || options.debugViews, settings,
                               scene, light, hasEmitters}))
        say("note: " + sentence);
    say(path + ": " + std::to_string(scene.triangleCount()) + " triangles, " +
        std::to_string(scene.instances.size()) + " instances");
    if (!scene.animation.channels.empty() && !frames.front().momentS)
        say("note: the scene is animated and shown at rest; --time S renders a moment of its " +
            numberText(scene.animation.durationS) + " s, --frames N --fps F renders a sequence");

    if (settings.voxels == Voxels::packed && featuresOf(scene).glossy)
        say("warning: glossy materials (metals, and others with a roughness below 1) are rendered without "
            "reflections; use --preset mobile or quality");

    const Context context = options.scene.backend.open();
    say(context.capabilities.renderer + ", " + context.capabilities.version);
    options.scene.fitGrid(settings, scene, context.capabilities);
    if (const std::string note = voxelizationNote(settings.voxels, context.capabilities); !note.empty())
        say(note);
    Renderer renderer(scene, light, settings, context.capabilities, shaders());
    if (!options.bakedLight.empty())
        renderer.useBakedLight(bakedLightOf(readFileFromDisk(options.bakedLight),
                                            lightKey(scene, light, settings),
                                            "--baked-light " + options.bakedLight));

    if (settings.voxels == Voxels::directional && options.bakedLight.empty())
        say("indirect light converges over " + std::to_string(settings.lightFrames) +
            " frames (--light-frames) and " +
            std::to_string(
                LightSchedule(settings.gather, settings.lightFrames, settings.cascades).convergenceSteps() -
                settings.lightFrames) +
            " frames of refinement before the first picture");
    TimingsReport report;
    const Placed placed{options, scene, camera, light, renderer};
    const Camera first = placed.moveTo(frames.front());
    if (first.nearest > camera.nearest)
        say("note: the camera's near plane of " + numberText(camera.nearest) + " m is moved to " +
            numberText(first.nearest) + " m for the precision of depth; it cuts nothing off");
    if (!exposure) {
        // If all modes are rendered, the last one has the most complete light.
        Progress progress(std::string("choosing the exposure with mode ") + outputName(modes.back()));
        renderer.render({.outputs = {modes.back()},
                         .camera = first,
                         .lightSteps = LightSteps::all,
                         .onLightStep = lightStepsIn(progress)});
        Image image = renderer.radiance();
        if (settings.background)
            image = withSky(std::move(image), *settings.background, settings.skyRadiance);
        pictures.chooseExposure(image, whiteRadiance(light, settings));
    }
    for (const Output mode : modes) {
        const Image picture = renderMode(placed, mode, frames, pictures, report);
        // The last mode has the most complete light.
        if (mode != modes.back()) continue;
        const std::string warning =
            emptyPictureWarning(picture, scene, first, options.scene.camera, light, settings);
        if (!warning.empty()) say(warning);
    }
    pictures.writeContactSheet();
    report.resources = renderer.resources();
    if (options.lightParts)
        for (const DebugView& part : lightParts(renderer, first))
            pictures.write(part.name, part.image, part.isShare ? part.image : pictures.shown(part.image));
    if (options.debugViews) {
        const Progress progress("debug views");
        pictures.writeDebugViews(debugViews(renderer, first));
    }
    pictures.nameWrittenPictures();
    for (const Output mode : modes)
        if (sequenceLength(options)) say("a video of them: " + videoLine(options, mode));
    if (options.timings.empty()) return;
    report.scene = path;
    report.triangles = scene.triangleCount();
    report.backend = backendName(options.scene.backend.backend);
    report.preset = options.preset;
    report.settings = settings;
    if (sequenceLength(options)) report.timedFrames = *sequenceLength(options);
    writeJson(options.timings, timingsJson(report, context.capabilities));
    std::fputs(timingsTable(report.modes).c_str(), stdout);
    if (!settings.revoxelize && !sequenceLength(options))
        say("note: nothing moved, so shadow map (CS) and voxels (V, M) were built before the timed frames "
            "and "
            "took no time in them; --revoxelize times them too");
}

constexpr const char* renderFooter =
    "Writes two files for each mode: DIR/MODE.png (with exposure and tone mapping, sRGB) and DIR/MODE.exr "
    "(linear radiance). With --frames they are DIR/MODE_0000.png and so on. Deletes nothing in DIR.\n"
    "Examples:\n"
    "  vct render my.glb                      writes out/my/gi-cone-shadow.png\n"
    "  vct render my.glb --out picture.png    writes this file only\n"
    "  vct render assets/cornell.glb --out out --mode all --debug-views --timings out/timings.json\n"
    "  vct render my.glb --out out --camera eye=0,1.6,4,target=0,1,0,fov=50 --grid 128\n"
    "  vct render my.glb --out out --light direction=-1,-2,-1,color=1,0.9,0.8,intensity=5\n"
    "  vct render assets/patio.glb --out out --environment assets/patio.hdr --samples 16\n"
    "  vct render assets/moving.glb --out out --mode gi --time 1.5\n"
    "  vct render assets/moving.glb --out out --mode gi --frames 96 --fps 24 --converged\n"
    "  vct render my.glb --turntable 96";

}  // namespace

void addRender(CLI::App& app, int&) {
    CLI::App* command =
        app.add_subcommand("render", "Render a glTF scene to pictures, debug views and step timings");
    auto options = std::make_shared<RenderOptions>();
    command->footer(renderFooter);
    command->add_option(
        "--out", options->out,
        "Folder for the pictures (DIR below), created if missing; or one .png or .exr file for the "
        "picture (default: out/ and the name of the scene's file)");
    command
        ->add_option(
            "--mode", options->mode,
            "Light to render: phong (1: direct light, no shadow), shadow-map (2: with hard shadows), "
            "ao (3: and ambient occlusion), gi (4: indirect light in place of ambient occlusion), "
            "gi-cone-shadow (5: and the sun's shadow soft); several separated by commas, or all")
        ->capture_default_str();
    command->add_option("--preset", options->preset, presetHelp)->capture_default_str();
    options->scene.addTo(*command)->required();
    command
        ->add_option("--shadow-map", options->shadowMap,
                     "Size of the shadow map: texels per side, 16 to 8192 (default: the preset's)")
        ->group(lightGroup);
    command
        ->add_option("--cone-angle", options->coneAngleDeg,
                     "Angular diameter of the sun in degrees, 0.1 to 170, for its soft shadow in mode 5 "
                     "(default: the preset's)")
        ->group(lightGroup);
    command
        ->add_option("--light-radius", options->lightRadius,
                     "Radius of point and spot lights in metres, for soft shadows in mode 5; directional "
                     "lights besides the sun then get the sun's --cone-angle (default: hard shadows)")
        ->check(positive)
        ->group(lightGroup);
    command
        ->add_option("--light-frames", options->lightFrames,
                     "Frames after a change until indirect light has converged, 1 to 1000 (default: the "
                     "preset's). With 16 or more, a refinement with more directions follows. Still pictures "
                     "show the light after all of these frames. It has no effect with the preset thesis")
        ->group(lightGroup);
    const char* const animationGroup = "Animation";
    command
        ->add_option("--time", options->timeS,
                     "Moment of the scene's animation, in seconds; before the first key and after the last "
                     "one nothing moves (default: at rest, as the file places the nodes)")
        ->check(CLI::Range(0.0, 1e6))
        ->group(animationGroup);
    CLI::Option* const frames =
        command
            ->add_option("--frames", options->frames,
                         "Render a sequence of so many pictures, beginning at --time (default: 0)")
            ->check(CLI::Range(1, 10000))  // file names have four digits
            ->group(animationGroup);
    CLI::Option* const fps =
        command->add_option("--fps", options->fps, "Pictures of the sequence per second of the animation")
            ->check(positive)
            ->group(animationGroup);
    frames->needs(fps);
    command
        ->add_option(
            "--turntable", options->turntable,
            "Render a sequence of so many pictures in which the camera moves once around the scene, about "
            "the "
            "vertical through its middle; --fps is the speed of the printed video line (default: 24)")
        ->check(CLI::Range(1, 10000))
        ->excludes(frames)
        ->group(animationGroup);
    command
        ->add_flag("--converged", options->converged,
                   "Render each picture of --frames with all of its light, as a still picture. Without it, "
                   "light follows "
                   "the scene as in a window, a frame of light per picture")
        ->needs(frames)
        ->group(animationGroup);
    command
        ->add_option("--animation", options->animation,
                     "Animation to play, by name or index (default: the scene's first)")
        ->group(animationGroup);
    options->sky.addTo(*command);
    command
        ->add_option("--baked-light", options->bakedLight,
                     "File of `vct bake` with the converged indirect light of this scene and these options, "
                     "which the pictures then show at once")
        ->group(lightGroup);
    command
        ->add_option("--emission", options->emission,
                     "Factor for the light that surfaces emit; 0 switches all emitters off")
        ->check(CLI::Range(0.0, 1e6))
        ->capture_default_str()
        ->group(lightGroup);
    addPngOptions(*command, options->exposure, options->toneMap);
    command
        ->add_option("--samples", options->samples,
                     "Samples per pixel of a still picture, for smooth edges: the mean of so many pictures, "
                     "each shifted by a part of a pixel (default: 4, or 1 with --timings and with --frames "
                     "without --converged, whose pictures are single frames). 16 is plenty")
        ->check(CLI::Range(1, 4096))
        ->group(picturesGroup);
    command
        ->add_flag("--debug-views", options->debugViews,
                   "Also write every intermediate result into DIR/debug_views/")
        ->group(picturesGroup);
    command
        ->add_flag("--light-parts", options->lightParts,
                   "Also write parts of the light as PNG and EXR: indirect_light, ambient_occlusion, "
                   "cone_shadow (the visible share of the sun) and, with reflections, specular_light")
        ->group(picturesGroup);
    command
        ->add_flag("--contact-sheet", options->contactSheet,
                   "Also write DIR/contact_sheet.png, all modes side by side")
        ->group(picturesGroup);
    command
        ->add_option("--timings", options->timings,
                     "Time each step over 5 frames and write the times to this JSON file (docs/timings.md "
                     "explains it); in a scene without motion add --revoxelize")
        ->group(measuringGroup);
    command
        ->add_flag(
            "--revoxelize", options->revoxelize,
            "Rebuild shadow map and voxels in every frame, even if neither light nor pose has changed, "
            "to measure what that costs")
        ->group(measuringGroup);
    command
        ->add_option("--active-voxels", options->activeVoxels,
                     "Capacity of the list of occupied voxels (default: 16 times the grid squared)")
        ->check(positive)
        ->group(voxelGroup);
    command->callback([options, command] {
        for (const CLI::Option* option : command->get_options())
            if (option->count() > 0) options->given.insert(option->get_name());
        render(*options);
    });
}

}  // namespace vct::cli
