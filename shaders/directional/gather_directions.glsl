// The sine of the angle between the normal and direction `i` of the set below.
float gatherSine(int i) {
    return sqrt(float(bitfieldReverse(uint(i))) / 4294967296.0 + 0.5 / float(VCT_GATHER_DIRECTIONS));
}
// Direction `i` of a Hammersley set of VCT_GATHER_DIRECTIONS (a power of two) around a normal along +y, with
// a density in proportion to the cosine of the angle to the normal (docs/voxel-cone-tracing.md, section 7).
vec3 gatherDirection(int i) {
    float sine = gatherSine(i), azimuth = 6.2831853 / float(VCT_GATHER_DIRECTIONS) * float(i);
    return vec3(sine * cos(azimuth), sqrt(1.0 - sine * sine), sine * sin(azimuth));
}

// The solid angle that one direction of the set stands for: pi / (N cos), by its density. `height`: its
// cosine.
float gatherSolidAngle(float height) {
    return 3.1415927 / (float(VCT_GATHER_DIRECTIONS) * height);
}
