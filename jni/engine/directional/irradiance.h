// The irradiance of the directional voxels' faces, which pixels look up. Each face keeps what its cached rays
// hit. In each light step the faces are lit from these hits, so light that changes costs no rays. Once the
// light has converged, steps are skipped until something changes.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/baked_light.h"
#include "engine/directional/directional_voxels.h"
#include "engine/directional/light_schedule.h"
#include "engine/programs.h"

namespace vct {

// A program of a light step that does not depend on the number of directions. `name`: of its shader.
gl::ProgramDescription lightProgram(const std::string& name, const LightFeatures& sources);
// A program of a light step that depends on it.
gl::ProgramDescription raysProgram(const std::string& name, const GatherSettings& settings,
                                   const LightFeatures& sources);
gl::ProgramDescription emittersProgram(const LightFeatures& sources);

// The voxels that have come into the cascades along their lower and upper sides, for each axis.
struct ArrivedVoxels {
    CascadeShifts lower{}, upper{};

    void add(const CascadeShifts& moves);
    void addAll(int grid);
    bool any() const { return lower != CascadeShifts{} || upper != CascadeShifts{}; }
};

class Irradiance {
  public:
    // `lightFrames`: as in LightSchedule. `hasObjects`: objects may block the rays of static faces.
    // `listsChange`: faces get other ids, because there are dynamic objects or cascades.
    Irradiance(const gl::ShaderLibrary& shaders, const GatherSettings& settings, int lightFrames,
               bool hasObjects, bool listsChange, int cascades, const LightFeatures& sources);

    // The settings with as many cached rays per face as fit into a storage block of the driver, and with the
    // bits per hit that the ids need.
    static GatherSettings fitting(GatherSettings settings, std::uint32_t ids);
    // True if hits have enough bits for so many ids.
    bool hasBitsFor(std::uint32_t ids) const { return ids <= maxIds(settings_.hitBits); }

    // Reports a change of the voxels, which the next step takes into account.
    // `shifts`: the moves of cascades. `box`: DirectionalVoxels::changed().
    void onVoxelsChanged(const LightSchedule::Change& change, const CascadeShifts& shifts, const Bounds& box);
    // Reports how many cached rays moving objects blocked in an earlier step. The next step has room for as
    // many and some more.
    void onRaysBlocked(std::uint32_t count) {
        if (count > blockedCapacity_) blocked_ = count + count / 2;
    }
    std::uint32_t blockedCapacity() const { return blockedCapacity_; }
    // Reports how many layers the bricks have that an earlier step has placed or had no room for. The next
    // step has room for as many, and for those that moving objects may need in their next pose.
    void onBricksPlaced(const shared::CommandLists& found);
    // Makes the next step start without light and hits.
    void invalidate();
    // Makes the first step take over baked light. `isCurrent`: neither lights nor sky have changed since the
    // scene was made. If moreover all faces are static and have baked light, the first step is the last.
    void useBaked(std::shared_ptr<const BakedLight> light, bool isCurrent) {
        baked_ = std::move(light);
        isBakedCurrent_ = isCurrent;
        schedule_.startLit();
    }
    // The light of the static faces, for one cascade. Waits for the GPU.
    std::vector<BakedLight::Face> bake(const DirectionalVoxels& voxels) const;

    // Steps that are left to convergence, as long as nothing changes.
    int stepsLeft() const { return schedule_.stepsLeft(); }
    // All steps from a change to convergence.
    int stepsToConverge() const { return schedule_.convergenceSteps(); }
    // True if another step would change nothing.
    bool isConverged() const { return schedule_.isConverged() && !pending_.any(); }

    // A light step has three parts: beginStep(), the injection of light if isDirectOutdated(), and gather().
    // The first one reserves buffers, carries the light over to new lists, and finds the light of compact
    // emitters. `objects`: the moving objects as spheres, volume space, at most VCT_MAX_OBJECTS.
    // `allBounces`: faces also reflect their irradiance; false: the first bounce only.
    void beginStep(const DirectionalVoxels& voxels, const std::vector<glm::vec4>& objects, bool allBounces);
    bool isDirectOutdated() const { return plan_.updatesDirect || plan_.updatesEmitters; }
    bool isGatherNeeded() const { return !isBakedStep_ && plan_.gathers; }
    // Dispatches the current program, of directional/visited.glsl, over the faces that the step visits.
    void dispatchOverVisited(const DirectionalVoxels& voxels) const;
    // `waits`: for the GPU's count of blocked rays, so that none of them is left out for want of room.
    void gather(const DirectionalVoxels& voxels, bool waits);
    // True if fillBricks() would change something.
    bool isOutdated(bool visibility) const { return isOutdated_ || showsVisibility_ != visibility; }
    // Brings the bricks up to date: with light, or with ambient visibility.
    void fillBricks(const DirectionalVoxels& voxels, bool visibility);

    // True if the bricks have light, and not ambient visibility.
    bool holdsLight() const { return bricks_ && !showsVisibility_; }
    // The textures for shaders/directional/irradiance.glsl; null before the first step. brickPlaces():
    // for each block and direction, the place of its brick.
    const gl::Texture* bricks() const { return bricks_ ? &*bricks_ : nullptr; }
    const gl::Texture* brickPlaces() const { return brickPlaces_ ? &*brickPlaces_ : nullptr; }
    // The thin walls across the bricks: shaders/directional/walls.glsl.
    const gl::Texture* walls() const { return walls_ ? &*walls_ : nullptr; }
    // The light and the hits of faces by their ids: shaders/directional/face_irradiance.glsl.
    const gl::Buffer& faceIrradiance() const { return faceIrradiance_; }
    // Words per face at the beginning of faceIrradiance().
    std::uint32_t irradianceWords() const {
        return emitters_ > 0 ? VCT_FACE_SEEN_WORD + static_cast<std::uint32_t>(emitters_)
                             : VCT_FACE_IRRADIANCE_WORDS;
    }
    std::vector<const gl::Texture*> textures() const;
    // Binds the buffers and textures that the shaders of a step use.
    void bind(const DirectionalVoxels& voxels) const;

