// Everything that C++ and the shaders share, written once: binding points, bit layouts, uniform blocks, mode
// numbers. Both languages include this file, so it may use only syntax that both understand.
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
#ifndef VCT_CASCADES  // their number, directional/cascades.glsl
#define VCT_CASCADES 1
#endif
#endif

// The five modes (thesis 5.1.2), and parts of the light that can be shown alone.
#define VCT_MODE_PHONG 1
#define VCT_MODE_SHADOW_MAP 2
#define VCT_MODE_AO 3
#define VCT_MODE_GI 4
#define VCT_MODE_GI_CONE_SHADOW 5
#define VCT_VIEW_AO 6
#define VCT_VIEW_INDIRECT 7
#define VCT_VIEW_CONE_SHADOW 8
#define VCT_VIEW_IRRADIANCE 9  // irradiance by the indirect light, relative to the sun's
#define VCT_VIEW_SPECULAR 10

// The targets that the debug view can show.
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
#define VCT_UBO_COUNT 5

// Shader storage blocks.
#define VCT_SSBO_COMMANDS 0
#define VCT_SSBO_ACTIVE_VOXELS 1
#define VCT_SSBO_FACES 2
#define VCT_SSBO_FACE_IRRADIANCE 3
#define VCT_SSBO_FACE_SUMS 3  // shared with VCT_SSBO_FACE_IRRADIANCE; no pass needs both
#define VCT_SSBO_COUNTERS 4
#define VCT_SSBO_COUNT 5
// Storage blocks of the passes over vertices, which bind all of their buffers (jni/engine/deformer.h).
#define VCT_SSBO_DEFORM_VERTICES 0
#define VCT_SSBO_DEFORM_SOURCES 1
#define VCT_SSBO_DEFORM_DISPLACEMENTS 2
#define VCT_SSBO_DEFORM_STATE 3
#define VCT_SSBO_COPY_POSITIONS 0
#define VCT_SSBO_COPY_NORMALS 2
#define VCT_SSBO_SORT_CORNERS 1
#define VCT_SSBO_SORT_SORTED 2

// Texture units.
#define VCT_TEX_BASE_COLOR 0
#define VCT_TEX_HALF_GLOSS 0  // shared with VCT_TEX_BASE_COLOR; no pass needs both
#define VCT_TEX_EMISSIVE 1
#define VCT_TEX_WALLS 1  // shared with VCT_TEX_EMISSIVE; no pass needs both
#define VCT_TEX_SHADOW_MAP 2
#define VCT_TEX_VOXELS 3
#define VCT_TEX_PREVIOUS_VOXELS 5  // last pose; passes that read the G-buffer do not need it
#define VCT_TEX_G_ALBEDO 4
#define VCT_TEX_GLOSS 4  // shared with VCT_TEX_G_ALBEDO; no pass needs both
#define VCT_TEX_G_NORMAL 5
#define VCT_TEX_NORMAL_MAP 5
#define VCT_TEX_PREVIOUS_PAGES 6  // of VCT_TEX_PREVIOUS_VOXELS
#define VCT_TEX_G_DEPTH 6
#define VCT_TEX_G_EMISSIVE 7
#define VCT_TEX_BLOCKS 7          // shared with VCT_TEX_G_EMISSIVE; no pass needs both
#define VCT_TEX_SHADOW_DEPTH 8    // the shadow map, read without comparison
#define VCT_TEX_DYNAMIC_VOXELS 9  // present pose
#define VCT_TEX_BRICKS 10         // face irradiance (directional/irradiance.glsl)
#define VCT_TEX_BRICK_PLACES 11   // the place of each brick
#define VCT_TEX_G_GLOSS 12
#define VCT_TEX_LIGHT_MAPS 13
#define VCT_TEX_ENVIRONMENT 14
#define VCT_TEX_DYNAMIC_PAGES 15  // of VCT_TEX_DYNAMIC_VOXELS

