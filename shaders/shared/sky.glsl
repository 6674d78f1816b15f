// The sky's radiance, relative to E/pi: one colour or, with VCT_ENVIRONMENT, a cube map
// (jni/engine/environment.h). Directions are in volume space, which has the world's axes.
#include "shared/frame.glsl"

#ifdef VCT_ENVIRONMENT
layout(binding = VCT_TEX_ENVIRONMENT) uniform mediump samplerCube environment;

// Mean radiance over a cone of a solid angle (sr). In the middle of a face, the texels of the mip level have
// this solid angle; the filter is about twice as wide.
mediump vec3 sampleSky(vec3 direction, float solidAngle) {
    float side = float(textureSize(environment, 0).x);
    float level = max(0.5 * log2(0.25 * side * side * max(solidAngle, 1e-9)), 0.0);
    return textureLod(environment, direction, level).rgb;
}

// The sky behind a pixel. `window`: gl_FragCoord.xy.
mediump vec3 skyBehind(vec2 window) {
    vec4 near = frame.volumeFromWindow * vec4(window, 1.0 - frame.farDepth, 1.0);
    vec4 far = frame.volumeFromWindow * vec4(window, frame.farDepth, 1.0);  // w is 0 if it is at infinity
    return sampleSky(far.xyz * near.w - near.xyz * far.w, 0.0);
}
#else
mediump vec3 sampleSky(vec3 direction, float solidAngle) {
    return frame.skyRadiance.rgb;
}
mediump vec3 skyBehind(vec2 window) {
    return frame.background.rgb;
}
#endif