  private:
    void reserveBricks(const DirectionalVoxels& voxels);
    // Returns true if the lists of faces have grown.
    bool reserveFaces(const DirectionalVoxels& voxels, bool keepsHits);
    // The number of ids that hits of so many bits can tell apart.
    static std::uint32_t maxIds(int hitBits) { return (1U << (hitBits - 1)) - VCT_HIT_FACE; }
    // Words for the hits of so many faces.
    std::size_t hitWords(std::uint32_t ids) const;
    // Writes the baked light into the words of the faces. Returns true if all faces have some.
    bool takeBaked(const BakedLight& light, const DirectionalVoxels& voxels,
                   std::vector<std::uint32_t>& words) const;
    void uploadUniforms(const DirectionalVoxels& voxels, const std::vector<glm::vec4>& objects,
                        bool allBounces) const;
    // Dispatches a program over the faces that the step visits; what it writes is visible to the next one.
    void run(const gl::Program& program, const DirectionalVoxels& voxels) const;
    void findBlockedRays(const DirectionalVoxels& voxels, bool waits);
    void runOver(const gl::Program& program, const DirectionalVoxels& voxels, std::uint32_t list) const;
    void runOverAll(const gl::Program& program, const DirectionalVoxels& voxels) const;  // over all faces
    // Gives the faces of dynamic objects the light and the hits of the last pose. `moved`: the cascades whose
    // static geometry has changed, a bit for each. Its new faces get light as well.
    void carryOver(const DirectionalVoxels& voxels, std::uint32_t moved) const;
    // Replaces the hits of static faces that are gone, of those faces whose turn it is. `moved`: as above.
    void forwardHits(const DirectionalVoxels& voxels, std::uint32_t moved);
    // Lists the faces that the next steps visit. `box`: around moving objects, whose surroundings are
    // visited.
    void listVisited(const DirectionalVoxels& voxels, const Bounds& box) const;
    // Places the bricks of some cascades, a bit each, and marks the static walls beside voxels that have come
    // in. `marksAll`: all walls, or those of the faces of listArrived().
    void placeBricks(const DirectionalVoxels& voxels, std::uint32_t placed, const ArrivedVoxels& arrived,
                     bool marksAll) const;
    // Fills the bricks with the faces of some cascades, of all faces or of those that the step visits.
    void fillFrom(const DirectionalVoxels& voxels, std::uint32_t cascades, bool visitsAll) const;
    // Marks the walls of a list's faces in a texture of their words.
    void markWalls(const DirectionalVoxels& voxels, std::uint32_t list, const gl::Texture& words,
                   bool marksAll) const;
    // Lists the static faces that have others around them since voxels have come in.
    void listArrived(const DirectionalVoxels& voxels, const ArrivedVoxels& arrived) const;
    // Links faces to those beside them: dynamic faces and static ones in a box, or the faces of
    // listArrived().
    void linkFaces(const DirectionalVoxels& voxels, bool visitsAll, const Bounds& box) const;

    GatherSettings settings_;
    int lightFrames_, cascades_;
    bool hasObjects_, listsChange_;
    LightSchedule schedule_;
    LightPlan plan_;
    LightSchedule::Change pending_;        // changes that no step has taken into account yet
    ArrivedVoxels pendingVoxels_;          // the voxels that cascades have reached by them,
    Bounds pendingBox_ = noBounds;         // and the box in which moving objects have changed static faces
    std::uint32_t forwardedCascades_ = 0;  // the cascades whose lost hits forward_hits replaces, a bit each,
    std::uint32_t forwardTurns_ = 0;       // in so many steps from now on
    gl::Program clearBricks_, placeBricks_, markWalls_, linkFaces_, sky_, trace_, gather_, refine_,
        smoothRows_, smooth_, fillBricks_;
    std::optional<gl::Program> carryOver_, carryHits_, traceMoving_;  // only with dynamic objects or cascades
    std::optional<gl::Program> forwardHits_, listVisited_, listArrived_;  // only with cascades
    std::optional<gl::Program> block_;                                    // only with moving objects
    std::optional<gl::Program> findEmitters_;  // only if the scene has compact emitters
    int emitters_;                             // LightFeatures::emitters
    std::shared_ptr<const BakedLight> baked_;  // until the first step; null: none
    bool isBakedCurrent_ = false;
    bool isBakedStep_ = false;  // the present step took over all of its light
    std::uint32_t unplacedCascades_ = DirectionalVoxels::allCascades;  // the next step has to place the
                                                                       // bricks of these cascades, a bit each
    bool marksAllWalls_ = true;         // the next step has to mark all static walls
    bool isOutdated_ = true;            // the bricks do not show the last step
    std::uint32_t placedCascades_ = 0;  // the bricks of these cascades, a bit each, have to be filled
    bool showsVisibility_ = false;      // the bricks have ambient visibility
    gl::Buffer uniforms_, faceIrradiance_;
    std::optional<gl::Texture> bricks_, brickPlaces_, walls_;
    std::optional<gl::Texture> staticWalls_;  // only of one cube
    FaceCapacities capacities_{};             // of the lists whose faces faceIrradiance_ has room for
    std::uint32_t idCapacity_ = 0, blockedCapacity_ = 0, blocked_ = 0;
    std::array<shared::BrickRoom, VCT_MAX_CASCADES> brickRooms_{};
    std::uint32_t brickLayers_ = 0;
};

}  // namespace vct
