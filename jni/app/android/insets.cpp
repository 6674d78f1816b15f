// Reads the insets of the activity's window: activity.getWindow().getDecorView().getRootWindowInsets(). The
// method only reads what the view's last layout left, so the app's thread may call it.
#include <algorithm>
#include <optional>

#include "app/android/activity.h"
#include "app/android/java.h"

namespace vct::app {

namespace {

// WindowInsets.Type of Android 11: status bars, navigation bars, caption bar, display cutout.
constexpr jint barsAndCutout = 1 << 0 | 1 << 1 | 1 << 2 | 1 << 7;

// WindowInsets.getInsets() of Android 11.
std::optional<Edges> edgesOf(const Java& java, jobject insets) {
    const jobject edges = java.call(insets, "getInsets", "(I)Landroid/graphics/Insets;", barsAndCutout);
    if (edges == nullptr) return {};
    return Edges{java.intField(edges, "left").value_or(0), java.intField(edges, "top").value_or(0),
                 java.intField(edges, "right").value_or(0), java.intField(edges, "bottom").value_or(0)};
}

// Methods of Android 7, and of Android 9 for the cutout, which later ones replace.
Edges olderEdgesOf(const Java& java, jobject insets) {
    const jobject cutout = java.call(insets, "getDisplayCutout", "()Landroid/view/DisplayCutout;");
    const auto edge = [&](const char* ofBars, const char* ofCutout) {
        return std::max(java.callInt(insets, ofBars, "()I").value_or(0),
                        java.callInt(cutout, ofCutout, "()I").value_or(0));
    };
    return {edge("getSystemWindowInsetLeft", "getSafeInsetLeft"),
            edge("getSystemWindowInsetTop", "getSafeInsetTop"),
            edge("getSystemWindowInsetRight", "getSafeInsetRight"),
            edge("getSystemWindowInsetBottom", "getSafeInsetBottom")};
}

// WindowInsets.getRoundedCorner() of Android 12. Android numbers the corners clockwise from the top left.
int cornerRadius(const Java& java, jobject insets, jint corner) {
    const jobject rounded = java.call(insets, "getRoundedCorner", "(I)Landroid/view/RoundedCorner;", corner);
    return java.callInt(rounded, "getRadius", "()I").value_or(0);
}

}  // namespace

WindowInsets windowInsets(ANativeActivity& activity) {
    const Java java(activity.vm);
    const jobject window = java.call(activity.clazz, "getWindow", "()Landroid/view/Window;");
    const jobject view = java.call(window, "getDecorView", "()Landroid/view/View;");
    const jobject insets = java.call(view, "getRootWindowInsets", "()Landroid/view/WindowInsets;");
    WindowInsets result;
    if (insets == nullptr) return result;
    const std::optional<Edges> edges = edgesOf(java, insets);
    result.edges = edges ? *edges : olderEdgesOf(java, insets);
    for (std::size_t corner = 0; corner < result.cornerRadii.size(); ++corner)
        result.cornerRadii[corner] = cornerRadius(java, insets, static_cast<jint>(corner));
    return result;
}

}  // namespace vct::app
