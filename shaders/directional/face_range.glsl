// The ranges of the directional voxels in this light step, chosen by directional/choose_range.comp.
#include "shared/layout.h"

layout(std140, binding = VCT_UBO_FACE_RANGE) uniform FaceRangeBlock {
    FaceRange faceRange;
};
