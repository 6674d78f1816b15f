// Values that several commands parse from text.
#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <utility>
#include <vector>

#include "scene/scene.h"

namespace vct {

// Of "command a=1 b=2": hands each value to the function of its name. Throws vct::Error listing the names
// where there is none.
using NamedSetters = std::vector<std::pair<std::string, std::function<void(const std::string& value)>>>;
void setFromWords(const std::string& text, const NamedSetters& setters);

double numberFromText(const std::string& option, const std::string& text);

// A number from 1 to `most`; `option` is its name in the error.
int wholeNumberFromText(const std::string& option, const std::string& text, int most);

// "400x300" -> (400, 300).
glm::ivec2 sizeFromText(const std::string& text);

// "eye=X,Y,Z,target=X,Y,Z,fov=DEG,up=X,Y,Z", or the name or index of one of the scene's cameras, for a
// picture of `aspect` (width over height); "" takes the first, or a view of the scene where it has none.
Camera cameraFromText(const std::string& text, const Scene& scene, double aspect = 1.0);

// "direction=X,Y,Z,color=R,G,B,intensity=LUX" over the scene's first light; each part may be left out.
// `direction` is the way the light travels, as a glTF light's -Z.
DirectionalLight lightFromText(const std::string& text, const Scene& scene);

// "R,G,B" -> linear RGB.
glm::vec3 colorFromText(const std::string& option, const std::string& text);

}  // namespace vct
