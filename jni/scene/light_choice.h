// Chooses sun and sky for scenes whose file may not have any.
#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"

namespace vct {

// True if the scene is a room without any light but with emitters. Materials with an emissive texture do not
// count.
bool isLitByEmitters(const Scene& scene);
// Returns the scene's sun. If the scene has none:
// - If it has other lights, returns a black sun. Its intensity is the illuminance that the strongest of them
//   gives at a distance of a quarter of the scene's size; the renderer uses it as the unit of radiance.
// - If it is a room with untextured emitters, returns the default sun with intensity 0. (A textured emitter
//   such as the dial of an instrument gives too little light, and so does any emitter in the open.)
// - If it is a product (isInStudio()), returns a weaker default sun, the key light of a studio.
// - Otherwise returns defaultLight().
DirectionalLight chooseLight(const Scene& scene);
// Returns a light for a scene without any light whose camera is in a closed room or shows one, where
// neither sun nor sky would reach; none for other scenes. It gives surfaces in the room about the illuminance
// of the default sun.
std::optional<PunctualLight> chooseRoomLight(const Scene& scene, const Camera& camera);
// True if the scene's only light is one that was added by chooseRoomLight().
bool isLitByRoomLight(const Scene& scene);
// A note for the user about that light, one line.
std::string roomLightNote(const PunctualLight& light);
// A sun from the upper front right with an illuminance of pi.
DirectionalLight defaultLight();
// True if the light has a colour and an intensity.
bool isOn(const DirectionalLight& light);
// The radiance of the sky of a scene for which nobody chose one. If its sun is on, plainSky(), because
// exporters write the sun alone, or in a studio a soft white one; otherwise black. `light` is that of
// chooseLight(), which is off in a scene that lamps or emitters light.
glm::vec3 chooseSky(const Scene& scene, const DirectionalLight& light);
// True if the scene has no light and is a product (isProduct()), which gets the light of a studio: a key
// light and a soft sky.
bool isInStudio(const Scene& scene);
// The radiance of a light blue sky that gives a floor a quarter of the illuminance of `light`, or of the
// default light if `light` is off.
glm::vec3 plainSky(const DirectionalLight& light);

// Returns the radiance to show behind a scene under a plain sky of this radiance: the sky's, or a part of it
// if surfaces in the sky's light would be as bright where they border on it, as white ones are.
glm::vec3 chooseBackground(const Scene& scene, const Camera& camera, double aspect, const glm::vec3& sky);
// The background of a scene without a sun and a sky, such as one with lights in a room: a dim sky, so that
// its windows are not black. `light` is that of chooseLight().
glm::vec3 dimSky(const DirectionalLight& light);

}  // namespace vct
