#include "app/android/activity.h"

#include <filesystem>

namespace vct::app {

std::string filesFolder(const ANativeActivity& activity) {
    for (const char* path : {activity.externalDataPath, activity.internalDataPath})
        if (path != nullptr && *path != '\0') {
            std::error_code ignored;
            std::filesystem::create_directories(path, ignored);
            return path;
        }
    return "";
}

float pixelsPerDp(AConfiguration* configuration) {
    const int density = AConfiguration_getDensity(configuration);
    // Special values above that mean "any" and "none".
    return density > 0 && density < ACONFIGURATION_DENSITY_ANY ? static_cast<float>(density) / 160.0F : 1.0F;
}

bool isTouch(const AInputEvent* event) {
    if (AInputEvent_getType(event) != AINPUT_EVENT_TYPE_MOTION) return false;
    switch (AMotionEvent_getAction(event) & AMOTION_EVENT_ACTION_MASK) {
        case AMOTION_EVENT_ACTION_DOWN:
        case AMOTION_EVENT_ACTION_UP:
        case AMOTION_EVENT_ACTION_MOVE:
        case AMOTION_EVENT_ACTION_CANCEL:
        case AMOTION_EVENT_ACTION_POINTER_DOWN:
        case AMOTION_EVENT_ACTION_POINTER_UP:
            return true;
        default:
            return false;
    }
}

std::vector<TouchPoint> fingersAfter(const AInputEvent* event) {
    const int action = AMotionEvent_getAction(event);
    const int kind = action & AMOTION_EVENT_ACTION_MASK;
    std::vector<TouchPoint> points;
    if (kind == AMOTION_EVENT_ACTION_UP || kind == AMOTION_EVENT_ACTION_CANCEL) return points;
    const auto lifted = static_cast<std::size_t>((action & AMOTION_EVENT_ACTION_POINTER_INDEX_MASK) >>
                                                 AMOTION_EVENT_ACTION_POINTER_INDEX_SHIFT);
    for (std::size_t i = 0; i < AMotionEvent_getPointerCount(event); ++i)
        if (kind != AMOTION_EVENT_ACTION_POINTER_UP || i != lifted)
            points.push_back({AMotionEvent_getPointerId(event, i),
                              {AMotionEvent_getX(event, i), AMotionEvent_getY(event, i)}});
    return points;
}

}  // namespace vct::app