// Image units.
#define VCT_IMAGE_VOXELS 0
#define VCT_IMAGE_STATIC_WALLS 0  // shared with VCT_IMAGE_VOXELS; no pass needs both
#define VCT_IMAGE_VOXELS_NEXT 1
#define VCT_IMAGE_PAGES 1  // shared with VCT_IMAGE_VOXELS_NEXT; no pass needs both
#define VCT_IMAGE_WALLS 1  // shared with VCT_IMAGE_VOXELS_NEXT; no pass needs both
#define VCT_IMAGE_BRICKS 2
#define VCT_IMAGE_BRICK_PLACES 3
#define VCT_IMAGE_COUNT 4
#define VCT_IMAGE_BLOCKS 2

// Vertex attributes.
#define VCT_ATTRIBUTE_POSITION 0
#define VCT_ATTRIBUTE_NORMAL 1
#define VCT_ATTRIBUTE_UV 2
#define VCT_ATTRIBUTE_EMISSIVE_UV 3
#define VCT_ATTRIBUTE_COLOR 4
#define VCT_ATTRIBUTE_GLOSS_UV 5
#define VCT_ATTRIBUTE_NORMAL_UV 6
#define VCT_ATTRIBUTE_VOXEL 0

// Locations of uniforms outside of blocks.
#define VCT_UNIFORM_LEVEL 0             // mip level or list that a pass works on
#define VCT_UNIFORM_LIST 1              // list that a pass works on (directional/face_lists.glsl)
#define VCT_UNIFORM_CASCADE 2           // cascade that triangles are voxelized into
#define VCT_UNIFORM_CASCADES 2          // the cascades whose static geometry has changed, a bit for each
#define VCT_UNIFORM_PLACED 1            // the cascades whose bricks are placed again, a bit for each
#define VCT_UNIFORM_STATIC 1            // 1: the static geometry is listed again as well
#define VCT_UNIFORM_SHIFT 3             // packShift(): move of the cascade, or those of all cascades
#define VCT_UNIFORM_ARRIVED 3           // packShift(): voxels that have come into each cascade, on both sides
#define VCT_UNIFORM_TURNS 1             // turns of forward_hits.comp, in this dispatch or left
#define VCT_UNIFORM_VISITS_ALL 9        // 1: the pass visits all faces; 0: those of VCT_LIST_VISITED
#define VCT_UNIFORM_CHANGED 10          // two: corners of the box in which a pose changes static faces
#define VCT_UNIFORM_FIRST_SUMS 12       // first id that has sums, in one cube (directional/face_sums.glsl)
#define VCT_UNIFORM_SHOWS_VISIBILITY 2  // 1: the bricks show ambient visibility; 0: light
#define VCT_UNIFORM_SHADOW_TILE 2       // tile of the sun's shadow map that is drawn
#define VCT_UNIFORM_AXIS 0              // axis along which the triangles of a draw call are voxelized
#define VCT_UNIFORM_LIGHT_MAP 0         // index of the light's shadow map
// An array of uniforms for passes/copy_vertices.comp, passes/deform.comp and passes/sort_axes.comp: positions
// of a mesh in their buffers. The numbers are the elements of the array.
#define VCT_UNIFORM_DEFORM 0
#define VCT_DEFORM_COUNT 0               // number of vertices, or of triangles to sort
#define VCT_DEFORM_FIRST_FLOAT 1         // first float of the vertices in the bound range
#define VCT_DEFORM_VERTEX_FLOATS 2       // floats per vertex
#define VCT_DEFORM_FIRST_SOURCE 3        // first vertex before deformation
#define VCT_DEFORM_FIRST_DISPLACEMENT 4  // first float of the morph targets
#define VCT_DEFORM_TARGETS 5             // number of morph targets
#define VCT_DEFORM_FIRST_STATE 6         // first row of the joints' matrices, three rows each
#define VCT_DEFORM_FIRST_WEIGHT 7        // first weight of the morph targets
#define VCT_COPY_FIRST_POSITION 1        // first float of the positions in their buffer
#define VCT_COPY_POSITION_STRIDE 2       // floats from one position to the next
#define VCT_COPY_FIRST_NORMAL 4          // first float of the normals in their buffer
#define VCT_COPY_NORMAL_STRIDE 5         // floats from one normal to the next
#define VCT_SORT_FIRST_VERTEX 3          // vertex index of the mesh's first vertex
#define VCT_SORT_FIRST_CORNER 4          // first index of the mesh in the bound range
#define VCT_SORT_FIRST_SORTED 5          // first sorted index in the bound range
#define VCT_DEFORM_RANGES 8
#define VCT_UNIFORM_COPY_CENTRE 8  // xyz: the origin of the undeformed vertices

