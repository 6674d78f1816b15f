// Passes on what the material's textures are read at, where it has any.
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

void passTextureCoordinates() {
    passBaseColorUv();
    passEmissiveUv();
}
