#include "lab/shader_counters.h"

#include <array>

#include "gl/objects.h"

namespace vct {

namespace {

struct Loop {
    const char* name;
    int depth;
    int counter;
    bool constant = false;  // its length is constant, so the compiler may unroll it
    double times = 1.0;     // iterations per count, for loops that share the counter of an outer loop
};

struct Stage {
    const char* shader;
    int invocations;
    std::vector<Loop> loops;
};

// Every counter of shared/layout.h. The loops are in the order in which main() runs them.
const std::vector<Stage>& stages() {
    static const std::vector<Stage> all{
        {"passes/shadow_map.frag", VCT_COUNTER_SHADOW_MAP, {}},
        {"passes/shadow_level.frag", VCT_COUNTER_SHADOW_LEVEL, {}},
        {"passes/g_buffer.frag", VCT_COUNTER_G_BUFFER, {}},
        {"packed/clear.comp", VCT_COUNTER_SPARSE_CLEAR, {{"voxel", 0, VCT_COUNTER_SPARSE_CLEAR_VOXEL}}},
        {"packed/voxelizer.frag", VCT_COUNTER_VOXELIZER, {}},
        {"packed/mipmapper.comp", VCT_COUNTER_MIPMAPPER, {{"voxel", 0, VCT_COUNTER_MIPMAPPER_VOXEL}}},
        {"directional/clear_dynamic.comp",
         VCT_COUNTER_CLEAR_DYNAMIC,
         {{"face", 0, VCT_COUNTER_CLEAR_DYNAMIC_FACE},
          {"word", 1, VCT_COUNTER_CLEAR_DYNAMIC_FACE, true, VCT_FACE_SUM_WORDS}}},
        {"directional/clear_blocks.comp", VCT_COUNTER_FACE_CLEAR, {{"face", 0, VCT_COUNTER_FACE_CLEAR_FACE}}},
        {"directional/reset_lists.comp", VCT_COUNTER_RESET_LISTS, {}},
        {"directional/mark_static.comp", VCT_COUNTER_MARK_STATIC, {}},
        {"directional/unlist_static.comp",
         VCT_COUNTER_UNLIST_STATIC,
         {{"face", 0, VCT_COUNTER_UNLIST_STATIC_FACE}}},
        {"directional/scroll.comp",
         VCT_COUNTER_SCROLL,
         {{"face", 0, VCT_COUNTER_SCROLL_FACE},
          {"face of the voxel", 1, VCT_COUNTER_SCROLL_OF_VOXEL},
          {"word", 2, VCT_COUNTER_SCROLL_OF_VOXEL, true, VCT_FACE_SUM_WORDS}}},
        {"directional/mark_faces.frag", VCT_COUNTER_MARK_FACES, {}},
        {"directional/list_faces.comp",
         VCT_COUNTER_LIST_FACES,
         {{"voxel", 0, VCT_COUNTER_LIST_FACES_VOXEL},
          {"face", 1, VCT_COUNTER_LIST_FACES_FACE},
          {"face in its block", 1, VCT_COUNTER_LIST_FACES_FACE},
          {"face of a block", 1, VCT_COUNTER_LIST_FACES_BLOCK_FACE}}},
        {"directional/fill_blocks.comp",
         VCT_COUNTER_FILL_BLOCKS,
         {{"octant", 0, VCT_COUNTER_FILL_BLOCKS_OCTANT, true}}},
        {"directional/accumulate.frag", VCT_COUNTER_ACCUMULATE, {{"face", 0, VCT_COUNTER_ACCUMULATE_FACE}}},
        {"directional/inject.comp",
         VCT_COUNTER_INJECT,
         {{"face", 0, VCT_COUNTER_INJECT_FACE}, {"point", 1, VCT_COUNTER_INJECT_POINT, true}}},
        {"directional/resolve.comp",
         VCT_COUNTER_RESOLVE,
         {{"face", 0, VCT_COUNTER_RESOLVE_FACE},
          {"point", 1, VCT_COUNTER_RESOLVE_FACE, true, 16},
          {"other face", 1, VCT_COUNTER_RESOLVE_OTHER},
          {"point of the plane", 2, VCT_COUNTER_RESOLVE_POINT}}},
        {"directional/carry_over.comp",
         VCT_COUNTER_CARRY_OVER,
         {{"face", 0, VCT_COUNTER_CARRY_OVER_FACE},
          {"neighbour", 1, VCT_COUNTER_CARRY_OVER_NEIGHBOUR},
          {"word cleared", 1, VCT_COUNTER_CARRY_OVER_FACE, true, VCT_FACE_IRRADIANCE_WORDS},
          {"word copied", 1, VCT_COUNTER_CARRY_OVER_FACE, false, VCT_FACE_IRRADIANCE_WORDS}}},
        {"directional/clear_bricks.comp",
         VCT_COUNTER_BRICKS_CLEAR,
         {{"texel", 0, VCT_COUNTER_BRICKS_CLEAR_TEXEL}, {"place", 0, VCT_COUNTER_BRICKS_CLEAR_PLACE}}},
        {"directional/place_bricks.comp",
         VCT_COUNTER_PLACE_BRICKS,
         {{"face", 0, VCT_COUNTER_PLACE_BRICKS_FACE}, {"block aside", 1, VCT_COUNTER_PLACE_BRICKS_ASIDE}}},
        {"directional/mark_walls.comp",
         VCT_COUNTER_MARK_WALLS,
         {{"face", 0, VCT_COUNTER_MARK_WALLS_FACE},
          {"surface", 1, VCT_COUNTER_MARK_WALLS_SURFACE},
          {"crossed face", 2, VCT_COUNTER_MARK_WALLS_CROSSED},
          {"brick", 3, VCT_COUNTER_MARK_WALLS_BRICK},
          {"word", 4, VCT_COUNTER_MARK_WALLS_WORD}}},
        {"directional/carry_hits.comp",
         VCT_COUNTER_CARRY_HITS,
         {{"face", 0, VCT_COUNTER_CARRY_HITS_FACE}, {"four hits", 1, VCT_COUNTER_CARRY_HITS_FOUR, true}}},
        {"directional/list_blocks.comp", VCT_COUNTER_LIST_BLOCKS, {}},
        {"directional/list_free.comp", VCT_COUNTER_LIST_FREE, {{"word", 0, VCT_COUNTER_LIST_FREE_WORD}}},
        {"directional/forward_hits.comp",
         VCT_COUNTER_FORWARD_HITS,
         {{"face", 0, VCT_COUNTER_FORWARD_HITS_FACE}, {"four hits", 1, VCT_COUNTER_FORWARD_HITS_FOUR, true}}},
        {"directional/list_visited.comp",
         VCT_COUNTER_LIST_VISITED,
         {{"face", 0, VCT_COUNTER_LIST_VISITED_FACE}}},
        {"directional/smooth_rows.comp",
         VCT_COUNTER_SMOOTH_ROWS,
         {{"face", 0, VCT_COUNTER_SMOOTH_ROWS_FACE},
          {"neighbour", 1, VCT_COUNTER_SMOOTH_ROWS_FACE, true, 4}}},
        {"directional/smooth.comp",
         VCT_COUNTER_SMOOTH,
         {{"face", 0, VCT_COUNTER_SMOOTH_FACE}, {"neighbour", 1, VCT_COUNTER_SMOOTH_FACE, true, 4}}},
        {"directional/fill_bricks.comp",
         VCT_COUNTER_FILL_BRICKS,
         {{"face", 0, VCT_COUNTER_FILL_BRICKS_FACE}, {"texel", 1, VCT_COUNTER_FILL_BRICKS_TEXEL}}},
        {"directional/emitters.comp",
         VCT_COUNTER_EMITTERS,
         {{"face", 0, VCT_COUNTER_EMITTERS_FACE},
          {"part", 1, VCT_COUNTER_EMITTERS_PART},
          {"ray", 2, VCT_COUNTER_EMITTERS_RAY},
          {"cascade", 3, VCT_COUNTER_EMITTERS_RAY, true},
          {"walk", 4, VCT_COUNTER_EMITTERS_WALK},
          {"step", 5, VCT_COUNTER_EMITTERS_WALK + 1},
          {"face of a voxel", 5, VCT_COUNTER_EMITTERS_WALK + 2},
          {"limit", 6, VCT_COUNTER_EMITTERS_WALK + 3},
          {"object", 2, VCT_COUNTER_EMITTERS_OBJECT}}},
        {"directional/trace.comp",
         VCT_COUNTER_TRACE,
         {{"face", 0, VCT_COUNTER_TRACE_FACE},
          {"hit invalidated", 1, VCT_COUNTER_TRACE_FACE, true, 0.0},
          {"ray", 1, VCT_COUNTER_TRACE_RAY},
          {"known ray", 2, VCT_COUNTER_TRACE_RAY},
          {"cascade", 2, VCT_COUNTER_TRACE_RAY, true},
          {"walk", 3, VCT_COUNTER_TRACE_WALK},
          {"step", 4, VCT_COUNTER_TRACE_WALK + 1},
          {"face of a voxel", 4, VCT_COUNTER_TRACE_WALK + 2},
          {"limit", 5, VCT_COUNTER_TRACE_WALK + 3}}},
        {"directional/sky.comp",
         VCT_COUNTER_SKY,
         {{"face", 0, VCT_COUNTER_SKY_FACE}, {"hit", 1, VCT_COUNTER_SKY_HIT, true}}},
        {"directional/block.comp",
         VCT_COUNTER_BLOCK,
         {{"face", 0, VCT_COUNTER_BLOCK_FACE},
          {"object", 1, VCT_COUNTER_BLOCK_OBJECT},
          {"ray before four objects", 1, VCT_COUNTER_BLOCK_RAY},
          {"ray past an object", 1, VCT_COUNTER_BLOCK_TRACE},
          {"cascade", 2, VCT_COUNTER_BLOCK_TRACE, true},
          {"walk", 3, VCT_COUNTER_BLOCK_WALK},
          {"step", 4, VCT_COUNTER_BLOCK_WALK + 1},
          {"face of a voxel", 4, VCT_COUNTER_BLOCK_WALK + 2},
          {"limit", 5, VCT_COUNTER_BLOCK_WALK + 3}}},
        {"directional/gather.comp",
         VCT_COUNTER_GATHER,
         {{"face", 0, VCT_COUNTER_GATHER_FACE},
          {"four hits", 1, VCT_COUNTER_GATHER_HITS, true},
          {"blocked ray", 1, VCT_COUNTER_GATHER_BLOCKED}}},
        {"directional/refine.comp",
         VCT_COUNTER_REFINE,
         {{"face", 0, VCT_COUNTER_REFINE_FACE},
          {"ray", 1, VCT_COUNTER_REFINE_RAY},
          {"cascade", 2, VCT_COUNTER_REFINE_RAY, true},
          {"walk", 3, VCT_COUNTER_REFINE_WALK},
          {"step", 4, VCT_COUNTER_REFINE_WALK + 1},
          {"face of a voxel", 4, VCT_COUNTER_REFINE_WALK + 2},
          {"limit", 5, VCT_COUNTER_REFINE_WALK + 3}}},
        {"passes/shade.frag",
         VCT_COUNTER_CONE_TRACER,
         {{"diffuse cone", 0, VCT_COUNTER_DIFFUSE_CONE, true},
          {"diffuse step", 1, VCT_COUNTER_DIFFUSE_STEP},
          {"irradiance nearby", 0, VCT_COUNTER_IRRADIANCE_NEARBY},
          {"axis of the irradiance", 1, VCT_COUNTER_IRRADIANCE_AXIS},
          {"shadow step", 0, VCT_COUNTER_SHADOW_STEP},
          {"blocker tap", 0, VCT_COUNTER_BLOCKER_TAP, true},
          {"filter tap", 0, VCT_COUNTER_FILTER_TAP, true}}},
        {"passes/gloss_mark.frag", VCT_COUNTER_GLOSS_MARK, {}},
        {"passes/gloss_half.frag",
         VCT_COUNTER_GLOSS_HALF,
         {{"ray", 0, VCT_COUNTER_GLOSS_HALF_RAY, true},
          {"cascade", 1, VCT_COUNTER_GLOSS_HALF_RAY, true},
          {"walk", 2, VCT_COUNTER_GLOSS_HALF_WALK},
          {"step", 3, VCT_COUNTER_GLOSS_HALF_WALK + 1},
          {"face of a voxel", 3, VCT_COUNTER_GLOSS_HALF_WALK + 2},
          {"limit", 4, VCT_COUNTER_GLOSS_HALF_WALK + 3}}},
        {"passes/gloss.frag",
         VCT_COUNTER_GLOSS,
         {{"sample", 0, VCT_COUNTER_GLOSS_SAMPLE, true},
          {"ray", 0, VCT_COUNTER_GLOSS_RAY},
          {"cascade", 1, VCT_COUNTER_GLOSS_RAY, true},
          {"walk", 2, VCT_COUNTER_GLOSS_WALK},
          {"step", 3, VCT_COUNTER_GLOSS_WALK + 1},
          {"face of a voxel", 3, VCT_COUNTER_GLOSS_WALK + 2},
          {"limit", 4, VCT_COUNTER_GLOSS_WALK + 3}}},
    };
    return all;
}

}  // namespace

std::vector<StageCount> countInvocations(Renderer& renderer, Output mode, const Camera& camera) {
    renderer.render({{mode}, camera});  // not counted, because the first frame has nothing to clear
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
        // An outermost loop that did not run may be one that the variant does not have. Those inside of a
        // listed loop are listed, because that loop may have had no reason to enter them.
        std::array<bool, 7> isListed{};  // the last loop of each depth
        for (const Loop& loop : stage.loops) {
            const std::uint32_t runs = counts[loop.counter];
            isListed.at(loop.depth) = runs > 0 || (loop.depth > 0 && isListed.at(loop.depth - 1));
            if (isListed[loop.depth])
                count.loops.push_back(
                    {loop.name, loop.depth, loop.constant, loop.times * static_cast<double>(runs)});
        }
        found.push_back(std::move(count));
    }
    return found;
}

}  // namespace vct
