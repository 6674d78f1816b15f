// Parses values of options and of the app's commands from text.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace vct {

// Parses "command a=1 b=two words": calls the function of each name with its value. Throws vct::Error listing
// the names if one is unknown.
using NamedSetters = std::vector<std::pair<std::string, std::function<void(const std::string& value)>>>;
void setFromWords(const std::string& text, const NamedSetters& setters);

// The functions below throw vct::Error; `option` is the name of the value in the message.
double numberFromText(const std::string& option, const std::string& text);

// Parses a whole number from 1 to `most`.
int wholeNumberFromText(const std::string& option, const std::string& text, int most);

// Parses "400x300".
glm::ivec2 sizeFromText(const std::string& text);

// Returns the camera of "eye=X,Y,Z,target=X,Y,Z,fov=DEG,up=X,Y,Z", or one of the scene's cameras by name or
// index, fitted to a picture of `aspect` (width over height). "" takes the scene's first camera, or frames
// the scene if it has none.
Camera cameraFromText(const std::string& text, const Scene& scene, double aspect = 1.0);

// Changes the scene's sun by "direction=X,Y,Z,color=R,G,B,intensity=LUX"; each part may be left out.
// `direction` is the one in which the light travels, the -Z of a glTF light.
DirectionalLight lightFromText(const std::string& text, const Scene& scene);

// Parses a radiance: "R,G,B" in linear RGB, one number for grey, "#rrggbb" in sRGB, or one of a few names.
glm::vec3 colorFromText(const std::string& option, const std::string& text);

}  // namespace vct
