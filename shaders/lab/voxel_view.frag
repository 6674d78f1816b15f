// Flat colour per voxel, with the three visible sides told apart.
flat in vec3 color;
in vec3 corner;
layout(location = 0) out vec4 outColor;

void main() {
    vec3 side = step(0.4999, abs(corner - 0.5));  // the axis on which the point lies on the cube's surface
    outColor = vec4(color * (1.0 - 0.25 * side.x - 0.1 * side.z), 1.0);
}
