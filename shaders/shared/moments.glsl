// Moments of a shadow map: the mean depth around a texel and its variance (Donnelly and Lauritzen 2006), kept apart so that
// half floats do: the difference of two means of squares would be lost in their rounding.

const float momentUnit = 256.0;     // halves: means of +-128, variances up to 2^14
const float momentMiddle = 0.5;     // of the depth range, where halves are finest
const float momentRounding = 3e-4;  // of the depth range: a half's, once for each of the first levels
const float leastVariance = 0.0625;  // of (256 depths)^2: at a thousandth of the range a blocker is no rounding

// The 16 texels around the corner that a coarser texel's middle is, weighed (1 3 3 1)/8 in each direction: repeated over the
// levels that is smooth, and neighbours overlap, so that between them the filter knows an edge as they do. In the order of
// textureGather(), for the four texels at the lower left, the lower right, the upper left and the upper right.
const vec4 weightLowerLeft = vec4(3.0, 9.0, 3.0, 1.0) / 64.0;
const vec4 weightLowerRight = vec4(9.0, 3.0, 1.0, 3.0) / 64.0;
const vec4 weightUpperLeft = vec4(1.0, 3.0, 9.0, 3.0) / 64.0;
const vec4 weightUpperRight = vec4(3.0, 1.0, 3.0, 9.0) / 64.0;

// Of 16 depths: their mean and their variance.
vec2 momentsOf(vec4 lowerLeft, vec4 lowerRight, vec4 upperLeft, vec4 upperRight) {
    vec4 a = weightLowerLeft * lowerLeft, b = weightLowerRight * lowerRight;
    vec4 c = weightUpperLeft * upperLeft, d = weightUpperRight * upperRight;
    float mean = dot(a + b + c + d, vec4(1.0));
    float squares = dot(a * lowerLeft + b * lowerRight + c * upperLeft + d * upperRight, vec4(1.0));
    return vec2(mean, squares - mean * mean);
}
