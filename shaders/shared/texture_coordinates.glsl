// Passes the texture coordinates and the vertex colours that the material needs to the next stage.
#include "shared/layout.h"

#ifdef VCT_BASE_COLOR_TEXTURE
layout(location = VCT_ATTRIBUTE_UV) in vec2 uv;
out vec2 fragmentUv;
void passBaseColorUv() {
    fragmentUv = uv;
}
#else
void passBaseColorUv() {}
#endif

#ifdef VCT_EMISSIVE_TEXTURE
layout(location = VCT_ATTRIBUTE_EMISSIVE_UV) in vec2 emissiveUv;
out vec2 fragmentEmissiveUv;
void passEmissiveUv() {
    fragmentEmissiveUv = emissiveUv;
}
#else
void passEmissiveUv() {}
#endif

#ifdef VCT_VERTEX_COLORS
layout(location = VCT_ATTRIBUTE_COLOR) in vec4 color;
out vec4 fragmentColor;
void passColor() {
    fragmentColor = color;
}
#else
void passColor() {}
#endif

#ifdef VCT_GLOSS_TEXTURE
layout(location = VCT_ATTRIBUTE_GLOSS_UV) in vec2 glossUv;
out vec2 fragmentGlossUv;
void passGlossUv() {
    fragmentGlossUv = glossUv;
}
#else
void passGlossUv() {}
#endif

#ifdef VCT_NORMAL_MAP
layout(location = VCT_ATTRIBUTE_NORMAL_UV) in vec2 normalUv;
out vec2 fragmentNormalUv;
void passNormalUv() {
    fragmentNormalUv = normalUv;
}
#else
void passNormalUv() {}
#endif

void passTextureCoordinates() {
    passColor();
    passGlossUv();
    passNormalUv();
    passBaseColorUv();
    passEmissiveUv();
}