// ES 3.1 guarantees 16 KiB for a uniform block, so that not all of the lights can have six maps.
#define VCT_MAX_PUNCTUAL_LIGHTS 64
#define VCT_MAX_LIGHT_MAPS 96
#define VCT_MAX_EMITTER_PARTS 32
#define VCT_MAX_STACKED_VOXELS 512     // along z of all cascades together: packFace() has 9 bits
#define VCT_SHADOW_TILES 4             // 2 x 2 maps in the sun's shadow map, only with cascades
#define VCT_SHADOW_TILE_MARGIN 0.0625  // share of a tile along each of its sides where no receiver is
#define VCT_MAX_CASCADES 6             // nested cubes of voxels (directional/cascades.glsl)
#define VCT_MOVE_PACE 4u               // steps that share the rays of one for faces that a move has changed
#define VCT_FORWARD_TURNS 8u           // steps in which forward_hits.comp visits all faces
#define VCT_LIST_GROUP 64              // invocations per work group over the active-voxel list
// Lists of voxels and faces (directional/face_lists.glsl): one per level; two for the dynamic objects, which
// alternate from pose to pose, so that `list ^ 1` is the other one; and the static faces that a light step
// visits after cascades have moved (directional/visited.glsl).
#define VCT_LIST_DYNAMIC 10
#define VCT_LIST_VISITED 12
#define VCT_LISTS 13
// Words per base-level face besides its radiance (directional/face_data.glsl), and of its sums
// (directional/face_sums.glsl), without and with emission.
#define VCT_FACE_WORDS 3u
#define VCT_EMISSIVE_FACE_WORDS 4u
#define VCT_FACE_SUM_WORDS 13u
#define VCT_EMISSIVE_FACE_SUM_WORDS 16u
#define VCT_FACE_GROUP 64u  // faces whose radiance is stored together, and whose hits are
// Words per block of 4^3 voxels (directional/blocks.glsl), of one cube and of cascades, and words of a page
// of cascades: the cells of the voxels, from VCT_PAGE_BITS on their bits, and from VCT_PAGE_WALLS on two
// words for the thin walls across each face of the block.
#define VCT_BLOCK_WORDS 24u
#define VCT_PAGED_BLOCK_WORDS 13u
#define VCT_PAGE_BITS 64u
#define VCT_PAGE_WALLS 76u
#define VCT_PAGE_WORDS 88u
// Set above the bits of a block's six faces, if list_faces.comp has to visit the block.
#define VCT_MARKED_BLOCK 64u
// A texel of the index of occupied voxels has a bit per occupied face, and above them the position of the
// voxel's first face in its list.
#define VCT_FACE_MASK_BITS 6
#define VCT_FACE_MASK 63u
// Words per face of the buffer of face irradiance (directional/face_irradiance.glsl), without compact
// emitters. With them, the words from VCT_FACE_SEEN_WORD on hold what the face sees of the emitters' parts,
// VCT_SEEN_PARTS to a word.
#define VCT_FACE_IRRADIANCE_WORDS 20u
#define VCT_FACE_SEEN_WORD 21u
#define VCT_SEEN_PARTS 8
// The first of the two words of the light that pixels see.
#define VCT_FACE_SHOWN_WORD 4u
// The first of the three words that depend on what the cached rays have hit, and the last of them.
#define VCT_FACE_SKY_WORD 12u
#define VCT_FACE_SIGHT_WORD 14u
// The word with the counts of the blocked rays, and the bits of it that are not of these.
#define VCT_FACE_BLOCKED_COUNTS_WORD 17u
#define VCT_FACE_NOT_BLOCKED 0x80003F00u
// The hit of a cached ray: a face, or one of these. Above them, in the highest of the bits of a hit, a bit is
// set if the ray is shorter than the distance of ambient occlusion.
#define VCT_HIT_UNKNOWN 0u  // the ray has not been traced
#define VCT_HIT_SKY 1u
#define VCT_HIT_BACK 2u      // the back of a surface: the ray does not count
#define VCT_HIT_FACE 3u      // plus the face's id
#define VCT_MAX_OBJECTS 128  // moving objects as spheres (directional/block_rays.comp)
// Bricks of face irradiance: one per occupied face of the level whose voxels are blocks of 4^3 voxels.
#define VCT_BRICK_LEVEL 2
#define VCT_BRICK_SIDE 4       // 2^VCT_BRICK_LEVEL voxels
#define VCT_BRICK_TEXELS 6     // the voxels and a border for the filter
#define VCT_MAX_GROUPS 65535u  // minimum of GL_MAX_COMPUTE_WORK_GROUP_COUNT (ES 3.1 table 20.45)

