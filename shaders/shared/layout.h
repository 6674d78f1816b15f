// Everything that C++ and the shaders share, written once: binding points, bit layouts, uniform blocks, mode
// numbers. Included by both, so only what both languages understand stands here.
#ifndef VCT_SHARED_LAYOUT_H
#define VCT_SHARED_LAYOUT_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
#define VCT_FUNCTION inline
namespace vct::shared {
using uint = std::uint32_t;
using glm::ivec3;
using glm::ivec4;
using glm::mat4;
using glm::uvec3;
using glm::vec2;
using glm::vec3;
using glm::vec4;
#else
#define VCT_FUNCTION
#endif

// The five modes (thesis 5.1.2), and the intermediates that can be shown alone.
#define VCT_MODE_PHONG 1
#define VCT_MODE_SHADOW_MAP 2
#define VCT_MODE_AO 3
#define VCT_MODE_GI 4
#define VCT_MODE_GI_CONE_SHADOW 5
#define VCT_VIEW_AO 6
#define VCT_VIEW_INDIRECT 7
#define VCT_VIEW_CONE_SHADOW 8
#define VCT_VIEW_IRRADIANCE 9  // of the indirect light, relative to the sun's
#define VCT_VIEW_SPECULAR 10

// What the debug view shows.
#define VCT_DEBUG_VIEW_SHADOW_MAP 0
#define VCT_DEBUG_VIEW_ALBEDO 1
#define VCT_DEBUG_VIEW_NORMAL 2
#define VCT_DEBUG_VIEW_DEPTH 3
#define VCT_DEBUG_VIEW_EMISSIVE 4

// Uniform blocks.
#define VCT_UBO_FRAME 0
#define VCT_UBO_DRAW 1
#define VCT_UBO_LIGHT 2
#define VCT_UBO_PUNCTUAL_LIGHTS 3
#define VCT_UBO_EMITTERS 4
#define VCT_UBO_FACE_RANGE 5

// Shader storage blocks.
#define VCT_SSBO_COMMANDS 0
#define VCT_SSBO_ACTIVE_VOXELS 1
#define VCT_SSBO_FACES 2
#define VCT_SSBO_FACE_RANGE 2  // no pass needs both
#define VCT_SSBO_FACE_IRRADIANCE 3
#define VCT_SSBO_COUNTERS 4
// Of the passes over vertices, which bind all of theirs anew (jni/engine/deformer.h).
#define VCT_SSBO_DEFORM_VERTICES 0
#define VCT_SSBO_DEFORM_SOURCES 1
#define VCT_SSBO_DEFORM_DISPLACEMENTS 2
#define VCT_SSBO_DEFORM_STATE 3
#define VCT_SSBO_SORT_CORNERS 1
#define VCT_SSBO_SORT_SORTED 2

// What the counting variant counts (shared/counters.glsl): invocations of a stage, and iterations of its loops.
#define VCT_COUNTER_SHADOW_MAP 0
#define VCT_COUNTER_G_BUFFER 1
#define VCT_COUNTER_VOXELIZER 2
#define VCT_COUNTER_SPARSE_CLEAR 3
#define VCT_COUNTER_SPARSE_CLEAR_VOXEL 4
#define VCT_COUNTER_MIPMAPPER 5
#define VCT_COUNTER_MIPMAPPER_VOXEL 6
#define VCT_COUNTER_CONE_TRACER 7
#define VCT_COUNTER_DIFFUSE_CONE 8
#define VCT_COUNTER_DIFFUSE_STEP 9
#define VCT_COUNTER_SHADOW_STEP 10
#define VCT_COUNTER_BLOCKER_TAP 11
#define VCT_COUNTER_FILTER_TAP 12
#define VCT_COUNTER_IRRADIANCE_AXIS 13
#define VCT_COUNTER_MARK_FACES 14
#define VCT_COUNTER_LIST_FACES 15
#define VCT_COUNTER_LIST_FACES_VOXEL 16
#define VCT_COUNTER_LIST_FACES_FACE 17
#define VCT_COUNTER_LIST_FACES_LEVEL 18
#define VCT_COUNTER_LIST_FACES_PARENT 19
#define VCT_COUNTER_ACCUMULATE 20
#define VCT_COUNTER_ACCUMULATE_FACE 21
#define VCT_COUNTER_FACE_CLEAR 22
#define VCT_COUNTER_FACE_CLEAR_FACE 23
#define VCT_COUNTER_CLEAR_DYNAMIC 24
#define VCT_COUNTER_CLEAR_DYNAMIC_FACE 25
#define VCT_COUNTER_RESET_LISTS 26
#define VCT_COUNTER_INJECT 27
#define VCT_COUNTER_INJECT_FACE 28
#define VCT_COUNTER_INJECT_POINT 29
#define VCT_COUNTER_FACE_MIPMAPPER 30
#define VCT_COUNTER_FACE_MIPMAPPER_FACE 31
#define VCT_COUNTER_CARRY_OVER 32
#define VCT_COUNTER_CARRY_OVER_FACE 33
#define VCT_COUNTER_CARRY_OVER_NEIGHBOUR 34
#define VCT_COUNTER_BRICKS_CLEAR 35
#define VCT_COUNTER_BRICKS_CLEAR_TEXEL 36
#define VCT_COUNTER_BRICKS_CLEAR_PLACE 37
#define VCT_COUNTER_PLACE_BRICKS 38
#define VCT_COUNTER_PLACE_BRICKS_FACE 39
#define VCT_COUNTER_IRRADIANCE 40
#define VCT_COUNTER_IRRADIANCE_FACE 41
#define VCT_COUNTER_IRRADIANCE_CONE 42
#define VCT_COUNTER_IRRADIANCE_STEP 43
#define VCT_COUNTER_FILL_BRICKS_TEXEL 44
#define VCT_COUNTER_IRRADIANCE_NEARBY 45
#define VCT_COUNTER_LIGHT_BLOCKS 46
#define VCT_COUNTER_SPECULAR_STEP 47
#define VCT_COUNTER_SHADOW_MOMENTS 48
#define VCT_COUNTER_SHADOW_MOMENTS_NEXT 49
#define VCT_COUNTER_EMITTERS 50
#define VCT_COUNTER_EMITTERS_FACE 51
#define VCT_COUNTER_EMITTERS_CONE 52
#define VCT_COUNTER_EMITTERS_STEP 53
#define VCT_COUNTER_DEFORM 54
#define VCT_COUNTER_DEFORM_VERTEX 55
#define VCT_COUNTER_DEFORM_TARGET 56
#define VCT_COUNTER_SORT_AXES 57
#define VCT_COUNTER_SORT_AXES_TRIANGLE 58
#define VCT_COUNTER_MARK_LOOKUPS 59
#define VCT_COUNTER_CHOOSE_FACES 60
#define VCT_COUNTER_CHOOSE_FACES_FACE 61
#define VCT_COUNTER_FILL_BRICKS 62
#define VCT_COUNTER_FILL_BRICKS_FACE 63
#define VCT_COUNTER_CHOOSE_RANGE 64
#define VCT_COUNTER_COUNT 65

// Texture units.
#define VCT_TEX_BASE_COLOR 0
#define VCT_TEX_EMISSIVE 1
#define VCT_TEX_SHADOW_MAP 2
#define VCT_TEX_VOXELS 3
#define VCT_TEX_DYNAMIC_VOXELS 4   // of the present pose; the pass that reads the G-buffer has no need of it
#define VCT_TEX_PREVIOUS_VOXELS 5  // of the pose before, likewise
#define VCT_TEX_G_ALBEDO 4
#define VCT_TEX_GLOSS 4  // no pass needs both
#define VCT_TEX_G_NORMAL 5
#define VCT_TEX_NORMAL_MAP 5
#define VCT_TEX_G_DEPTH 6
#define VCT_TEX_G_EMISSIVE 7
#define VCT_TEX_LAST_LOOKUPS 7  // no pass needs both
#define VCT_TEX_SHADOW_DEPTH 8  // the shadow map again, by a sampler that does not compare
#define VCT_TEX_FACES 9
#define VCT_TEX_IRRADIANCE 10  // directional/face_irradiance.glsl: the bricks, and where each is
#define VCT_TEX_BRICKS 11
#define VCT_TEX_G_GLOSS 12
#define VCT_TEX_BLOCK_LIGHT 12  // no pass needs both
#define VCT_TEX_LIGHT_MAPS 13
#define VCT_TEX_ENVIRONMENT 14
#define VCT_TEX_SHADOW_MOMENTS 15

// Image units.
#define VCT_IMAGE_VOXELS 0
#define VCT_IMAGE_VOXELS_NEXT 1
#define VCT_IMAGE_FACES 2
#define VCT_IMAGE_IRRADIANCE 2  // ES 3.1 guarantees four units, and no pass needs both
#define VCT_IMAGE_BRICKS 3
#define VCT_IMAGE_BLOCK_LIGHT 2
#define VCT_IMAGE_LAST_LOOKUPS 2

// Vertex attributes.
#define VCT_ATTRIBUTE_POSITION 0
#define VCT_ATTRIBUTE_NORMAL 1
#define VCT_ATTRIBUTE_UV 2
#define VCT_ATTRIBUTE_EMISSIVE_UV 3
#define VCT_ATTRIBUTE_COLOR 4
#define VCT_ATTRIBUTE_GLOSS_UV 5
#define VCT_ATTRIBUTE_NORMAL_UV 6
#define VCT_ATTRIBUTE_VOXEL 0

// Uniforms outside blocks: the mip level that a pass over the active-voxel list works on, and the axis along which
// the triangles of a draw call are voxelized; the list of faces that a pass writes (directional/face_lists.glsl); the
// number of the light step, which seeds its dither.
#define VCT_UNIFORM_LEVEL 0
#define VCT_UNIFORM_LIST 1
#define VCT_UNIFORM_FRAME_INDEX 1
#define VCT_UNIFORM_AXIS 0
#define VCT_UNIFORM_LIGHT_MAP 0
// Where a mesh that changes its form lies in the buffers of passes/deform.comp and passes/sort_axes.comp: elements of an
// array at the first location.
#define VCT_UNIFORM_DEFORM 0
#define VCT_DEFORM_COUNT 0               // vertices; triangles
#define VCT_DEFORM_FIRST_FLOAT 1         // of its vertices, in the part of their buffer that is bound
#define VCT_DEFORM_VERTEX_FLOATS 2       // from a vertex to the next
#define VCT_DEFORM_FIRST_SOURCE 3        // of its vertices
#define VCT_DEFORM_FIRST_DISPLACEMENT 4  // of its morph targets
#define VCT_DEFORM_TARGETS 5
#define VCT_DEFORM_FIRST_STATE 6   // of its joints, three rows each; behind them the weights
#define VCT_DEFORM_FIRST_WEIGHT 7
#define VCT_SORT_FIRST_VERTEX 3  // of the mesh, as its indices have it
#define VCT_SORT_FIRST_CORNER 4  // of its indices, in the part of their buffer that is bound
#define VCT_SORT_FIRST_SORTED 5
#define VCT_DEFORM_RANGES 8

#define VCT_MAX_PUNCTUAL_LIGHTS 16
#define VCT_MAX_LIGHT_MAPS 96  // six for each of them
#define VCT_MAX_EMITTER_PARTS 32
#define VCT_MAX_LEVELS 10  // 512^3 has levels 0..9
#define VCT_LIST_GROUP 64  // invocations per work group over the active-voxel list
#define VCT_NO_ENTRY 0xFFFFFFFFu
// Lists of voxels and faces: one for each level, and behind them those of the dynamic objects, which alternate from pose
// to pose (directional/face_lists.glsl).
#define VCT_LIST_DYNAMIC 10
#define VCT_LISTS 12
// Words that each face of the base level has (directional/face_sums.glsl), without and with sums of emission.
#define VCT_FACE_WORDS 6u
#define VCT_EMISSIVE_FACE_WORDS 9u
// A texel of the index of occupied voxels: a bit for each face that is not empty, and above them the place of the
// voxel's first face in its list.
#define VCT_FACE_MASK_BITS 6
#define VCT_FACE_MASK 63u
// The gather (directional/face_irradiance.glsl): sums over all faces, for three steps in turn; and bricks of texels, one
// for each face that is not empty of the level whose voxels are blocks of 4^3, with a border for the filter.
#define VCT_LIGHT_SUMS 20u
#define VCT_LIGHT_HEADER 60u  // words: three such steps
#define VCT_BRICK_LEVEL 2
#define VCT_BRICK_SIDE 4  // 2^VCT_BRICK_LEVEL
#define VCT_BRICK_TEXELS 6
#define VCT_MIN_CREASE_CONES 4    // that a face looks into in a step, at least, where something is near
#define VCT_INITIAL_HISTORY 6.0      // that a face counts as having seen when it has gathered for the first time
#define VCT_BLOCK_UNITS 33554432.0  // 2^25, fixed point of the sums over the up to 64 faces of a block
#define VCT_MAX_GROUPS 65535u  // GL_MAX_COMPUTE_WORK_GROUP_COUNT is at least that (ES 3.1 table 20.45)

// Volume space: the cube of voxels is [0, 1]^3; the axes are the world's. Radiance is relative to E/pi
// (E: irradiance of a surface that faces the light), so that 8 bits serve any light.
struct FrameUniforms {
    mat4 clipFromVolume;
    mat4 volumeFromWindow;  // pixels, and depth as the depth buffer has it
    mat4 shadowFromVolume;  // texture coordinates and depth, all in [0, 1]
    vec4 eye;               // xyz: volume space
    vec4 directionToLight;      // xyz: unit length
    vec4 lightColor;        // rgb: largest component 1
    vec4 skyRadiance;       // rgb: relative to E/pi, where it is the same in all directions (shared/sky.glsl)
    vec2 shadowConeRadius;     // of the sun's cone in the shadow map, at one unit of its depth
    float shadowConeSine;      // of half the cone's angle
    float aoDistance;          // of the volume's side
    float faceSumUnits;        // fixed-point units of a whole face (directional/face_sums.glsl)
    float largestSky;          // bound of the irradiance that the sky gives a surface, relative to E/pi
    float largestBounceShare;  // of the light, that a bounce passes on
    int gridSide;              // voxels along a side, a power of two
    float emissionRange;       // what the sums of emission store as 1, relative to E/pi
    float unused0, unused1, unused2;
};

// A light besides the sun (glTF's KHR_lights_punctual; jni/engine/passes/punctual_lights.h).
struct PunctualLightUniforms {
    vec4 position;   // xyz: volume space, w: 1; of a directional light the unit vector towards it, and 0
    vec4 backwards;  // xyz: unit length, against its axis; w: 1 / range^2, or 0, lengths in sides of the volume
    vec4 intensity;  // rgb: irradiance, at the distance 1, of a surface that faces it, relative to the sun's E
    vec4 cone;       // x, y: scale and offset of the cosine between a spot's axis and the direction to a point
                     // z: radius, in sides of the volume; of a directional light the tangent of half its angle
    ivec4 maps;      // x: the first of its shadow maps, y: how many, 1 or the 6 of a cube
};
// A shadow map of one of them: the layer with its index in the texture that all share.
struct LightMap {
    mat4 mapFromVolume;  // projective: coordinates in the layer, and depth, all in [0, 1]
    // At the distance w = 1: x: depth that is a quarter of a texel wide; there it falls with 1 / w. y: depth that the
    // volume's side has; it falls with 1 / w^2.
    vec4 depth;
};
struct PunctualLightBlock {
    ivec4 count;  // x: of the lights that are on
    PunctualLightUniforms light[VCT_MAX_PUNCTUAL_LIGHTS];
    LightMap map[VCT_MAX_LIGHT_MAPS];
};

// A part of a lamp (jni/engine/emitters.h). Lengths and areas in sides of the volume.
struct EmitterPartUniforms {
    vec4 position;  // xyz: its middle, volume space; w: its radius
    vec4 facing;    // xyz: the sum of its triangles' normals, as long as they are large; w: see projectedArea() in shared/emitters.glsl
    vec4 side;      // xyz: half of one side of the rectangle that it is nearly; zero where it is round
    vec4 radiance;  // rgb: relative to E/pi; w: how far before its middle cones towards it end
};
struct EmitterBlock {
    ivec4 count;  // x: of parts
    EmitterPartUniforms part[VCT_MAX_EMITTER_PARTS];
};

// The ranges of the directional voxels in a light step, relative to E/pi (directional/choose_range.comp).
struct FaceRange {
    float radiance;  // what the faces' 8 bits store as 1
    float sums;      // what the integer sums over all faces count as 1
    float unused0, unused1;
};

// One step of the received light towards its final value (jni/engine/directional/irradiance.h).
struct LightStep {
    uint frame;          // counts steps
    uint direction;      // the first of the set that a step without a budget looks into
    uint cones;          // how many
    uint initialCones;     // of a face that has received nothing yet
    uint beginsRound;    // 1 where this step is the first of a round
    uint bricksAlong;    // of the texture of bricks, along x and y
    float roundShare;  // of a step; 0 outside of rounds
    float maxHistory;        // most steps that a face's mean remembers
    float maxInheritedHistory;     // most steps that a new face takes over from its neighbours' history
    float energyCorrection;  // the share of the way to the balance of all faces' light that a step makes good
    float bounceGain;     // gain of what faces send on, or 0 for the first bounce alone
    float amplitude;     // the share that the step before had in the means
    float sumUnits;      // fixed point of the sums
    uint blockSums;      // word of the received light where the blocks' sums begin
    float smoothing;     // how much of a face's light may be its block's, 0..1
    float minHistory;  // history length that every face has after the step: long where the light has converged
    uint coneBudget;     // cones of the whole step (directional/gather_turns.glsl); 0: every face gathers
    uint chosenFaces;    // word of the face irradiance where the list of the faces that gather begins
    uint unused0, unused1;
};

struct DrawUniforms {
    mat4 volumeFromObject;
    mat4 normalFromObject;  // upper 3x3: inverse transpose
    vec4 baseColor;
    vec4 emissive;  // rgb: relative to E/pi; w: scale of the normal map's x and y
    vec4 surface;   // x: alpha cutoff, y: metallic, z: roughness, w: 1, or 0 where voxels leave its emission to jni/engine/emitters.h
};

// A vertex before its mesh is deformed, in the mesh's space.
struct DeformSource {
    vec3 position;
    uint joints01;  // 16 bits each
    vec3 normal;
    uint joints23;
    vec4 weights;  // of the four joints
};

// One list of voxels and, for directional voxels, of their faces: how many there are, the indirect dispatches over them, and
// where the entries are. Counts include what found no room in a list, so that an overflow can be reported with the capacity
// that would be needed.
struct LevelCommands {
    uint voxelCount;
    uint groupsX;  // DispatchIndirectCommand over voxels
    uint groupsY;
    uint groupsZ;
    uint firstEntry;  // of this level, in entries of the list
    uint capacity;    // of this level, in entries
    // Directional voxels only (directional/face_lists.glsl).
    uint faceGroupsX;  // DispatchIndirectCommand over faces
    uint faceGroupsY;
    uint faceGroupsZ;
    uint faceCount;
    uint firstFace;     // of the list, in words of the buffer of faces
    uint faceCapacity;
    uint firstId;       // of its first face, at the base level: where the face's words are
    uint firstMask;     // of the level's bits of faces that are not empty, in words of the buffer; 0 at the base level
    // Counts of the static geometry alone, to which the lists return for each pose.
    uint staticVoxels;
    uint staticFaces;
};
struct CommandLists {
    LevelCommands lists[VCT_LISTS];
    uint dynamicList;  // the list of the dynamic objects in their present pose
    // The last injection of light measured the largest radiance that a face was to store, and the largest irradiance of a
    // face: bits of floats, which have the order of integers from 0 on.
    uint largestRadiance, largestIrradiance;
    uint unused0;
};

// Entry of the active-voxel list (thesis 4.4): x 11 bits, y 11, z 10.
VCT_FUNCTION uint packEntry(uvec3 voxel) {
    return (voxel.x << 21) | (voxel.y << 10) | voxel.z;
}
VCT_FUNCTION uvec3 unpackEntry(uint entry) {
    return uvec3(entry >> 21, (entry >> 10) & 0x7FFu, entry & 0x3FFu);
}

// Entry of the list of faces: face 3 bits, x 9, y 9, z 9. A dynamic face whose voxel has the same face of the static
// geometry is marked as merged: the static face has the light of both.
#define VCT_MERGED_FACE 0x80000000u
VCT_FUNCTION uint packFace(uvec3 voxel, uint face) {
    return (face << 27) | (voxel.x << 18) | (voxel.y << 9) | voxel.z;
}
VCT_FUNCTION uvec3 unpackFaceVoxel(uint entry) {
    return uvec3((entry >> 18) & 0x1FFu, (entry >> 9) & 0x1FFu, entry & 0x1FFu);
}
VCT_FUNCTION uint unpackFace(uint entry) {
    return (entry >> 27) & 7u;
}

// Where a brick of received light lies in their texture, in bricks: a mark that it is one, and 10 bits each.
VCT_FUNCTION uint packBrick(uvec3 brick) {
    return 0x80000000u | (brick.x << 20) | (brick.y << 10) | brick.z;
}
VCT_FUNCTION ivec3 unpackBrick(uint word) {
    return ivec3(int((word >> 20) & 0x3FFu), int((word >> 10) & 0x3FFu), int(word & 0x3FFu));
}

// The voxel word (thesis figure 4.3), high to low: light counter 4 bits, count 4, R 8, G 8, B 8. Light comes
// first so that imageAtomicMax lets lit fragments win over unlit ones.
VCT_FUNCTION uint packVoxel(uint light, uint count, uvec3 color) {
    return (light << 28) | (count << 24) | (color.x << 16) | (color.y << 8) | color.z;
}
VCT_FUNCTION uint voxelLight(uint word) {
    return word >> 28;
}
VCT_FUNCTION uint voxelCount(uint word) {
    return (word >> 24) & 0xFu;
}
VCT_FUNCTION uvec3 voxelColor(uint word) {
    return uvec3((word >> 16) & 0xFFu, (word >> 8) & 0xFFu, word & 0xFFu);
}
#define VCT_BASE_COUNT 8u     // count of a base-level voxel, so that the first mip is no special case
#define VCT_COLOR_STEPS 31u   // colour of one child in its parent: 0..31, eight of which fit 8 bits

// What a voxel adds to its parent (thesis 4.5): count 1; light by eq. 4.5; colour floor(31 c), where c is its
// colour normalised by its count, i.e. floor(colour / count).
VCT_FUNCTION uint childContribution(uint word) {
    uint count = voxelCount(word);
    uint light = voxelLight(word) > (count >> 1) ? 1u : 0u;
    return packVoxel(light, 1u, voxelColor(word) / count);
}

#ifdef __cplusplus
}  // namespace vct::shared
#endif
#endif
