// The counts of all lists and their indirect commands. shared/commands.glsl has the lists of voxels as well.
#include "shared/layout.h"

layout(std430, binding = VCT_SSBO_COMMANDS) buffer CommandBlock {
    LevelCommands commands[VCT_LISTS];
    uint dynamicList;
    uint blockedRays;
    uint mostBlockedRays;
    uint unplacedFaces;
    uint unusedIds;
    uint takenIds;
    uint staticSums;
    uint takenSums;
    uint sumsById;
    uint pageCapacity;
    uint freePages;
    uint takenPages;
    uint firstFreePage;
    uint brickLayers[VCT_MAX_CASCADES];
};
