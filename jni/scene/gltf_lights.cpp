#include "scene/gltf_lights.h"

#include <algorithm>
#include <optional>

namespace vct {

namespace {

constexpr double quarterTurn = 1.5707963267948966;

PunctualLight::Type typeOf(const GltfFile& file, const tinygltf::Light& source, const std::string& name) {
    if (source.type == "directional") return PunctualLight::Type::directional;
    if (source.type == "point") return PunctualLight::Type::point;
    if (source.type == "spot") return PunctualLight::Type::spot;
    file.fail(name + " has the unknown type '" + oneLine(source.type) +
              "'; the types are directional, point and spot");
}

// Sets colour and intensity so that the largest component of the colour is 1.
void setStrength(const GltfFile& file, const tinygltf::Light& source, const std::string& name,
                 PunctualLight& light) {
    glm::dvec3 color(1.0);
    if (!source.color.empty()) {
        if (source.color.size() != 3) file.fail(name + " has a colour that is not three numbers");
        color = {source.color[0], source.color[1], source.color[2]};
    }
    if (std::min(color.x, std::min(color.y, color.z)) < 0.0) file.fail(name + " has a negative colour");
    if (source.intensity < 0.0) file.fail(name + " has a negative intensity");
    const double largest = std::max(color.x, std::max(color.y, color.z));
    const double intensity = source.intensity * largest;
    if (!(intensity <= 1e30)) file.fail(name + " has an intensity that is not a usable number");
    const bool shines = intensity > 0.0;
    light.color = shines ? glm::vec3(color / largest) : glm::vec3(0.0F);
    light.intensity = shines ? static_cast<float>(intensity) : 0.0F;
}

}  // namespace

void addLight(GltfFile& file, const PlacedNode& placed, Scene& scene) {
    const auto extension = placed.node->extensions.find("KHR_lights_punctual");
    if (extension == placed.node->extensions.end()) return;
    const bool hasIndex = extension->second.Has("light") && extension->second.Get("light").IsInt();
    const int index = hasIndex ? extension->second.Get("light").GetNumberAsInt() : -1;
    const tinygltf::Light& source = file.at(file.model.lights, index, "light");
    const std::string name = "light " + indexAndName(static_cast<std::size_t>(index), source.name);

    PunctualLight light;
    light.name = source.name.empty() ? placed.node->name : source.name;
    light.type = typeOf(file, source, name);
    light.node = placed.moving;
    setStrength(file, source, name, light);
    const std::optional<glm::dmat4> axes = withoutScale(placed.worldFromNode);
    if (axes)
        light.worldFromLight = *axes;
    else if (light.type != PunctualLight::Type::point) {
        file.warn("a light without a direction (zero scale) is left out");
        return;
    }
    light.worldFromLight[3] = placed.worldFromNode[3];
    if (light.type == PunctualLight::Type::directional && scene.lights.empty()) {
        scene.lights.push_back(
            {glm::dvec3(light.worldFromLight[2]), light.color, light.intensity, light.node});
        return;
    }
    if (light.type != PunctualLight::Type::directional && source.range != 0.0) {
        if (!(source.range > 0.0)) file.fail(name + " has a range that is not above 0");
        light.range = source.range;
    }
    if (light.type == PunctualLight::Type::spot) {
        light.innerConeRad = source.spot.innerConeAngle;
        light.outerConeRad = source.spot.outerConeAngle;
        if (!(light.innerConeRad >= 0.0 && light.innerConeRad < light.outerConeRad &&
              light.outerConeRad <= quarterTurn + 1e-6))
            file.fail(name + " has cone angles that are not 0 <= inner < outer <= 90 degrees");
    }
    if (light.intensity > 0.0F) scene.punctualLights.push_back(std::move(light));
}

}  // namespace vct
