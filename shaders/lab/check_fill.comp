// Driver check: fills a mip level of a 3D texture of 8^3 texels with values that depend on texel and level.
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;
layout(location = 0) uniform uint level;
layout(VCT_CHECK_FORMAT, binding = 0) writeonly uniform mediump image3D target;

void main() {
    ivec3 texel = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(texel, imageSize(target)))) return;
    float odd = float((texel.x + texel.y + texel.z) & 1);
    imageStore(target, texel, vec4(odd, 0.25 * float(level), 1.0 - odd, 1.0));
}
