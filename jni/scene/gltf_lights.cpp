#include "scene/gltf_lights.h"

#include <algorithm>
#include <optional>

namespace vct {

namespace {

constexpr double quarterTurn = 1.5707963267948966;

std::optional<PunctualLight::Type> typeOf(const std::string& name) {
    if (name == "directional") return PunctualLight::Type::directional;
    if (name == "point") return PunctualLight::Type::point;
    if (name == "spot") return PunctualLight::Type::spot;
    return std::nullopt;
}

void setCone(GltfFile& file, const tinygltf::SpotLight& source, const std::string& name,
             PunctualLight& light) {
    light.innerConeRad = source.innerConeAngle;
    light.outerConeRad = source.outerConeAngle;
    if (!(light.innerConeRad >= 0.0 && light.outerConeRad > 0.0 && light.outerConeRad <= quarterTurn + 1e-6))
        file.fail(name + " has angles of its spot that are not 0 <= inner < outer <= 90 degrees");
    if (light.innerConeRad < light.outerConeRad) return;
    file.warn(name + " has an inner angle of its spot that is not below the outer one, so its edge is hard");
    light.innerConeRad = light.outerConeRad;
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
    const bool isBright = intensity > 0.0;
    light.color = isBright ? glm::vec3(color / largest) : glm::vec3(0.0F);
    light.intensity = isBright ? static_cast<float>(intensity) : 0.0F;
}

}  // namespace

void addLight(GltfFile& file, const PlacedNode& placed, Scene& scene) {
    const auto extension = placed.node->extensions.find("KHR_lights_punctual");
    if (extension == placed.node->extensions.end()) return;
    const bool hasIndex = extension->second.Has("light") && extension->second.Get("light").IsInt();
    const int index = hasIndex ? extension->second.Get("light").GetNumberAsInt() : -1;
    const tinygltf::Light& source = file.at(file.model.lights, index, "light");
    const std::string name = "light " + indexAndName(static_cast<std::size_t>(index), source.name);

    const std::optional<PunctualLight::Type> type = typeOf(source.type);
    if (!type) {
        file.warn(name + " has the unknown type '" + oneLine(source.type) +
                  "' and is left out; the types are directional, point and spot");
        return;
    }
    PunctualLight light;
    light.name = source.name.empty() ? placed.node->name : source.name;
    light.type = *type;
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
    if (light.type == PunctualLight::Type::spot) setCone(file, source.spot, name, light);
    if (light.intensity > 0.0F) scene.punctualLights.push_back(std::move(light));
}

}  // namespace vct
