#include "gl/driver_faults.h"

#include <cstdio>

namespace vct::gl {

namespace {

bool startsWith(const std::string& text, const char* start) {
    return text.rfind(start, 0) == 0;
}

// "Adreno (TM) 530": 5; 0 for other GPUs.
int adrenoSeries(const std::string& renderer) {
    int model = 0;
    return std::sscanf(renderer.c_str(), "Adreno (TM) %d", &model) == 1 ? model / 100 : 0;
}

// Of GL_VERSION, "OpenGL ES 3.2 build 1.13@5720833": whether it is older than that one. A driver that does
// not say is as old as can be.
bool isRogueBefore(const std::string& version, int major, int minor) {
    int foundMajor = 0, foundMinor = 0;
    const std::size_t at = version.find("build ");
    if (at != std::string::npos) std::sscanf(version.c_str() + at, "build %d.%d", &foundMajor, &foundMinor);
    return foundMajor != major ? foundMajor < major : foundMinor < minor;
}

}  // namespace

DriverFaults faultsOf(const std::string& renderer, const std::string& version) {
    DriverFaults faults;
    // Before r46 timer queries corrupt memory or crash: Filament, OpenGLContext.cpp, dont_use_timer_query
    // (b/233754398, b/273759031). On the Mali-T880 of 2016 they are broken: Chromium, gpu_driver_bug_list
    // #247. From Valhall on, without an end, they crash where a framebuffer is unbound or deleted meanwhile,
    // as every step of a frame binds its own: ANGLE, flush_queries_before_deleting_or_unbinding_fbo
    // (crbug 534468209). That is every Mali.
    if (startsWith(renderer, "Mali-"))
        faults.timerQueries =
            "they crash on Mali drivers before r46, and on later ones if framebuffers change meanwhile "
            "(Filament b/233754398, Chromium #247, ANGLE crbug 534468209)";
    // After 256 queries they fail on Adreno 4xx, and they block on 3xx to 5xx before Android 8.1, which GL
    // does not tell: Chromium, gpu_driver_bug_list #113 and #240.
    const int series = adrenoSeries(renderer);
    if (series >= 3 && series <= 5)
        faults.timerQueries = "they fail or block on Adreno 3xx to 5xx (Chromium #113, #240)";
    // Skia, GrGLCaps.cpp, fShaderDerivativeSupport (crbug 1197152, b/187364475).
    if (startsWith(renderer, "PowerVR Rogue") && isRogueBefore(version, 1, 16))
        faults.derivatives = "wrong on PowerVR Rogue before driver 1.16 (Skia, crbug 1197152)";
    return faults;
}

}  // namespace vct::gl
