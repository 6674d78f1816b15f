// Driver check: samples a level in the middle between eight texels and compares the result with the values of
// check_fill.comp, or with 0 if the texture was cleared.
#include "lab/driver_check.glsl"

layout(local_size_x = 1) in;
layout(location = 0) uniform uint level;
layout(binding = 0) uniform mediump sampler3D source;

void main() {
    vec3 size = vec3(8 >> int(level));
    vec4 right = VCT_CHECK_CLEARED ? vec4(0.0) : vec4(0.5, 0.25 * float(level), 0.5, 1.0);
    for (float x = 1.0; x < size.x; ++x) {
        vec4 found = textureLod(source, vec3(x, 1.0, size.z - 1.0) / size, float(level));
        if (any(greaterThan(abs(found - right), vec4(0.01)))) atomicAdd(words[level], 1u);
    }
    atomicAdd(groups[0], 1u);
}
