// Irradiance of the base level's faces by the compact emitters: a closed form for each part, times the share
// of the part that the face sees. Static faces keep what they see of static parts through static geometry, so
// that neither an emitter that fades nor a moving object far away costs a ray.
#include "directional/visited.glsl"
#include "directional/emitter_light.glsl"
#include "directional/face_irradiance.glsl"
#include "directional/light_step.glsl"

layout(local_size_x = VCT_LIST_GROUP) in;

// A visible share in 4 bits: 0 if it is not known, else 1 to 15.
uint packSeenPart(float share) {
    return 1u + uint(share * 14.0 + 0.5);
}
float unpackSeenPart(uint bits) {
    return float(bits - 1u) / 14.0;
}

// True if a moving object may block the light of a part. Lengths in sides of the volume.
bool isObjectBetween(vec3 position, SeenPart seen, float radius) {
    for (uint i = 0u; i < lightStep.objectCount; ++i) {
        vec4 object = lightStep.object[i];
        vec3 offset = object.xyz - position;
        float along = clamp(dot(offset, seen.towards), 0.0, seen.distance);
        if (length(offset - along * seen.towards) < object.w + radius * along / seen.distance) return true;
    }
    return false;
}

// After a move of cascades, faces that have taken over the light of another one take turns.
bool isDue(uint id) {
    if (lightStep.emitterTurns == 1u) return true;
    uint known = knownEmitters(id);
    bool isInTurn = (id >> 5u) % lightStep.emitterTurns == lightStep.frame % lightStep.emitterTurns;
    return known == emittersUnknown || known == emittersTakenOver && isInTurn;
}

void main() {
    uint count = visitedFaceCount(), firstDynamic = commands[dynamicList].firstId;
    uint dynamicCount = faceCount(dynamicList);
    uint stride = gl_NumWorkGroups.x * uint(VCT_LIST_GROUP);
    for (uint i = gl_GlobalInvocationID.x; i < count; i += stride) {
        uint id = visitedFaceId(i);
        ListedFace listed = baseFace(id);
        if (listed.isMerged || !isDue(id)) continue;
        SurfacePlane plane = facePlane(id);
        int cascade = cascadeOf(listed.voxel);
        vec3 start =
            surfaceMiddle(listed.voxel, listed.face, plane, faceExtent(id)) + startHeight * plane.normal;
        vec3 position = volumeFromVoxels(start, cascade), sum = vec3(0.0);
        bool isDynamic = id - firstDynamic < dynamicCount;
        for (int p = 0; p < emitters.count.x; ++p) {
            EmitterPartUniforms part = emitters.part[p];
            SeenPart seen = seenPart(part, position, plane.normal);
            if (!isStorable(seen.light)) continue;
            bool moves = (emitters.count.y >> p & 1) != 0;
            float share;
            if (isDynamic || moves) {
                share = visibleShare(part, seen, start, cascade, allGeometry);
            } else {
                uint at = irradianceAt(id) + VCT_FACE_SEEN_PARTS + uint(p / VCT_SEEN_PARTS),
                     shift = 4u * uint(p % VCT_SEEN_PARTS);
                uint bits = faceIrradianceData[at] >> shift & 15u;
                if (bits == 0u) {
                    bits = packSeenPart(visibleShare(part, seen, start, cascade, staticGeometry));
                    faceIrradianceData[at] |= bits << shift;
                }
                share = unpackSeenPart(bits);
                if (share > 0.0 && isObjectBetween(position, seen, part.position.w))
                    share *= visibleShare(part, seen, start, cascade, dynamicGeometry);
            }
            sum += share * seen.light;
        }
        storeEmitterIrradiance(id, sum, emittersKnown);
    }
}
