// Explains pictures that are black or show nothing.
#pragma once

#include <string>

#include "engine/settings.h"
#include "image/image.h"
#include "scene/scene.h"

namespace vct::cli {

// Returns a warning, one line, that says why a picture has the same colour everywhere, and what to do about
// it. Returns "" for other pictures, and if an evenly lit surface fills the picture. `cameraText` is the text
// of --camera.
std::string emptyPictureWarning(const Image& image, const Scene& scene, const Camera& camera,
                                const std::string& cameraText, const DirectionalLight& light,
                                const Settings& settings);

}  // namespace vct::cli