// Volume space: the cube of voxels is [0, 1]^3; the axes are the world's. Radiance is relative to
// radianceUnit() (jni/engine/radiance_unit.h), usually E/pi (E: irradiance of a surface that faces the
// light), so that 8 bits serve any light.
struct FrameUniforms {
    mat4 clipFromVolume;
    mat4 volumeFromWindow;  // from pixels and the depth buffer's depth
    mat4 shadowFromVolume;  // texture coordinates and depth, all in [0, 1]
    vec4 eye;               // xyz: volume space
    vec4 directionToLight;  // xyz: unit length
    vec4 lightColor;   // rgb: radiance of a white surface that faces the sun; a: that of a white sun, or 1
    vec4 skyRadiance;  // rgb: relative to E/pi; for a sky of one colour (shared/sky.glsl)
    vec4 background;   // rgb: as skyRadiance, for pixels without a surface
    vec2 shadowConeRadius;       // radius of the sun's cone per depth, in shadow-map coordinates: along the
                                 // first axis of the map, and perpendicular to it
    float shadowConeSine;        // sine of half the cone's angle
    float aoDistance;            // in sides of the volume; with cascades, of the finest one
    float faceSumUnits;          // fixed-point units of a fully covered face (directional/face_sums.glsl)
    int hasDynamicObjects;       // 0: directional voxels hold static geometry only
    float farDepth;              // depth of pixels without a surface: 1, or 0 if depth is reversed
    int gridSide;                // voxels along a side of the volume or a cascade, a power of two
    float emissionRange;         // emission that the sums store as 1, relative to E/pi
    float shadowShear;           // the map's second coordinate along its first axis, per that across it
    vec2 shadowConeTexel;        // width of the shadow map's texels, in radii of the sun's cone per depth
    mat4 shadowSlopeFromNormal;  // xy / -z of the product: a plane's depth in the shadow map per radius,
                                 // along the map's first axis and across it
    // Only with cascades (directional/cascades.glsl). xyz: corner with the smallest coordinates, volume
    // space; w: voxels per side of the volume. `lastCascade`: before the camera moved in this frame.
    vec4 cascade[VCT_MAX_CASCADES];
    vec4 lastCascade[VCT_MAX_CASCADES];
    // The same as shadowFromVolume, shadowConeRadius (xy) and shadowConeTexel (zw) for the tiles of the
    // shadow map (shared/shadow.glsl).
    mat4 shadowTileFromVolume[VCT_SHADOW_TILES];
    vec4 shadowTileCone[VCT_SHADOW_TILES];
    vec4 volumeInWorld;  // xyz: the volume's first corner, in metres; w: 1 / its side
};

