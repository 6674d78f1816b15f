// What is seen where nothing of the scene is in the way, relative to E/pi: the same in all directions, or, with
// VCT_ENVIRONMENT, a cube map of them (jni/engine/environment.h). Volume space has the world's axes.
#include "shared/frame.glsl"

#ifdef VCT_ENVIRONMENT
layout(binding = VCT_TEX_ENVIRONMENT) uniform mediump samplerCube environment;

// The mean over a cone of a solid angle (sr): of the mip level whose texels fill as much of a face's middle. The filter
// between its texels and levels is about twice as wide.
mediump vec3 sampleSky(vec3 direction, float solidAngle) {
    float side = float(textureSize(environment, 0).x);
    float level = max(0.5 * log2(0.25 * side * side * max(solidAngle, 1e-9)), 0.0);
    return textureLod(environment, direction, level).rgb;
}

// Behind a pixel. `window`: gl_FragCoord's.
mediump vec3 skyBehind(vec2 window) {
    vec4 near = frame.volumeFromWindow * vec4(window, 0.0, 1.0);
    vec4 far = frame.volumeFromWindow * vec4(window, 1.0, 1.0);  // at infinity, perhaps: its w is 0 then
    return sampleSky(far.xyz * near.w - near.xyz * far.w, 0.0);
}
#else
mediump vec3 sampleSky(vec3 direction, float solidAngle) {
    return frame.skyRadiance.rgb;
}
mediump vec3 skyBehind(vec2 window) {
    return frame.skyRadiance.rgb;
}
#endif
