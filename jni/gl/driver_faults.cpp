#include "gl/driver_faults.h"

#include <cstdio>

namespace vct::gl {

namespace {

bool startsWith(const std::string& text, const char* start) {
    return text.rfind(start, 0) == 0;
}

// The series of an Adreno GPU: 5 for "Adreno (TM) 530"; 0 for other GPUs.
int adrenoSeries(const std::string& renderer) {
    int model = 0;
    return std::sscanf(renderer.c_str(), "Adreno (TM) %d", &model) == 1 ? model / 100 : 0;
}

// True if the driver build in GL_VERSION ("OpenGL ES 3.2 build 1.13@5720833") is older than major.minor, or
// is not stated.
bool isRogueBefore(const std::string& version, int major, int minor) {
    int foundMajor = 0, foundMinor = 0;
    const std::size_t at = version.find("build ");
    if (at != std::string::npos) std::sscanf(version.c_str() + at, "build %d.%d", &foundMajor, &foundMinor);
    return foundMajor != major ? foundMajor < major : foundMinor < minor;
}

}  // namespace

DriverFaults faultsOf(const std::string& renderer, const std::string& version) {
    DriverFaults faults;
    // Timer queries are unusable on every Mali. Before r46 they corrupt memory or crash (Filament,
    // OpenGLContext.cpp, dont_use_timer_query, b/233754398, b/273759031). On the Mali-T880 of 2016 they fail
    // (Chromium, gpu_driver_bug_list #247). Valhall and later GPUs crash if a framebuffer is unbound or
    // deleted during a query, as happens in every step of a frame (ANGLE,
    // flush_queries_before_deleting_or_unbinding_fbo, crbug 534468209).
    if (startsWith(renderer, "Mali-"))
        faults.timerQueries =
            "they crash on Mali drivers before r46, and on later ones if framebuffers change meanwhile "
            "(Filament b/233754398, Chromium #247, ANGLE crbug 534468209)";
    // On Adreno 4xx queries fail after the 256th, and on 3xx to 5xx they block before Android 8.1, a version
    // that GL does not report (Chromium, gpu_driver_bug_list #113 and #240).
    const int series = adrenoSeries(renderer);
    if (series >= 3 && series <= 5)
        faults.timerQueries = "they fail or block on Adreno 3xx to 5xx (Chromium #113, #240)";
    // Source: Skia, GrGLCaps.cpp, fShaderDerivativeSupport (crbug 1197152, b/187364475).
    if (startsWith(renderer, "PowerVR Rogue") && isRogueBefore(version, 1, 16))
        faults.derivatives = "wrong on PowerVR Rogue before driver 1.16 (Skia, crbug 1197152)";
    // Observed on an H100 with driver 580.159.04. Some dispatches read the counts that the CPU uploaded,
    // although shaders have written others; glFinish() and all bits of glMemoryBarrier() do not help, while
    // mapping the buffer shows the right counts.
    if (version.find("NVIDIA") != std::string::npos)
        faults.indirectDispatches = "they miss counts that shaders wrote, on NVIDIA's driver 580";
    return faults;
}

}  // namespace vct::gl
