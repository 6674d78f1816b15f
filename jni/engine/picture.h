// What the last pass draws, and what it reads for that.
#pragma once

#include "shared/layout.h"

namespace vct {

// One of VCT_MODE_*, the five modes, or of VCT_VIEW_*, one part of the light alone.
using Picture = int;

inline bool readsShadowMap(Picture picture) {
    return picture != VCT_MODE_PHONG;
}
inline bool showsSoftShadow(Picture picture) {
    return picture == VCT_MODE_GI_CONE_SHADOW || picture == VCT_VIEW_CONE_SHADOW;
}
inline bool readsVoxels(Picture picture) {
    return picture >= VCT_MODE_AO;
}
inline bool showsAmbientVisibility(Picture picture) {
    return picture == VCT_MODE_AO || picture == VCT_VIEW_AO;
}
inline bool showsIndirectLight(Picture picture) {
    return readsVoxels(picture) && !showsAmbientVisibility(picture) && picture != VCT_VIEW_CONE_SHADOW;
}

}  // namespace vct
