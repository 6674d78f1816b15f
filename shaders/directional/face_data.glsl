// The data of the base-level faces that passes, rays and look-ups read, by the faces' ids: resolve.comp
// writes a face's surface and material from its sums (directional/face_sums.glsl), and inject.comp its
// radiance. VCT_EMISSION: surfaces emit light, so faces also have a word for emission.
//
// The radiance of 64 faces is together, and then the other words of each of them, because the light step
// reads the radiance of faces in any order (directional/gather.comp), and a cache holds more of them so.
#include "shared/frame.glsl"
#include "directional/blocks.glsl"
#include "directional/face_words.glsl"

layout(std430, binding = VCT_SSBO_FACES) buffer FaceBlock {
    uint faceData[];  // blocks' words, faces' words by id, the lists, a bit per occupied face of each block,
                      // and the blocks' pages
};

#define VCT_FACE_SURFACE 0u      // packSurface()
#define VCT_FACE_INSTEAD 0u      // of a face that is gone: faceInstead() in directional/face_lists.glsl
#define VCT_FACE_EXTENT 1u       // packExtent()
#define VCT_FACE_REFLECTANCE 2u  // packRgb9e5(), albedo of what covers the face
#define VCT_FACE_EMITTED 3u      // packRgb9e5(), relative to E/pi, of what covers the face

#ifdef VCT_EMISSION
const uint faceWords = VCT_EMISSIVE_FACE_WORDS;
#else
const uint faceWords = VCT_FACE_WORDS;
#endif

// The position of a face's radiance, packRgb9e5(), relative to E/pi.
uint radianceAt(uint id) {
    return allBlockWords() + faceRadianceWord(id, faceWords);
}
// The position of a face's other words.
uint faceAt(uint id) {
    return allBlockWords() + faceWord(id, faceWords);
}

// The bits of a block's voxels that have a face.
uvec2 blockBits(ivec3 block, int face, bool isDynamic) {
    uint at = markWords(block, face, isDynamic);
    if (cascades > 1 && !isDynamic) {
        uint page = faceData[pageAt(numberOfBlock(block))];
        if (page == 0u) return uvec2(0u);
        at = page + VCT_PAGE_BITS + uint(2 * face);
    }
    return uvec2(faceData[at], faceData[at + 1u]);
}

// The position of a word for the static walls of a brick; 0 if the block has no static face, so that only
// those of moving objects are known there. Only with cascades.
uint staticWallAt(ivec3 block, int face, int slot) {
    uint page = faceData[pageAt(numberOfBlock(block))];
    return page == 0u ? 0u : page + VCT_PAGE_WALLS + uint(2 * face + slot);
}

// The id at which a face's surface is (directional/resolved.glsl). `isStatic`: of the static geometry alone.
uint surfaceId(uint staticCell, uint dynamicCell, int face, bool isStatic) {
    bool isShared = hasFace(staticCell, face) && hasFace(dynamicCell, face);
    return faceId(hasFace(staticCell, face) && !(isStatic && isShared) ? staticCell : dynamicCell, face);
}
SurfacePlane facePlane(uint id) {
    return unpackPlane(faceData[faceAt(id) + VCT_FACE_SURFACE]);
}
FaceExtent faceExtent(uint id) {
    return unpackExtent(faceData[faceAt(id) + VCT_FACE_EXTENT]);
}
vec3 faceRadiance(uint id) {
    return unpackRgb9e5(faceData[radianceAt(id)]);
}
// The middle of the surface that covers a face, in voxels.
vec3 surfaceMiddle(ivec3 voxel, int face, SurfacePlane plane, FaceExtent extent) {
    return vec3(voxel) + 0.5 + pointOnPlane(plane, face >> 1, extent.place);
}
