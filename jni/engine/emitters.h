// Compact emitters: small surfaces that emit light, such as lamps. The few rays that a face gathers with hit
// or miss them at random, which is noise. So they are divided into parts, and each face traces rays
// towards each part (shaders/directional/emitters.comp). Large emitters need no such rays, because the
// rays of the gather hit them often enough.
#pragma once

#include <optional>
#include <vector>

#include "engine/resource.h"
#include "engine/volume.h"
#include "gl/objects.h"
#include "scene/scene.h"
#include "shared/layout.h"

namespace vct {

// Some triangles of one instance, treated as one light source. World space, rest pose.
struct EmitterPart {
    std::size_t instance;  // index into Scene::instances
    glm::dvec3 centre;     // mean weighted by area
    glm::dvec3 facing;     // square metres: sum of the triangles' normals, each as long as its area
    double area;           // square metres; double-sided triangles count twice
    glm::dvec3 radiance;   // mean weighted by area, in the scene's unit
    double radius;         // metres, around the centre
    double halfDepth;      // metres, along `facing`; equals `radius` if the part is round
    glm::dvec3 side;       // metres: half a side of the rectangle that fits the part; zero if it is round

    double flux() const;   // flux over pi of the brightest colour channel
    bool isRound() const;  // emits evenly to all sides, as a closed surface does
};

// The parts of a scene's compact emitters, except those whose textures are the embedding program's, in order
// of the emitters' flux, largest first. Emitters that do not fit into VCT_MAX_EMITTER_PARTS are left out. A
// part has a radius of at most five voxels of a grid of 64, as far as triangles can be cut that small. With
// smaller voxels it is five of them, or more where fewer emitters would be compact otherwise: a finer grid is
// never noisier.
std::vector<EmitterPart> emitterParts(const Scene& scene, const Volume& volume);
// For each of the scene's instances: true if it is a compact emitter.
std::vector<bool> emittingInstances(const Scene& scene, const std::vector<EmitterPart>& parts);

// The parts in the present pose, as uniforms for shaders/shared/emitters.glsl.
class Emitters {
  public:
    // `radianceUnit`: the radiance that is 1 in shaders, in the scene's unit.
    Emitters(const Scene& scene, const std::vector<EmitterPart>& parts, const Volume& volume,
             float radianceUnit);

    // Uploads the parts in that pose at once.
    void setPose(const Pose& pose);
    // Scales the radiance of the parts that this animation node moves; 0: they are off and cost nothing.
    void setScale(int node, float scale);
    void bind() const { uniforms_.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_EMITTERS); }
    // For each of the scene's instances: true if it is a compact emitter.
    // Replaces the radiance of an instance, which has no texture.
    void setRadiance(std::size_t instance, const glm::vec3& radiance);
    const std::vector<bool>& instances() const { return instances_; }
    const gl::Buffer& uniforms() const { return uniforms_; }
    // Words of a face for what it sees of the parts, of VCT_SEEN_PARTS each.
    int words() const { return (static_cast<int>(parts_.size()) + VCT_SEEN_PARTS - 1) / VCT_SEEN_PARTS; }

  private:
    struct Placed {
        EmitterPart part;
        int node;                    // animation node that moves the part, or -1
        glm::dmat4 objectFromWorld;  // rest pose
        float scale = 1.0F;
    };
    void upload() const;

    std::vector<Placed> parts_;
    std::optional<Pose> pose_;
    std::vector<bool> instances_;
    Volume volume_;
    float radianceUnit_;
    gl::Buffer uniforms_;
};

}  // namespace vct
