// The number of the light step in which pixels last looked up each block's faces
// (directional/mark_lookups.comp).
#include "directional/face_irradiance.glsl"

layout(binding = VCT_TEX_LAST_LOOKUPS) uniform highp usampler3D lastLookups;

// Number of steps that count as recent. A single step marks only some of the blocks that its pixels look up.
const uint lookupLifetime = 16u;

bool isLookedUp(ivec3 blockTexel) {
    uint last = texelFetch(lastLookups, blockTexel, 0).r;
    return last != 0u && lightStep.frame + 1u - last < lookupLifetime;
}
