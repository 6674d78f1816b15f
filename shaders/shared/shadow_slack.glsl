// The tolerance of the shadow map's look-up (shared/shadow.glsl) for the surface under a pixel: curved if the
// normal changes from pixel to pixel. Smaller changes are rounding of 16 bits; larger ones are creases,
// at which a component jumps by 0.8 if they have 90 degrees. Call it before any branch, because derivatives
// need the whole quad.
#include "shared/shadow.glsl"

float shadowSlack(vec3 normal) {
    vec3 change = fwidth(normal);
    float most = max(max(change.x, change.y), change.z);
    return most > 2e-4 && most < 0.8 ? curvedSlack : flatSlack;
}