// A punctual light (glTF's KHR_lights_punctual; jni/engine/passes/punctual_lights.h). Lengths in sides of the
// volume.
struct PunctualLightUniforms {
    vec4 position;   // xyz: position in volume space, w: 1; directional: unit vector towards the light, w: 0
    vec4 backwards;  // xyz: unit vector against the light's axis; w: 1 / range^2, or 0 without a range
    vec4 intensity;  // rgb: irradiance of a surface that faces it at distance 1, relative to the sun's E
    vec4 cone;   // x, y: scale and offset of the cosine between a spot's axis and the direction to a point
                 // z: radius; directional: tangent of half its opening angle
    ivec4 maps;  // x: index of its first shadow map, y: number of maps: 0, 1 or 6 (a cube)
};
// A shadow map of a punctual light. Its index is its layer in the texture of all maps.
struct LightMap {
    mat4 mapFromVolume;  // projective: coordinates in the layer, and depth, all in [0, 1]
    // Differences of depth at the distance w = 1. x: for a length of a quarter of a texel; proportional to
    // 1/w. y: for the length of the volume's side; proportional to 1/w^2.
    // z: near / (far - near), if the map stores distances (shared/punctual_lights.glsl), else 0. w: the
    // error of a stored depth and of the position it is compared with, in sides of the volume.
    vec4 depth;
};
struct PunctualLightBlock {
    ivec4 count;  // x: number of lights that are on
    PunctualLightUniforms light[VCT_MAX_PUNCTUAL_LIGHTS];
    LightMap map[VCT_MAX_LIGHT_MAPS];
};

// A part of a compact emitter (jni/engine/emitters.h). Lengths and areas in sides of the volume.
struct EmitterPartUniforms {
    vec4 position;  // xyz: middle, volume space; w: radius
    vec4 facing;    // xyz: sum of the triangles' normals, each as long as its area; w: see projectedArea()
    vec4 side;      // xyz: half a side of the rectangle that fits the part; zero if it is round
    vec4 radiance;  // rgb: relative to E/pi; w: half the depth along `facing`
};
struct EmitterBlock {
    ivec4 count;  // x: number of parts; y: a bit for each that may move
    EmitterPartUniforms part[VCT_MAX_EMITTER_PARTS];
};

// Room for the bricks of a cascade in the texture of bricks, in layers of texels of a brick, which are
// counted along z first.
struct BrickRoom {
    uint firstLayer, layers;
    uint unusedRoom0, unusedRoom1;
};

// One step of the light (jni/engine/directional/light_schedule.h; directional/face_irradiance.glsl).
struct LightStep {
    uint frame;            // number of the step
    uint rays;             // cached rays of a face that are traced in the step, at most
    uint movingRays;       // rays of all faces of moving objects together that are traced again
    uint minMovingRays;    // and at least so many of each of these faces
    uint firstRefining;    // number of the first direction that refines the mean
    uint refiningRays;     // such rays per face; 0: the step does not refine
    float refiningShare;   // weight of the step in the refinement: 1 / its steps so far
    float refiningWeight;  // weight of the refinement in what is shown, 0..1
    uint interrupts;       // 1: the step ends a refinement too early
    uint endsRefinement;   // 1: the step is the last one of a refinement
    uint startsDark;       // 1: no face had light before its first rays
    float bounces;         // 1: faces also reflect their irradiance; 0: the first bounce only
    uint visitedCascades;  // all static faces of these cascades are visited, a bit for each
    uint unusedWord;
    uint firstHit;         // words of the buffer where the hits begin,
    uint firstBlocked;     // and the blocked rays
    uint blockedCapacity;  // room for so many
    uint objectCount;      // moving objects
    uint visitsSince;      // number of a step, from 1: faces that have changed since then are visited
    uint emitterTurns;     // faces take over the light of a coarser cascade's emitters for so many steps
    BrickRoom bricks[VCT_MAX_CASCADES];  // of each cascade
    vec4 objectsLow, objectsHigh;        // xyz: the box around the moving objects, volume space
    vec4 object[VCT_MAX_OBJECTS];        // xyz: middle, volume space; w: radius
};

