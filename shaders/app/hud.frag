// Fragments of the head-up display: vertex colour times the font's coverage. Also compiled as ESSL 3.00.
uniform sampler2D font;  // unit 0
in vec2 fragmentUv;
in vec4 fragmentColor;
layout(location = 0) out vec4 outColor;

void main() {
    outColor = fragmentColor * texture(font, fragmentUv);
}
