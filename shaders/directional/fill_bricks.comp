// Writes the irradiance of the faces, or their ambient visibility, into the bricks, where pixels look it up.
#include "directional/face_sums.glsl"
#include "directional/irradiance.glsl"
#include "directional/active_faces.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(rgba16f, binding = VCT_IMAGE_IRRADIANCE) writeonly uniform mediump image3D irradianceTexels;
layout(binding = VCT_TEX_BLOCK_LIGHT) uniform mediump sampler3D blockLight;
layout(location = VCT_UNIFORM_SHOWS_VISIBILITY) uniform uint showsVisibility;
layout(location = VCT_UNIFORM_FILLS_ALL) uniform uint fillsAll;

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
        COUNT(VCT_COUNTER_FILL_BRICKS_TEXEL);
        ivec3 chosen = ivec3(i) >> bit & edge;
        ivec3 other = block + chosen * aside;
        if (other != clampToCascade(other, block, blocks)) continue;
        uint brick = brickAt(other, listed.face >> 1, listed.face & 1);
        if (brick == 0u) continue;
        ivec3 inBrick = listed.voxel - other * VCT_BRICK_SIDE + 1;
        imageStore(irradianceTexels, unpackBrick(brick) * VCT_BRICK_TEXELS + inBrick, texel);
    }
}

// While something changes, a face's history holds few cones and is noisy. Far from other surfaces irradiance
// varies little, so the face takes the mean of its block and the blocks around, which hold many cones
// together.
vec3 smoothed(FaceIrradiance mean, ListedFace listed, SurfacePlane plane) {
    float weight = lightStep.smoothing * (1.0 - closeness(mean.nearness));
    if (weight == 0.0) return mean.light.rgb;
    int cascade = cascadeOf(listed.voxel);
    ivec3 inCascade = listed.voxel - firstOfCascade(listed.voxel, frame.gridSide);
    vec3 inVoxels = vec3(inCascade) + 0.5 + plane.normal * plane.offset;
    // The filter must not read texels of faces of another direction.
    float margin = 0.5 * float(VCT_BRICK_SIDE) / float(frame.gridSide);
    vec3 position = clamp(inVoxels / float(frame.gridSide), margin, 1.0 - margin);
    vec3 block =
        (position + vec3(listed.face >> 1, listed.face & 1, cascade)) / vec3(3.0, 2.0, float(cascades));
    vec4 around = textureLod(blockLight, block, 0.0);
    return around.a > 0.0 ? mix(mean.light.rgb, around.rgb / around.a, weight) : mean.light.rgb;
}

void main() {
    COUNT(VCT_COUNTER_FILL_BRICKS);
    bool everyFace = fillsAll != 0u;
    uint count = visitedFaceCount(everyFace);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        COUNT(VCT_COUNTER_FILL_BRICKS_FACE);
        uint id = visitedFaceId(everyFace, i);
        ListedFace listed = baseFace(id);
        if (listed.isMerged) continue;
        FaceIrradiance mean = faceIrradianceAt(id);
        vec3 light = showsVisibility != 0u
                         ? vec3(mean.light.a)
                         : min(smoothed(mean, listed, facePlane(id)) + emitterIrradiance(id), maxStoredLight);
        storeInBricks(listed, vec4(light, 1.0) * faceExtent(id).coverage);
    }
}
