// Moments of a shadow map: mean and variance of the depth around a texel (Donnelly and Lauritzen 2006). The
// variance itself is stored, not the mean of squares, because half floats would round their small difference
// to nothing.
const float momentUnit = 256.0;     // scale of stored depths: means of +-128, variances up to 2^14
const float momentMiddle = 0.5;     // depth that is stored as 0, near which half floats are finest
const float momentRounding = 3e-4;  // rounding error of a stored mean, as a depth
const float minVariance = 0.0625;   // minimum of a stored variance: a standard deviation of 0.001 in depth

// A texel of the next level averages the 4 x 4 texels around its middle with the weights (1 3 3 1)/8 in each
// direction. Repeated over the levels this is a smooth filter, and the filters of neighbours overlap. Weights
// in the order of textureGather(), for the four texels at the lower left, the lower right, the upper left and
// the upper right.
const vec4 weightLowerLeft = vec4(3.0, 9.0, 3.0, 1.0) / 64.0;
const vec4 weightLowerRight = vec4(9.0, 3.0, 1.0, 3.0) / 64.0;
const vec4 weightUpperLeft = vec4(1.0, 3.0, 9.0, 3.0) / 64.0;
const vec4 weightUpperRight = vec4(3.0, 1.0, 3.0, 9.0) / 64.0;

// Mean and variance of 16 depths.
vec2 momentsOf(vec4 lowerLeft, vec4 lowerRight, vec4 upperLeft, vec4 upperRight) {
    vec4 a = weightLowerLeft * lowerLeft, b = weightLowerRight * lowerRight;
    vec4 c = weightUpperLeft * upperLeft, d = weightUpperRight * upperRight;
    float mean = dot(a + b + c + d, vec4(1.0));
    float squares = dot(a * lowerLeft + b * lowerRight + c * upperLeft + d * upperRight, vec4(1.0));
    return vec2(mean, squares - mean * mean);
}
