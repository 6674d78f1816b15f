// Writes the irradiance of the faces, or their ambient visibility, into the bricks, where pixels look it up.
// After a move of cascades these are the faces of bricks that were placed again, and, in another dispatch,
// those that the light step has visited.
#include "directional/visited.glsl"
#include "directional/face_irradiance.glsl"
#include "directional/irradiance.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(rgba16f, binding = VCT_IMAGE_BRICKS) writeonly uniform mediump image3D brickTexels;
layout(location = VCT_UNIFORM_SHOWS_VISIBILITY) uniform uint showsVisibility;
layout(location = VCT_UNIFORM_PLACED) uniform uint filled;  // a bit per cascade whose faces are written

// Stores a texel in the brick of the face's block, and in the borders of neighbouring bricks.
void storeInBricks(ListedFace listed, vec4 texel) {
    ivec3 block = listed.voxel >> VCT_BRICK_LEVEL;
    ivec3 place = listed.voxel - block * VCT_BRICK_SIDE;
    ivec3 aside = ivec3(equal(place, ivec3(VCT_BRICK_SIDE - 1))) - ivec3(equal(place, ivec3(0)));
    // Each bit of i selects the neighbour along one axis.
    ivec3 edge = abs(aside);
    ivec3 bit = ivec3(0, edge.x, edge.x + edge.y);
    int blocks = frame.gridSide >> VCT_BRICK_LEVEL;
    for (int i = 0; i < 1 << (bit.z + edge.z); ++i) {
        ivec3 chosen = ivec3(i) >> bit & edge;
        ivec3 other = block + chosen * aside;
        if (other != clampToCascade(other, block, blocks)) continue;
        int axis = listed.face >> 1;
        uint brick = brickAt(other, axis, listed.face & 1);
        if (brick == 0u) continue;
        ivec3 inBrick = listed.voxel - other * VCT_BRICK_SIDE + 1;
        int layer = inBrick[axis] - int(firstLayerOfBrick(brick));
        if (layer < 0 || layer >= int(layersOfBrick(brick))) continue;
        ivec3 inLayers = ivec3(ivec2(acrossFaces(vec3(inBrick), axis)), layer);
        imageStore(brickTexels, firstTexel(brick) + inLayers, texel);
    }
}

void main() {
    uint count = visitedFaceCount();
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = visitedFaceId(i);
        ListedFace listed = baseFace(id);
        if (listed.isMerged || (filled >> uint(cascadeOf(listed.voxel)) & 1u) == 0u) continue;
        vec4 shown = faceMean(id, VCT_MEAN_SHOWN);
        vec3 light =
            showsVisibility != 0u ? shown.aaa : min(shown.rgb + emitterIrradiance(id), maxStoredLight);
        // The planes of thin round bodies may be inside of them by rounding, so these count.
        FaceExtent extent = faceExtent(id);
        float along = facePlane(id).normal[listed.face >> 1];
        bool looksPast = along * along < hardlyTowards;
        float weight = (isHidden(id) || looksPast) && !extent.isCurved ? 0.0 : extent.coverage;
        storeInBricks(listed, vec4(light, 1.0) * weight);
    }
}
