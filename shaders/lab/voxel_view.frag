// Colours a voxel's cube; its sides have different brightness.
flat in vec3 color;
in vec3 corner;
layout(location = 0) out vec4 outColor;

void main() {
    vec3 side = step(0.4999, abs(corner - 0.5));  // 1 for the axis of the cube's side
    outColor = vec4(color * (1.0 - 0.25 * side.x - 0.1 * side.z), 1.0);
}
