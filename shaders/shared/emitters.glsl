// The parts of lamps (jni/engine/emitters.h), each seen as one source.
#include "shared/layout.h"

layout(std140, binding = VCT_UBO_EMITTERS) uniform EmittersBlock {
    EmitterBlock emitters;
};

// The area that is seen of a part from afar, along the unit vector `towards` the part: that of what faces the eye and, of a
// closed convex surface, a quarter of it all (Cauchy).
float projectedArea(EmitterPartUniforms part, vec3 towards) {
    return max(-dot(part.facing.xyz, towards), 0.0) + part.facing.w;
}
