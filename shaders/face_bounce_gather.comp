// One more bounce, first half: what every block of 2 x 2 x 2 voxels receives per face, by a few cones from the middle
// of the surface that looks that way.
#define VCT_CONE_TRIPS VCT_TRIPS_BOUNCE_GATHER_STEP
#include "shared/trips.glsl"
#include "shared/commands.glsl"
#include "shared/face_cones.glsl"
#include "shared/face_bounce.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;
layout(location = VCT_UNIFORM_LEVEL) uniform uint level;  // 1

float coverage(ivec3 voxel, int axis, int side, int lod) {
    return texelFetch(faces, faceTexel(voxel, axis, side, frame.grid.x >> lod), lod).a;
}

vec3 received(ivec3 block, int axis, int side) {
    TRIP(VCT_TRIPS_BOUNCE_GATHER_RECEIVED);
    float facing = coverage(block, axis, side, 1);
    // The mean normal of what looks this way: from the other axes, what one side covers more than the other.
    vec3 normal;
    for (int other = 0; other < 3; ++other)
        normal[other] = other == axis ? (side == 0 ? facing : -facing)
                                      : coverage(block, other, 0, 1) - coverage(block, other, 1, 1);
    normal = normalize(normal);
    vec4 middle = vec4(0.0);
    for (int i = 0; i < 8; ++i) {
        ivec3 voxel = block * 2 + ivec3(i & 1, (i >> 1) & 1, i >> 2);
        float weight = coverage(voxel, axis, side, 0);
        middle += weight * vec4(vec3(voxel) + 0.5, 1.0);
    }
    // Half a voxel more than from a pixel: the surface may lie anywhere in its voxels.
    vec3 start = middle.xyz / middle.w + normal * (VCT_GATHER_START + 0.5);
    mat3 volumeFromCone = frameAround(normal);
    int rotation = (block.x * 5 + block.y * 3 + block.z * 7) & 15;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < VCT_GATHER_CONES; ++i) {
        TRIP(VCT_TRIPS_BOUNCE_GATHER_CONE);
        vec3 cone = gatherCone(i, rotation);
        ConeResult result =
            traceCone(start, normal, volumeFromCone * cone, 2.0 * float(frame.grid.x));
        sum += result.radiance + result.transmittance * frame.skyRadiance.rgb;
    }
    return sum / float(VCT_GATHER_CONES);
}

void main() {
    TRIP(VCT_TRIPS_BOUNCE_GATHER);
    uint blocks = min(activeVoxelCount(level), faceLightBlocks());
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    // An invocation per block and face, one face after the other: neighbours in the list mostly look the same way, so
    // those that have nothing to do are idle together.
    for (uint i = gl_GlobalInvocationID.x; i < blocks * 6u; i += stride) {
        TRIP(VCT_TRIPS_BOUNCE_GATHER_FACE);
        uint place = i % blocks;
        int face = int(i / blocks);
        int axis = face >> 1, side = face & 1;
        ivec3 block = ivec3(unpackEntry(activeVoxels[commands[level].firstEntry + place]));
        vec3 light = coverage(block, axis, side, 1) > 0.0 ? received(block, axis, side) : vec3(0.0);
        faceLight[place * 6u + uint(face)] = uvec2(packHalf2x16(light.xy), packHalf2x16(vec2(light.z, 0.0)));
    }
}
