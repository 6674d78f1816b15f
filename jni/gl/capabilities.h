// Capabilities of the current driver, queried once. All missing capabilities are reported together.
#pragma once

#include <string>
#include <vector>

#include "gl/driver_faults.h"
#include "gl/shader_source.h"

namespace vct::gl {

// A feature or limit that the engine needs.
struct Requirement {
    std::string name;      // "GL_OES_shader_image_atomic" or "GL_MAX_FRAGMENT_IMAGE_UNIFORMS >= 1"
    std::string found;     // the driver's answer
    std::string neededBy;  // the pass that needs it, and the loss without it
    bool required = true;  // false: the engine works without it, with this loss
    bool met = false;
};

// The driver's limits for settings (engine/driver_needs.h).
struct Limits {
    int texture2d = 0, texture3d = 0, framebufferWidth = 0;  // texels
    int fragmentStorageBlocks = 0;
};

struct Capabilities {
    std::string vendor, renderer, version, shadingLanguage;
    bool desktopContext = false;        // OSMesa: a desktop core context that compiles the ES sources
    bool essl320 = false;               // "#version 320 es" is accepted; otherwise 310 es plus extensions
    bool debugOutput = false;           // KHR_debug exists
    bool softwareDriver = false;        // the driver runs on the CPU: llvmpipe, softpipe, lavapipe
    bool texturesInMainMemory = false;  // free main memory then tells if textures fit
    Limits limits;
    DriverFaults faults;
    int gpuTimerBits = 0;  // bits of the GPU's clock; 0: GL_EXT_disjoint_timer_query is unusable
    int uniformBufferOffsetAlignment = 256;
    std::vector<Requirement> requirements;

    Language language() const { return essl320 ? Language::essl320 : Language::essl310; }
    // Throws vct::Error that names all missing requirements and their purposes.
    void requireAll() const;
    // False if `name` is a requirement that is not met; else true.
    bool meets(const std::string& name) const;
};

// Queries the current context; gl::load() must have run.
Capabilities queryCapabilities();

// The table that `vct info` prints.
std::string describe(const Capabilities& capabilities);

}  // namespace vct::gl
