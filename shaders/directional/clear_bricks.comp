// Clears the bricks of face irradiance and the textures of their locations and walls. Each invocation clears
// a column of texels.
#include "shared/counters.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f, binding = VCT_IMAGE_IRRADIANCE) writeonly uniform mediump image3D irradianceTexels;
layout(r32ui, binding = VCT_IMAGE_BRICKS) writeonly uniform highp uimage3D brickSlots;
layout(r32ui, binding = VCT_IMAGE_WALLS) writeonly uniform highp uimage3D walls;

void main() {
    COUNT(VCT_COUNTER_BRICKS_CLEAR);
    ivec2 column = ivec2(gl_GlobalInvocationID);
    ivec3 size = imageSize(irradianceTexels);
    if (all(lessThan(column, size.xy)))
        for (int z = 0; z < size.z; ++z) {
            COUNT(VCT_COUNTER_BRICKS_CLEAR_TEXEL);
            imageStore(irradianceTexels, ivec3(column, z), vec4(0.0));
        }
    size = imageSize(brickSlots);
    if (all(lessThan(column, size.xy)))
        for (int z = 0; z < size.z; ++z) {
            COUNT(VCT_COUNTER_BRICKS_CLEAR_PLACE);
            imageStore(brickSlots, ivec3(column, z), uvec4(0u));
            imageStore(walls, ivec3(column, z), uvec4(0u));
        }
}
