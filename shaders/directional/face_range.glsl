// The ranges of the directional voxels in this light step, as directional/choose_range.comp chose them.
#include "shared/layout.h"

layout(std140, binding = VCT_UBO_FACE_RANGE) uniform FaceRangeBlock {
    FaceRange faceRange;
};
