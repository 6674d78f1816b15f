// Vertices of the head-up display, in pixels from the top left. Also compiled as ESSL 3.00.
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 color;
uniform vec4 window;  // xy: 2 / size of the window in pixels
out vec2 fragmentUv;
out vec4 fragmentColor;

void main() {
    fragmentUv = uv;
    fragmentColor = color;
    gl_Position = vec4(position.x * window.x - 1.0, 1.0 - position.y * window.y, 0.0, 1.0);
}
