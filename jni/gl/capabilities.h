// What the current driver can do, asked once. A missing capability is reported together with all the others.
#pragma once

#include <string>
#include <vector>

#include "gl/driver_faults.h"
#include "gl/shader_source.h"

namespace vct::gl {

// One row of what the pipeline needs.
struct Requirement {
    std::string name;      // "GL_OES_shader_image_atomic" or "GL_MAX_FRAGMENT_IMAGE_UNIFORMS >= 1"
    std::string found;     // what the driver reports
    std::string neededBy;  // which pass, and what would be lost without it
    bool required = true;  // false: the pipeline works without it, with the loss that neededBy names
    bool met = false;
};

// What settings are held to (engine/driver_needs.h).
struct Limits {
    int texture2d = 0, texture3d = 0, framebufferWidth = 0;  // texels
    int fragmentStorageBlocks = 0, combinedOutputs = 0;
};

struct Capabilities {
    std::string vendor, renderer, version, shadingLanguage;
    bool desktopContext = false;        // OSMesa: a desktop core context that compiles the ES sources
    bool essl320 = false;               // "#version 320 es" is accepted; otherwise 310 es plus extensions
    bool debugOutput = false;           // KHR_debug entry points are there
    bool softwareDriver = false;        // runs on the CPU: llvmpipe, softpipe, lavapipe
    bool texturesInMainMemory = false;  // so how much there is can be asked before they are made
    Limits limits;
    DriverFaults faults;
    int gpuTimerBits = 0;  // of the GPU's own clock; 0: GL_EXT_disjoint_timer_query is no use
    int uniformBufferOffsetAlignment = 256;
    std::vector<Requirement> requirements;

    Language language() const { return essl320 ? Language::essl320 : Language::essl310; }
    // Throws one vct::Error that names every required thing that is missing and what it is needed for.
    void requireAll() const;
    // False only for a row of the requirements that is not met.
    bool meets(const std::string& name) const;
};

// Queries the current context (gl::load must have run).
Capabilities queryCapabilities();

// The table that `vct info` prints.
std::string describe(const Capabilities& capabilities);

}  // namespace vct::gl
