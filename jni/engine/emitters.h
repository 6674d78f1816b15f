// Small surfaces that glow, as lamps. Among the few directions into which a face gathers light it meets them
// by chance; so they are divided into parts, and each face of the voxels looks at each part by a cone of its
// own (shaders/directional/emitters.comp). Large ones stay with the other cones: those meet them often
// enough.
#pragma once

#include <vector>

#include "engine/resource.h"
#include "engine/volume.h"
#include "gl/objects.h"
#include "scene/scene.h"
#include "shared/layout.h"

namespace vct {

// Some of an instance's triangles, seen from afar as one source. World space, at rest.
struct EmitterPart {
    std::size_t instance;  // of Scene::instances
    glm::dvec3 centre;     // by area
    glm::dvec3 facing;     // square metres: the sum of the triangles' normals, as long as they are large
    double area;           // square metres, both sides of double-sided triangles
    glm::dvec3 radiance;   // the mean by area, in the scene's unit
    double radius;         // metres, around the centre
    double halfDepth;      // metres, along `facing`; the radius where it is round
    glm::dvec3 side;  // metres: half of one side of the rectangle that it is nearly; zero where it is round
    double flux() const;   // over pi, of the brightest colour
    bool isRound() const;  // sends the same to all sides, as closed surfaces do
};

// Of all lamps of a scene, the brightest first: those for which there is room. None is farther across than
// ten voxels, but for large triangles.
std::vector<EmitterPart> emitterParts(const Scene& scene, const Volume& volume);

// Whether each of the scene's instances is a lamp.
std::vector<bool> emittingInstances(const Scene& scene, const std::vector<EmitterPart>& parts);

// The parts as they are now, for shaders/shared/emitters.glsl.
class Emitters {
  public:
    // `radianceUnit`: radiance that is 1 in shaders.
    Emitters(const Scene& scene, const std::vector<EmitterPart>& parts, const Volume& volume,
             float radianceUnit);

    // Moves those that move, at once.
    void setPose(const Pose& pose);
    void bind() const { uniforms_.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_EMITTERS); }
    // Which of the scene's instances they are of.
    const std::vector<bool>& instances() const { return instances_; }
    const gl::Buffer& uniforms() const { return uniforms_; }

  private:
    struct Placed {
        EmitterPart part;
        int node;                    // that moves it, or -1
        glm::dmat4 objectFromWorld;  // at rest
    };
    void upload(const Pose* pose) const;

    std::vector<Placed> parts_;
    std::vector<bool> instances_;
    Volume volume_;
    float radianceUnit_;
    gl::Buffer uniforms_;
};

}  // namespace vct
