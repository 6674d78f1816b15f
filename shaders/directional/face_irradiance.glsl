// The irradiance of each base-level face, by the face's id, relative to E, the irradiance of a surface that
// faces the sun, and the faces that its rays hit. The buffer has, in this order: the words of the faces, the
// hits, and the rays that moving objects block.
//
// A face keeps what its VCT_DIRECTIONS cached rays have hit. In each step the mean of the hits' radiance is
// its irradiance `now`. A few rays are noisy from face to face, but the noise does not change as long as the
// hits are the same. Two means remove it: one over the neighbouring faces, whose rays have other directions
// (directional/smooth.comp), and at rest one over many more rays, which are not kept (the refined mean).
#include "directional/face_words.glsl"
#include "directional/light_step.glsl"
#include "shared/layout.h"

layout(std430, binding = VCT_SSBO_FACE_IRRADIANCE) buffer FaceIrradianceBlock {
    uint faceIrradianceData[];
};

// Words of a face. Means have two words: irradiance, and in alpha ambient visibility.
#define VCT_MEAN_NOW 0u                     // over the cached rays
#define VCT_MEAN_SMOOTH 2u                  // of `now`, over the neighbouring faces
#define VCT_MEAN_SHOWN VCT_FACE_SHOWN_WORD  // what pixels see, and what the face reflects
#define VCT_MEAN_REFINED 6u                 // at the end of the last refinement
#define VCT_MEAN_KNOWN 8u                   // `smooth` at that time
#define VCT_MEAN_GAIN 10u  // of the present refinement's rays so far, less `now` in the same steps
#define VCT_MEAN_SKY \
    VCT_FACE_SKY_WORD  // the sky's part of `now` without moving objects, and ambient visibility
#define VCT_FACE_SIGHT VCT_FACE_SIGHT_WORD  // FaceSight
#define VCT_FACE_DIRECT 15u                 // packRgb9e5(), emission and reflected direct light
#define VCT_FACE_BLOCKED 16u                // of a static face firstBlockedOf(), of a dynamic one forwardAt()
#define VCT_FACE_ROW 18u                    // two words: mean of `now` over a row of neighbouring faces
#define VCT_FACE_EMITTERS 20u               // packRgb9e5(), irradiance by the compact emitters
// Visible share of the emitters' parts, 4 bits each. VCT_EMITTERS: the number of words.
#define VCT_FACE_SEEN_PARTS VCT_FACE_SEEN_WORD
#ifdef VCT_EMITTERS
#define VCT_IRRADIANCE_WORDS (VCT_FACE_SEEN_WORD + uint(VCT_EMITTERS))
#else
#define VCT_IRRADIANCE_WORDS VCT_FACE_IRRADIANCE_WORDS
#endif
uint irradianceAt(uint id) {
    return VCT_IRRADIANCE_WORDS * id;
}

#ifndef VCT_HIT_BITS
#define VCT_HIT_BITS 24
#endif
#define VCT_HIT_NEAR (1u << (VCT_HIT_BITS - 1))
const uint codeShift = 33u - uint(VCT_HIT_BITS);  // moves a hit's highest bit out of a word

// Upper limit of stored light. The largest half float is 65504.
const float maxStoredLight = 6e4;

vec4 meanFrom(uint at) {
    return vec4(unpackHalf2x16(faceIrradianceData[at]), unpackHalf2x16(faceIrradianceData[at + 1u]));
}
vec4 faceMean(uint id, uint mean) {
    return meanFrom(irradianceAt(id) + mean);
}
void storeMean(uint at, vec4 value) {
    value = clamp(value, -maxStoredLight, maxStoredLight);
    faceIrradianceData[at] = packHalf2x16(value.rg);
    faceIrradianceData[at + 1u] = packHalf2x16(value.ba);
}
void storeFaceMean(uint id, uint mean, vec4 value) {
    storeMean(irradianceAt(id) + mean, value);
}

