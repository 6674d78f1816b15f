#include "app/scenes.h"

#include <utility>

#include "core/error.h"
#include "engine/environment.h"
#include "image/radiance_file.h"
#include "scene/camera.h"
#include "scene/light_choice.h"

namespace vct::app {

namespace {

// The content of a file that may not exist.
std::vector<unsigned char> readIfPresent(const std::string& path, const ReadFile& read) {
    try {
        return read(path);
    } catch (const Error&) {
        return {};
    }
}

LoadedSky skyOf(const std::string& path, const std::vector<unsigned char>& bytes) {
    return std::make_shared<const Environment>(decodeRadiance(path, bytes), "'" + path + "'");
}

// A sky that cannot be read is left out, with a message.
LoadedSky skyBeside(const std::string& scene, const ReadFile& read) {
    const std::string path = pathBeside(scene, skyExtension);
    const std::vector<unsigned char> bytes = readIfPresent(path, read);
    if (bytes.empty()) return nullptr;
    try {
        LoadedSky sky = skyOf(path, bytes);
        log("the sky is that of " + path);
        return sky;
    } catch (const Error& error) {
        log(LogLevel::warning, error.what());
        return nullptr;
    }
}

}  // namespace

std::string pathBeside(const std::string& path, const char* extension) {
    return path.substr(0, path.find_last_of('.')) + extension;
}

Scenes::Load sceneLoader(OpenFile open) {
    return [open = std::move(open)](const FileChoice& file, const std::atomic<bool>& cancelled) {
        const ReadFile read = open(file, cancelled);
        Scene scene = loadGltf(file.path, read, {.allowOutside = file.allowOutside, .scale = file.scale});
        LoadedSky sky = file.usesSkyBeside ? skyBeside(file.path, read) : nullptr;
        const auto light =
            file.addRoomLight && !sky ? chooseRoomLight(scene, chooseCamera(scene, "")) : std::nullopt;
        if (light) {
            scene.punctualLights.push_back(*light);
            log(roomLightNote(*light));
        }
        return LoadedScene{std::make_shared<const Scene>(std::move(scene)),
                           readIfPresent(pathBeside(file.path, bakedLightExtension), read), std::move(sky)};
    };
}

SkyPictures::Load skyLoader(OpenFile open) {
    return [open = std::move(open)](const FileChoice& file, const std::atomic<bool>& cancelled) {
        return skyOf(file.path, open(file, cancelled)(file.path));
    };
}

}  // namespace vct::app
