// vct shaders: writes the sources (ESSL, the OpenGL ES Shading Language) of every program of every preset as
// a phone's driver compiles them, and how often each stage and loop runs in a frame. tools/eval.py mali
// computes lower bounds of GPU time from both.
#include <algorithm>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/output.h"
#include "cli/progress.h"
#include "cli/sky_option.h"
#include "core/error.h"
#include "core/files.h"
#include "engine/programs.h"
#include "engine/renderer.h"
#include "lab/options.h"
#include "lab/program_list.h"
#include "lab/shader_counters.h"
#include "lab/timings.h"
#include "scene/camera.h"
#include "scene/gltf.h"

namespace vct::cli {

namespace {

using nlohmann::ordered_json;

// The values of --changes.
const std::vector<std::string> changes{"everything", "objects", "light"};

// Enough for all cached rays of faces that do not move.
constexpr int tracingFrames = 16;

struct ShadersOptions {
    SceneOptions scene;
    std::string changes = "everything";
    std::string out;
    SkyOption sky;
    std::vector<std::string> presets;
};

// A program of one preset, and what it did in the frames of the modes that run it.
struct Variant {
    Step step;
    gl::ProgramDescription program;
    std::vector<std::pair<std::string, StageCount>> counts;  // by mode
};

// Adds what the frames of a mode ran to the programs. `known`: the programs that they may run.
void add(std::vector<Variant>& variants, const std::string& mode, const std::vector<ProgramCount>& counts,
         const std::vector<FrameProgram>& known) {
    for (const ProgramCount& count : counts) {
        const auto& program = count.program;
        const auto use = std::find_if(known.begin(), known.end(), [&](const FrameProgram& frame) {
            return frame.program.name == program.name && frame.program.defines == program.defines;
        });
        if (use == known.end()) {
            std::string defines;
            for (const std::string& define : program.defines)
                defines += " " + define;
            throw Error("mode " + mode + " runs the program '" + program.name + "' with" + defines +
                        ", which framePrograms() in jni/lab/program_list.cpp does not list");
        }
        auto at = std::find_if(variants.begin(), variants.end(), [&](const Variant& variant) {
            return variant.program.name == program.name && variant.program.defines == program.defines;
        });
        if (at == variants.end()) at = variants.insert(at, Variant{use->step, program, {}});
        at->counts.emplace_back(mode, count.stage);
    }
}

// Shaders as phones compile them: half precision if the sources allow it, and OpenGL ES 3.1.
gl::ShaderLibrary phoneLibrary(const Settings& settings) {
    gl::Capabilities phone;
    phone.softwareDriver = false;
    phone.essl320 = false;
    return shaderLibrary(settings, phone, shaders());
}

const char* stageName(const std::string& shader) {
    static const std::map<GLenum, const char*> names{{GL_VERTEX_SHADER, "vertex"},
                                                     {GL_GEOMETRY_SHADER, "geometry"},
                                                     {GL_FRAGMENT_SHADER, "fragment"},
                                                     {GL_COMPUTE_SHADER, "compute"}};
    return names.at(gl::shaderStage(shader));
}

// The name of a program's folder: its number and its name, such as "07-gather".
std::string folderName(std::size_t number, const std::string& program) {
    std::string name = (number < 10 ? "0" : "") + std::to_string(number) + "-";
    for (const char c : program) {
        const bool isPlain =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
        if (isPlain || name.back() != '-') name += isPlain ? c : '-';
    }
    return name;
}

ordered_json countJson(const StageCount& stage) {
    ordered_json loops = ordered_json::array();
    for (const LoopCount& loop : stage.loops)
        loops.push_back({{"place", loop.place},
                         {"depth", loop.depth},
                         {"constant", loop.constant},
                         {"iterations", loop.iterations}});
    return {{"shader", stage.shader}, {"invocations", stage.invocations}, {"loops", loops}};
}

// Writes the sources into DIR/PRESET/NUMBER-PROGRAM/ and returns the manifest's entries.
ordered_json writeSources(const std::vector<Variant>& programs, const Settings& settings,
                          const std::string& preset, OutputFolder& out) {
    const gl::ShaderLibrary library = phoneLibrary(settings);
    ordered_json entries = ordered_json::array();
    for (std::size_t i = 0; i < programs.size(); ++i) {
        const Variant& variant = programs[i];
        std::vector<std::string> defines = library.defines;
        defines.insert(defines.end(), variant.program.defines.begin(), variant.program.defines.end());
        const std::string folder = preset + "/" + folderName(i, variant.program.name);
        OutputFolder programFolder(out.file(folder));
        ordered_json stages = ordered_json::array();
        for (const std::string& shader : variant.program.shaders) {
            const std::string file = shader.substr(shader.rfind('/') + 1);
            replaceFile(programFolder.file(file),
                        gl::assembleShader(library.read, shader, defines, gl::Language::essl310).text);
            stages.push_back(
                {{"stage", stageName(shader)}, {"shader", shader}, {"file", folder + "/" + file}});
        }
        programFolder.keep();
        ordered_json modes = ordered_json::array(), counts = ordered_json::object();
        for (const auto& [mode, count] : variant.counts) {
            modes.push_back(mode);
            counts[mode] = countJson(count);
        }
        entries.push_back({{"name", variant.program.name},
                           {"pass", stepName(variant.step)},
                           {"defines", defines},
                           {"modes", modes},
                           {"stages", stages},
                           {"counts", counts}});
    }
    return entries;
}

void writeShaders(const ShadersOptions& options) {
    const std::vector<std::string>& presets = options.presets.empty() ? presetNames() : options.presets;
    for (const std::string& preset : presets)
        presetSettings(preset);
    Settings sky;
    options.sky.applyTo(sky);
    OutputFolder out(options.out);
    Scene scene = options.scene.load();
    const Camera camera = options.scene.cameraOf(scene);
    options.sky.addRoomLight(scene, camera, options.scene.light);
    DirectionalLight light = lightFromText(options.scene.light, scene);
    // As `vct bench`, which measures these programs.
    if (scene.lights.empty() && options.scene.light.empty())
        options.sky.lightScene(scene, camera, aspectOf(options.scene.size), options.scene.light, light, sky);
    if (options.changes == "objects" && scene.animation.nodes.empty())
        throw Error("--changes objects: no animation moves an object of " + options.scene.path);
    std::size_t vertices = 0;
    for (const Instance& instance : scene.instances)
        vertices += scene.meshes[instance.mesh].vertices.size();
    const Context context = options.scene.backend.open();

    ordered_json manifest{{"scene", options.scene.path.substr(options.scene.path.rfind('/') + 1)},
                          {"width", options.scene.size.x},
                          {"height", options.scene.size.y},
                          {"changes", options.changes},
                          {"vertices", vertices},
                          {"presets", ordered_json::array()}};
    for (const std::string& preset : presets) {
        const Progress progress(preset);
        Settings settings = options.scene.settings(preset);
        options.scene.fitGrid(settings, scene, context.capabilities);
        settings.skyRadiance = sky.skyRadiance;
        settings.environment = sky.environment;
        settings.revoxelize = options.changes == "everything";
        const ShaderCounters counters;
        Renderer renderer(scene, light, settings, context.capabilities, shaders(), counters.programs());
        std::vector<Variant> variants;
        int moments = 0;
        const auto change = [&] {
            const double moment = ++moments;
            if (options.changes == "objects") renderer.setPose(poseAt(scene.animation, moment / 60.0));
            if (options.changes == "light")
                renderer.setLightDirection(
                    glm::normalize(light.directionToLight + 0.001 * moment * glm::dvec3(1, 0, 0)));
        };
        for (int i = 0; i < tracingFrames && !settings.revoxelize; ++i) {
            change();
            renderer.render({{allModes().back()}, camera});
        }
        for (const Output mode : allModes()) {
            const auto frame = [&] { renderer.render({{mode}, camera}); };
            change();
            frame();  // the second frame represents all later ones; the first one has nothing to clear
            change();
            add(variants, outputName(mode), counters.count(frame),
                framePrograms(settings, mode, featuresOf(scene), context.capabilities));
        }
        ordered_json entry{{"name", preset}, {"grid", settings.grid}};
        entry["programs"] = writeSources(variants, settings, preset, out);
        manifest["presets"].push_back(std::move(entry));
    }
    writeJson(out.file("manifest.json"), manifest);
    out.keep();
    for (const ordered_json& entry : manifest["presets"])
        say("wrote " + std::to_string(entry["programs"].size()) + " programs into " +
            out.file(entry["name"].get<std::string>()));
    say(out.file("manifest.json") + " lists them, and how often each runs");
}

constexpr const char* shadersFooter =
    "Writes the shaders of each program into DIR/PRESET/NUMBER-PROGRAM/, and DIR/manifest.json with the "
    "programs, the modes that use them "
    "and how often each shader and loop runs. tools/eval.py mali computes lower bounds for a Mali GPU from "
    "it "
    "(docs/mali.md).\n"
    "Example:\n"
    "  vct shaders assets/cornell.glb --out out/shaders";

}  // namespace

void addShaders(CLI::App& app, int&) {
    CLI::App* command = app.add_subcommand(
        "shaders", "Write the shader sources of every program, and how often each runs in a frame");
    const auto options = std::make_shared<ShadersOptions>();
    command->footer(shadersFooter);
    options->scene.addTo(*command)->required();
    command->add_option("--out", options->out, "Folder for the sources (DIR below); created if missing")
        ->required();
    command
        ->add_option("--preset", options->presets,
                     std::string(presetHelp) + "; several separated by commas (default: all)")
        ->delimiter(',');
    command
        ->add_option("--changes", options->changes,
                     "What changes before the frame that is counted: everything is rebuilt, the scene's "
                     "animation moves its objects, or the sun turns (default: everything)")
        ->check(CLI::IsMember(changes));
    options->sky.addTo(*command);
    command->callback([options] { writeShaders(*options); });
}

}  // namespace vct::cli
