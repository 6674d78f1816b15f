#include "lab/shader_counters.h"

#include <array>

#include "gl/objects.h"

namespace vct {

namespace {

struct Loop {
    const char* name;
    int depth;
    int counter;
    bool constant = false;  // its length: the compiler may unroll it
    double times = 1.0;     // iterations per count: of loops that follow from what they are in
};

struct Stage {
    const char* shader;
    int invocations;
    std::vector<Loop> loops;
};

// Every counter of shared/layout.h, with the loops in the order in which main() comes to them.
const std::vector<Stage>& stages() {
    static const std::vector<Stage> all{
        {"passes/shadow_map.frag", VCT_COUNTER_SHADOW_MAP, {}},
        {"passes/shadow_moments.frag", VCT_COUNTER_SHADOW_MOMENTS, {}},
        {"passes/shadow_moments_next.frag", VCT_COUNTER_SHADOW_MOMENTS_NEXT, {}},
        {"passes/g_buffer.frag", VCT_COUNTER_G_BUFFER, {}},
        {"packed/clear.comp", VCT_COUNTER_SPARSE_CLEAR, {{"voxel", 0, VCT_COUNTER_SPARSE_CLEAR_VOXEL}}},
        {"packed/voxelizer.frag", VCT_COUNTER_VOXELIZER, {}},
        {"packed/mipmapper.comp", VCT_COUNTER_MIPMAPPER, {{"voxel", 0, VCT_COUNTER_MIPMAPPER_VOXEL}}},
        {"directional/clear.comp", VCT_COUNTER_FACE_CLEAR, {{"face", 0, VCT_COUNTER_FACE_CLEAR_FACE}}},
        {"directional/clear_base.comp",
         VCT_COUNTER_FACE_CLEAR_BASE,
         {{"voxel", 0, VCT_COUNTER_FACE_CLEAR_BASE_VOXEL},
          {"face", 1, VCT_COUNTER_FACE_CLEAR_BASE_FACE},
          {"word", 2, VCT_COUNTER_FACE_CLEAR_BASE_FACE, true, VCT_FACE_SUM_WORDS}}},
        {"directional/occupancy.frag", VCT_COUNTER_FACE_TOUCH, {}},
        {"directional/voxelizer.frag",
         VCT_COUNTER_FACE_VOXELIZER,
         {{"whether empty", 0, VCT_COUNTER_FACE_VOXELIZER, true, 3},
          {"axis", 0, VCT_COUNTER_FACE_VOXELIZER_AXIS}}},
        {"directional/clear_radiance.comp",
         VCT_COUNTER_FACE_DARKEN,
         {{"voxel", 0, VCT_COUNTER_FACE_DARKEN_VOXEL},
          {"face", 1, VCT_COUNTER_FACE_DARKEN_FACE},
          {"channel", 2, VCT_COUNTER_FACE_DARKEN_FACE, true, 3}}},
        {"directional/resolve.comp",
         VCT_COUNTER_FACE_RESOLVE,
         {{"voxel", 0, VCT_COUNTER_FACE_RESOLVE_VOXEL},
          {"listed", 1, VCT_COUNTER_FACE_RESOLVE_LISTED},
          {"listed parent", 1, VCT_COUNTER_FACE_RESOLVE_PARENT},
          {"face", 1, VCT_COUNTER_FACE_RESOLVE_FACE}}},
        {"directional/mipmapper.comp",
         VCT_COUNTER_FACE_MIPMAPPER,
         {{"face", 0, VCT_COUNTER_FACE_MIPMAPPER_FACE},
          {"pair", 1, VCT_COUNTER_FACE_MIPMAPPER_FACE, true, 4}}},
        {"directional/light_inherit.comp",
         VCT_COUNTER_LIGHT_INHERIT,
         {{"face", 0, VCT_COUNTER_LIGHT_INHERIT_FACE}}},
        {"directional/light_clear.comp",
         VCT_COUNTER_LIGHT_CLEAR,
         {{"texel", 0, VCT_COUNTER_LIGHT_CLEAR_TEXEL}, {"place", 0, VCT_COUNTER_LIGHT_CLEAR_PLACE}}},
        {"directional/light_bricks.comp",
         VCT_COUNTER_LIGHT_BRICKS,
         {{"face", 0, VCT_COUNTER_LIGHT_BRICKS_FACE}}},
        {"directional/light_shine.comp",
         VCT_COUNTER_LIGHT_SHINE,
         {{"face", 0, VCT_COUNTER_LIGHT_SHINE_FACE}}},
        {"directional/light_blocks.comp", VCT_COUNTER_LIGHT_BLOCKS, {}},
        {"directional/emitters.comp",
         VCT_COUNTER_EMITTERS,
         {{"face", 0, VCT_COUNTER_EMITTERS_FACE},
          {"cone", 1, VCT_COUNTER_EMITTERS_CONE},
          {"step", 2, VCT_COUNTER_EMITTERS_STEP}}},
        {"directional/irradiance.comp",
         VCT_COUNTER_IRRADIANCE,
         {{"face", 0, VCT_COUNTER_IRRADIANCE_FACE},
          {"cone", 1, VCT_COUNTER_IRRADIANCE_CONE},
          {"step", 2, VCT_COUNTER_IRRADIANCE_STEP},
          {"brick", 1, VCT_COUNTER_IRRADIANCE_BRICK},
          {"sum", 0, VCT_COUNTER_IRRADIANCE, true, 13}}},
        {"passes/shade.frag",
         VCT_COUNTER_CONE_TRACER,
         {{"diffuse cone", 0, VCT_COUNTER_DIFFUSE_CONE, true},
          {"diffuse step", 1, VCT_COUNTER_DIFFUSE_STEP},
          {"received nearby", 0, VCT_COUNTER_RECEIVED_NEARBY},
          {"axis of the received light", 1, VCT_COUNTER_RECEIVED_AXIS},
          {"shadow step", 0, VCT_COUNTER_SHADOW_STEP},
          {"blocker tap", 0, VCT_COUNTER_BLOCKER_TAP, true},
          {"filter tap", 0, VCT_COUNTER_FILTER_TAP, true},
          {"specular step", 0, VCT_COUNTER_SPECULAR_STEP}}},
    };
    return all;
}

}  // namespace

std::vector<StageCount> countInvocations(Renderer& renderer, Output mode, const Camera& camera) {
    renderer.render({{mode}, camera});  // a first frame has nothing to clear
    std::array<std::uint32_t, VCT_COUNTER_COUNT> counts{};
    const gl::Buffer counters("shader counters", GL_SHADER_STORAGE_BUFFER, sizeof counts, counts.data(),
                              GL_DYNAMIC_COPY);
    counters.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_COUNTERS);
    renderer.render({{mode}, camera});
    counters.read(counts.data(), sizeof counts);

    std::vector<StageCount> found;
    for (const Stage& stage : stages()) {
        if (counts[stage.invocations] == 0) continue;
        StageCount count{stage.shader, counts[stage.invocations], {}};
        for (const Loop& loop : stage.loops)
            if (counts[loop.counter] > 0)
                count.loops.push_back({loop.name, loop.depth, loop.constant,
                                       loop.times * static_cast<double>(counts[loop.counter])});
        found.push_back(std::move(count));
    }
    return found;
}

}  // namespace vct
