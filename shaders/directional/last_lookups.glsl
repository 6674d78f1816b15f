// When pixels have last looked up the faces of each block (directional/mark_lookups.comp).
#include "directional/face_irradiance.glsl"

layout(binding = VCT_TEX_LAST_LOOKUPS) uniform highp usampler3D lastLookups;

// A step marks only some of the blocks that its pixels look up, so this many steps count.
const uint lookupLifetime = 16u;

bool isLookedUp(ivec3 blockTexel) {
    uint last = texelFetch(lastLookups, blockTexel, 0).r;
    return last != 0u && lightStep.frame + 1u - last < lookupLifetime;
}
