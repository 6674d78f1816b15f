// Driver check: the cross product of the derivatives of a position on a plane, as voxelization uses it for
// coverage.
#include "lab/driver_check.glsl"

void main() {
    vec2 pixel = gl_FragCoord.xy;
    vec3 position = vec3(0.5 * pixel.x + 0.25 * pixel.y, pixel.y, 0.125 * pixel.x - 0.5 * pixel.y);
    vec3 found = cross(dFdx(position), dFdy(position));
    vec3 right = cross(vec3(0.5, 0.0, 0.125), vec3(0.25, 1.0, -0.5));
    if (any(greaterThan(abs(found - right), vec3(0.01)))) atomicAdd(words[0], 1u);
    atomicAdd(words[1], 1u);
}
