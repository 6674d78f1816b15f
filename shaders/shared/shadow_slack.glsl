// Whether the surface under a pixel is flat or curved, for the shadow map's look-up (shared/shadow.glsl). Across a crease
// normals jump, a component of them by 0.8 where it is one of 90 degrees; the least change is that of their 16 bits. Call it
// before any branch: derivatives need the whole quad.
#include "shared/shadow.glsl"

float shadowSlack(vec3 normal) {
    vec3 change = fwidth(normal);
    float most = max(max(change.x, change.y), change.z);
    return most > 2e-4 && most < 0.8 ? curvedSlack : flatSlack;
}
