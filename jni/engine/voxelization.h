// How each triangle is projected along the axis that it faces most (thesis algorithm 7).
#pragma once

#include <string>

#include "engine/settings.h"
#include "gl/capabilities.h"

namespace vct {

// Both give the same voxels, bit for bit.
enum class Voxelization {
    geometryShader,  // finds the axis, as in the thesis
    // Triangles are sorted by their axis when the scene is loaded, and again when they move. Some drivers
    // have no geometry shaders; Mali GPUs have no hardware for them, and Arm's Mali GPU Best Practices advise
    // against them (the thesis's voxelization took 301 ms of a frame of 856).
    sortedAxes,
};

inline const char* voxelizationName(Voxelization voxelization) {
    return voxelization == Voxelization::geometryShader ? "geometry-shader" : "sorted-axes";
}

// Packed voxels are the thesis's, so they use its geometry shader where the driver has it.
inline Voxelization voxelizationFor(Voxels voxels, const gl::Capabilities& capabilities) {
    return voxels == Voxels::packed && capabilities.meets("GL_EXT_geometry_shader")
               ? Voxelization::geometryShader
               : Voxelization::sortedAxes;
}

// Tells the user that packed voxels are made in the other way; "" where there is nothing to tell.
inline std::string voxelizationNote(Voxels voxels, const gl::Capabilities& capabilities) {
    if (voxels == Voxels::directional ||
        voxelizationFor(voxels, capabilities) == Voxelization::geometryShader)
        return "";
    return "note: the driver has no GL_EXT_geometry_shader, so triangles are sorted by axis; the voxels are "
           "the same";
}

}  // namespace vct