struct DrawUniforms {
    mat4 volumeFromObject;
    mat4 normalFromObject;  // upper 3x3: inverse transpose
    vec4 baseColor;
    vec4 emissive;  // rgb: relative to E/pi; w: scale of the normal map's x and y
    vec4 surface;   // x: alpha cutoff, y: metallic, z: roughness, w: 0 for a compact emitter, whose emission
                    // is not in the voxels, else 1
};

// A vertex before its mesh is deformed, in the mesh's space.
struct DeformSource {
    vec3 position;
    uint joints01;  // 16 bits each
    vec3 normal;
    uint joints23;
    vec4 weights;  // one per joint
};

// One list of voxels and, for directional voxels, of their faces: counts, indirect dispatches, and the
// positions of the entries. Counts include entries that did not fit, so that an overflow is reported with the
// needed capacity.
struct LevelCommands {
    uint voxelCount;
    uint groupsX;  // DispatchIndirectCommand over voxels
    uint groupsY;
    uint groupsZ;
    uint firstEntry;  // position of the list, in entries
    uint capacity;    // in entries
    // Directional voxels only (directional/face_lists.glsl).
    uint faceGroupsX;  // DispatchIndirectCommand over faces
    uint faceGroupsY;
    uint faceGroupsZ;
    uint faceCount;
    uint firstFace;  // position of the face list, in words of the buffer of faces
    uint faceCapacity;
    uint firstId;    // id of the list's first face; base level only
    uint firstMask;  // position of bits, in words: of occupied faces of blocks; of ids at the base level
    // Counts of the static geometry. The lists return to these counts for each pose.
    uint staticVoxels;
    uint staticFaces;
};
struct CommandLists {
    LevelCommands lists[VCT_LISTS];
    uint dynamicList;      // list of the dynamic objects in the present pose
    uint blockedRays;      // cached rays that moving objects block, so far in the step
                           // (directional/block_rays.comp)
    uint mostBlockedRays;  // the largest number in a step, also of those that did not fit
    uint unplacedFaces;    // static faces that found no ids when the static geometry was last listed
    uint unusedIds;        // static ids without a face after the cascades moved last
    uint takenIds;         // those of them that faces took
    uint staticSums;       // room for the sums of so many static faces (directional/face_sums.glsl)
    uint takenSums;        // as many static faces wanted room there since the cascades moved last
    uint sumsById;         // 1: all static faces have sums, in the order of their ids
    // Pages of cascades (directional/blocks.glsl): their number, those that were free after the cascades
    // moved last, as many as blocks have wanted since then, and the position of the free ones' list.
    uint pageCapacity;
    uint freePages;
    uint takenPages;
    uint firstFreePage;
    // Layers of texels of the bricks that were placed last, also those that did not fit.
    uint brickLayers[VCT_MAX_CASCADES];
};

// Entry of the active-voxel list (thesis 4.4): x 11 bits, y 11, z 10.
VCT_FUNCTION uint packEntry(uvec3 voxel) {
    return (voxel.x << 21) | (voxel.y << 10) | voxel.z;
}
VCT_FUNCTION uvec3 unpackEntry(uint entry) {
    return uvec3(entry >> 21, (entry >> 10) & 0x7FFu, entry & 0x3FFu);
}

