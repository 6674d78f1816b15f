// Two ways to project each triangle along its dominant axis for voxelization (thesis algorithm 7).
#pragma once

#include <string>

#include "engine/settings.h"
#include "gl/capabilities.h"

namespace vct {

// Both ways give exactly the same voxels.
enum class Voxelization {
    geometryShader,  // a geometry shader finds the axis, as in the thesis
    // Triangles are sorted by axis when the scene is loaded, and again when they move. Some drivers have no
    // geometry shaders. Mali GPUs have no hardware for them, and Arm's Mali GPU Best Practices advise against
    // them: the thesis's voxelization took 301 ms of a frame of 856 ms.
    sortedAxes,
};

inline const char* voxelizationName(Voxelization voxelization) {
    return voxelization == Voxelization::geometryShader ? "geometry-shader" : "sorted-axes";
}

// Packed voxels follow the thesis, so they use a geometry shader if the driver has it.
inline Voxelization voxelizationFor(Voxels voxels, const gl::Capabilities& capabilities) {
    return voxels == Voxels::packed && capabilities.meets("GL_EXT_geometry_shader")
               ? Voxelization::geometryShader
               : Voxelization::sortedAxes;
}

// Samples of a pixel while directional voxels are made: four if a fragment knows which of them its triangle
// covers. Without GL_OES_sample_variables, each sample is a pixel.
inline int pixelSamplesFor(const gl::Capabilities& capabilities) {
    return capabilities.meets("GL_OES_sample_variables") ? 4 : 1;
}

// A note for the user if packed voxels have to do without the geometry shader; else "".
inline std::string voxelizationNote(Voxels voxels, const gl::Capabilities& capabilities) {
    if (voxels == Voxels::directional ||
        voxelizationFor(voxels, capabilities) == Voxelization::geometryShader)
        return "";
    return "note: the driver has no GL_EXT_geometry_shader, so triangles are sorted by axis; the voxels are "
           "the same";
}

}  // namespace vct