// The mean over a row of faces and the sum of their weights, up to 4. Ambient visibility has 12 bits, and the
// weight 4.
const float rowWeightUnits = 3.75;
void storeFaceRow(uint id, vec4 value, float weight) {
    uint at = irradianceAt(id) + VCT_FACE_ROW;
    value.rgb = clamp(value.rgb, 0.0, maxStoredLight);
    uint visibility = uint(clamp(value.a, 0.0, 1.0) * 4095.0 + 0.5);
    faceIrradianceData[at] = packHalf2x16(value.rg);
    faceIrradianceData[at + 1u] =
        packHalf2x16(vec2(value.b, 0.0)) | visibility << 16u | uint(weight * rowWeightUnits + 0.5) << 28u;
}
vec4 faceRow(uint id, out float weight) {
    uint at = irradianceAt(id) + VCT_FACE_ROW, second = faceIrradianceData[at + 1u];
    weight = float(second >> 28u) / rowWeightUnits;
    return vec4(unpackHalf2x16(faceIrradianceData[at]), unpackHalf2x16(second & 0xFFFFu).x,
                float(second >> 16u & 4095u) / 4095.0);
}

// A summary of what the cached rays of a face meet.
struct FaceSight {
    float nearness;  // mean of 1 / distance to the surfaces, in voxels
    uint backs;      // number of rays that meet the back of a surface, as inside of a solid, at most 255
    uint rays;       // number of the others, at most 255
};
FaceSight faceSight(uint id) {
    uint word = faceIrradianceData[irradianceAt(id) + VCT_FACE_SIGHT];
    return FaceSight(unpackHalf2x16(word).x, word >> 16u & 255u, word >> 24u);
}
void storeFaceSight(uint id, FaceSight sight) {
    faceIrradianceData[irradianceAt(id) + VCT_FACE_SIGHT] =
        packHalf2x16(vec2(sight.nearness, 0.0)) & 0xFFFFu | min(sight.backs, 255u) << 16u |
        min(sight.rays, 255u) << 24u;
}

// The nearer the surrounding surfaces are, the faster irradiance varies along a surface (Ward, Rubinstein and
// Clear 1988). Closeness is 1 if their harmonic mean distance is at most one voxel, as along creases, and
// falls to 0 at four voxels.
float closeness(float nearness) {
    return 1.0 - clamp((1.0 / max(nearness, 1e-3) - 1.0) / 3.0, 0.0, 1.0);
}

