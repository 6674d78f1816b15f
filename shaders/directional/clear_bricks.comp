// Clears the bricks of face irradiance, the texture of their locations, and the static walls of cascades that
// have moved. Each invocation clears a column of texels.
#include "directional/cascades.glsl"
#include "directional/walls.glsl"
#include "shared/commands.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(rgba16f, binding = VCT_IMAGE_IRRADIANCE) writeonly uniform mediump image3D irradianceTexels;
layout(r32ui, binding = VCT_IMAGE_BRICKS) writeonly uniform highp uimage3D brickSlots;
layout(r32ui, binding = VCT_IMAGE_STATIC_WALLS) writeonly uniform highp uimage3D staticWalls;
layout(location = VCT_UNIFORM_CASCADES) uniform uint moved;  // a bit per cascade whose walls are cleared

void main() {
    ivec2 column = ivec2(gl_GlobalInvocationID);
    if (column == ivec2(0)) fullBricks = flatBricks = 0u;
    ivec3 size = imageSize(irradianceTexels);
    if (all(lessThan(column, size.xy)))
        for (int z = 0; z < size.z; ++z) {
            imageStore(irradianceTexels, ivec3(column, z), vec4(0.0));
        }
    size = imageSize(brickSlots);
    if (all(lessThan(column, size.xy)))
        for (int z = 0; z < size.z; ++z) {
            imageStore(brickSlots, ivec3(column, z), uvec4(0u));
            int cascade = z / (frame.gridSide >> VCT_BRICK_LEVEL);
            if ((moved >> uint(cascade) & 1u) == 0u) continue;
            for (int word = 0; word < 2; ++word)
                imageStore(staticWalls, wallTexel(ivec3(column, z), word, size.z), uvec4(0u));
        }
}