// Entry of a face list: face 3 bits, x 9, y 9, z 9. The first face of each voxel is marked, whose ids follow
// each other. A dynamic face is marked as merged if the voxel has the same face in the static geometry. The
// static face then has the light of both. The entry of an id without a face, which a cascade has left behind,
// counts as merged too.
#define VCT_FIRST_FACE 0x40000000u
#define VCT_MERGED_FACE 0x80000000u
#define VCT_FREE_FACE 0xFFFFFFFFu
// Positions of a base-level face's radiance and of the first of its `words` other words, behind those of the
// faces before it.
VCT_FUNCTION uint faceRadianceWord(uint id, uint words) {
    return id / VCT_FACE_GROUP * VCT_FACE_GROUP * words + id;
}
VCT_FUNCTION uint faceWord(uint id, uint words) {
    return (id / VCT_FACE_GROUP + 1u) * VCT_FACE_GROUP + id * words;
}
// Position of the first of the words that hold the hits 8 `octet` to 8 `octet` + 7 of a face, of
// `directions`, with `bits` each: 20 or 24. Four words have the lower 16 bits of the eight hits, and the next
// ones the upper bits. The words of VCT_FACE_GROUP faces lie beside each other: the next word
// of a face is so far away.
VCT_FUNCTION uint hitsWord(uint id, uint octet, uint directions, uint bits) {
    uint words = bits / 4u;  // of an octet
    return (id / VCT_FACE_GROUP * (directions / 8u) + octet) * words * VCT_FACE_GROUP + id % VCT_FACE_GROUP;
}
VCT_FUNCTION uint packFace(uvec3 voxel, uint face) {
    return (face << 27) | (voxel.x << 18) | (voxel.y << 9) | voxel.z;
}
VCT_FUNCTION uvec3 unpackFaceVoxel(uint entry) {
    return uvec3((entry >> 18) & 0x1FFu, (entry >> 9) & 0x1FFu, entry & 0x1FFu);
}
VCT_FUNCTION uint unpackFace(uint entry) {
    return (entry >> 27) & 7u;
}

// The steps of a cascade's move along the axes, in voxels, 10 bits each: -512..511.
VCT_FUNCTION uint packShift(ivec3 voxels) {
    return (uint(voxels.x) & 0x3FFu) | (uint(voxels.y) & 0x3FFu) << 10 | (uint(voxels.z) & 0x3FFu) << 20;
}

// Location of a brick of irradiance in its texture: x and y in bricks, 7 bits each, and z in texels, 10 bits.
// Above it, 3 bits each, the first of the layers of texels that the brick stores (0..5, from the border below
// the block to the one above it, along the axis of its faces) and their number (1..6). A bit is set if thin
// walls cross the brick (directional/walls.glsl), and one if it is flat: the block's faces are in one layer,
// whose light does not end beside it. The texels of a layer have the axes of acrossFaces().
#define VCT_BRICK_HAS_WALLS 0x40000000u
#define VCT_BRICK_IS_FLAT 0x80000000u
VCT_FUNCTION uint packBrick(uvec3 place, uint firstLayer, uint layers) {
    return layers << 27 | firstLayer << 24 | place.x << 17 | place.y << 10 | place.z;
}
VCT_FUNCTION uint firstLayerOfBrick(uint word) {
    return (word >> 24) & 7u;
}
VCT_FUNCTION uint layersOfBrick(uint word) {
    return (word >> 27) & 7u;
}
// The first texel of a brick.
VCT_FUNCTION ivec3 firstTexel(uint word) {
    return ivec3(int((word >> 17) & 0x7Fu) * VCT_BRICK_TEXELS, int((word >> 10) & 0x7Fu) * VCT_BRICK_TEXELS,
                 int(word & 0x3FFu));
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
#define VCT_BASE_COUNT 8u    // count of a base-level voxel, so that the first mip is no special case
#define VCT_COLOR_STEPS 31u  // colour of one child in its parent: 0..31; the sum of eight fits 8 bits
// The word that a voxel adds to its parent's (thesis 4.5): count 1; light by eq. 4.5; colour floor(31 c).
// Here c is the voxel's colour normalised by its count, so the result is floor(colour / count).
VCT_FUNCTION uint childContribution(uint word) {
    uint count = voxelCount(word);
    uint light = voxelLight(word) > (count >> 1) ? 1u : 0u;
    return packVoxel(light, 1u, voxelColor(word) / count);
}

#ifdef __cplusplus
}  // namespace vct::shared
#endif
#endif