// Eight hits lie in some words (hitsWord()). VCT_HIT_BITS: 20 or 24.
#ifdef VCT_DIRECTIONS
uint hitsAt(uint id, uint octet) {
    return lightStep.firstHit + hitsWord(id, octet, uint(VCT_DIRECTIONS), uint(VCT_HIT_BITS));
}
const uint hitsStep = uint(VCT_HIT_BITS) / 4u * VCT_FACE_GROUP;  // from eight hits to the next eight
const uint upperBits = uint(VCT_HIT_BITS) - 16u;
// The word with the upper bits of a hit of an octet, and the position of the bits in it.
uint upperAt(uint at, uint place) {
    return at + (4u + upperBits * place / 32u) * VCT_FACE_GROUP;
}
uint upperShift(uint place) {
    return upperBits * place & 31u;
}
// The first or the last four hits of the octet at a position. `part`: 0 or 1.
uvec4 cachedHitsFrom(uint at, uint part) {
    uint first = at + 2u * part * VCT_FACE_GROUP;
    uvec2 lower = uvec2(faceIrradianceData[first], faceIrradianceData[first + VCT_FACE_GROUP]);
    uvec4 hits = uvec4(lower.x << 16u >> 16u, lower.x >> 16u, lower.y << 16u >> 16u, lower.y >> 16u);
    uint upper = faceIrradianceData[upperAt(at, 4u * part)] >> upperShift(4u * part);
    uvec4 parts = uvec4(upper, upper >> upperBits, upper >> 2u * upperBits, upper >> 3u * upperBits);
    return hits | parts << (32u - upperBits) >> (16u - upperBits);
}
void storeCachedHitsFrom(uint at, uint part, uvec4 hits) {
    uint first = at + 2u * part * VCT_FACE_GROUP;
    faceIrradianceData[first] = hits.x << 16u >> 16u | hits.y << 16u;
    faceIrradianceData[first + VCT_FACE_GROUP] = hits.z << 16u >> 16u | hits.w << 16u;
    uvec4 parts = hits >> 16u;
    uint upper = parts.x | parts.y << upperBits | parts.z << 2u * upperBits | parts.w << 3u * upperBits;
    uint word = upperAt(at, 4u * part);
#if VCT_HIT_BITS == 20
    uint shift = upperShift(4u * part);
    upper = faceIrradianceData[word] & ~(0xFFFFu << shift) | upper << shift;
#endif
    faceIrradianceData[word] = upper;
}
// The hits of the cached rays 4 `quad` to 4 `quad` + 3.
uvec4 cachedHits(uint id, uint quad) {
    return cachedHitsFrom(hitsAt(id, quad >> 1u), quad & 1u);
}
void storeCachedHits(uint id, uint quad, uvec4 hits) {
    storeCachedHitsFrom(hitsAt(id, quad >> 1u), quad & 1u, hits);
}
uint cachedHit(uint id, uint direction) {
    uint at = hitsAt(id, direction >> 3u), place = direction & 7u;
    uint hit = faceIrradianceData[at + (place >> 1u) * VCT_FACE_GROUP] >> 16u * (place & 1u) & 0xFFFFu;
    uint upper = faceIrradianceData[upperAt(at, place)] >> upperShift(place);
    return hit | (upper & (1u << upperBits) - 1u) << 16u;
}
void storeCachedHit(uint id, uint direction, uint hit) {
    uvec4 hits = cachedHits(id, direction >> 2u);
    hits[direction & 3u] = hit;
    storeCachedHits(id, direction >> 2u, hits);
}
#endif
// The position of the id, counted from 1, that a dynamic face has in the next pose.
uint forwardAt(uint id) {
    return irradianceAt(id) + VCT_FACE_BLOCKED;
}
// The position of a static face's blocked rays. With cascades, the step in which the face was new or lost
// hits is above it, modulo changeSteps and counted from 1; 0 if its mean has been refined since.
const uint changeShift = 22u, changeSteps = 1023u,
           blockedMask = VCT_CASCADES > 1 ? (1u << changeShift) - 1u : 0xFFFFFFFFu;
uint stampOf(uint step) {
    return step % changeSteps + 1u;
}
void storeChange(uint id, uint stamp) {
    uint at = irradianceAt(id) + VCT_FACE_BLOCKED;
    faceIrradianceData[at] = faceIrradianceData[at] & blockedMask | stamp << changeShift;
}
void storeChangedNow(uint id) {
    storeChange(id, stampOf(lightStep.frame));
}
bool hasChangedSince(uint id, uint step) {
    uint stamp = faceIrradianceData[irradianceAt(id) + VCT_FACE_BLOCKED] >> changeShift;
    uint age = (stampOf(lightStep.frame) + changeSteps - stamp) % changeSteps;
    return stamp != 0u && age <= lightStep.frame - step;
}
uint firstBlockedOf(uint id) {
    return lightStep.firstBlocked + (faceIrradianceData[irradianceAt(id) + VCT_FACE_BLOCKED] & blockedMask);
}
void storeFirstBlocked(uint id, uint first) {
    uint at = irradianceAt(id) + VCT_FACE_BLOCKED;
    faceIrradianceData[at] = faceIrradianceData[at] & ~blockedMask | first;
}

// A cached ray that a moving object blocks: its direction, and what it hits in place of its cached hit. The
// sky's part of `now` follows the last one of a face.
uint packBlocked(uint direction, uint hit) {
    return direction << 24u | hit;
}

// The number of blocked rays and of those among them that meet a back; whether the face had the plane of a
// moving object, as where one touches a static surface, so that its hits are of a plane that moves; the links
// to the faces beside it (directional/link_faces.comp): bits for the faces before and behind it along the
// first axis across the face, and along the second; and whether the light of emitters is known.
const uint wasMerged = 0x80000000u, linkBits = 0x0F00u, emitterBits = 0x3000u;
void storeBlockedCounts(uint id, uint rays, uint backs, bool isMerged) {
    uint at = irradianceAt(id) + VCT_FACE_BLOCKED + 1u;
    faceIrradianceData[at] =
        faceIrradianceData[at] & (linkBits | emitterBits) | rays | backs << 16u | (isMerged ? wasMerged : 0u);
}
uint faceLinks(uint id) {
    return faceIrradianceData[irradianceAt(id) + VCT_FACE_BLOCKED + 1u] >> 8u & 0xFu;
}
void storeLinks(uint id, uint links) {
    uint at = irradianceAt(id) + VCT_FACE_BLOCKED + 1u;
    faceIrradianceData[at] = faceIrradianceData[at] & ~linkBits | links << 8u;
}

// Rays that meet the back of a surface do not count in the means.
bool countsInMean(uint hit) {
    return (hit & ~VCT_HIT_NEAR) != VCT_HIT_BACK && hit != VCT_HIT_UNKNOWN;
}
// The number of cached rays that count in `now`.
uint countedRays(uint id) {
    uint rays = faceSight(id).rays,
         backs = faceIrradianceData[irradianceAt(id) + VCT_FACE_BLOCKED + 1u] >> 16u & 0xFFu;
    return rays - min(backs, rays);
}
// True if a face is inside of a solid, as where two boxes touch.
bool isHidden(uint id) {
    FaceSight sight = faceSight(id);
    uint counted = countedRays(id), backs = sight.backs + sight.rays - counted;
    return 3u * backs > counted;
}

// The index (0 to 15) of a face in its layer: the 4 x 4 faces of a block that have the same position along
// the face's axis.
int indexInBlock(ivec3 voxel, int axis) {
    ivec2 across = axis == 0 ? voxel.yz : axis == 1 ? voxel.zx : voxel.xy;
    return (across.x & 3) + 4 * (across.y & 3);
}

// The light of further bounces that a face reflects. In a closed room that absorbs nothing, it would grow
// without bound, so white surfaces absorb a little.
vec3 reflectedBounces(vec3 albedo, vec3 irradiance) {
    const float maxAlbedo = 0.99;
    return lightStep.bounces * min(albedo, maxAlbedo) * irradiance;
}

// Irradiance by the compact emitters (directional/emitters.comp), and whether it is known.
#ifdef VCT_EMITTERS
const uint emittersUnknown = 0u, emittersTakenOver = 0x1000u, emittersKnown = 0x2000u;
vec3 emitterIrradiance(uint id) {
    return unpackRgb9e5(faceIrradianceData[irradianceAt(id) + VCT_FACE_EMITTERS]);
}
uint knownEmitters(uint id) {
    return faceIrradianceData[irradianceAt(id) + VCT_FACE_BLOCKED + 1u] & emitterBits;
}
void storeEmitterIrradiance(uint id, vec3 light, uint known) {
    uint at = irradianceAt(id), counts = at + VCT_FACE_BLOCKED + 1u;
    faceIrradianceData[at + VCT_FACE_EMITTERS] = packRgb9e5(light);
    faceIrradianceData[counts] = faceIrradianceData[counts] & ~emitterBits | known;
}
// A new face takes over what another face has, one of a coarser cascade or of the last pose.
void takeEmitterIrradiance(uint id, uint from) {
    uint at = irradianceAt(id), counts = at + VCT_FACE_BLOCKED + 1u;
    faceIrradianceData[at + VCT_FACE_EMITTERS] = faceIrradianceData[irradianceAt(from) + VCT_FACE_EMITTERS];
    faceIrradianceData[counts] = faceIrradianceData[counts] & ~emitterBits | emittersTakenOver;
}
#else
vec3 emitterIrradiance(uint id) {
    return vec3(0.0);
}
#endif
