// Reads accessors. Every range is checked before a byte is read, because offsets, strides and counts of a
// file may be wrong.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/gltf_file.h"

namespace vct {

// Returns the bytes of a buffer view, decompressed if necessary. Throws vct::Error if the view does not lie
// inside its buffer or cannot be decompressed.
ByteRange viewBytes(GltfFile& file, int bufferView);

// Component types that an attribute may have.
enum class Components { floatOnly, floatOrNormalizedUnsigned, floatOrNormalized, anySmallInteger };

// Reads an accessor of `width` floats per element (1 to 4, or 16 for a matrix, column by column). Converts
// normalized integers and applies sparse values. `attribute` names the accessor in an error. `chosen`: reads
// these elements only, which are ascending and below the accessor's count.
std::vector<float> readFloats(GltfFile& file, int accessor, int width, Components components,
                              const std::string& attribute,
                              const std::vector<std::uint32_t>* chosen = nullptr);

// The vertices of a primitive: all elements of its accessors, or some. A file may have thousands of
// primitives that share the accessors of all vertices, and each would have a copy of them.
struct VertexChoice {
    std::size_t declared = 0;           // elements of each accessor
    std::vector<std::uint32_t> chosen;  // ascending; empty: all

    std::size_t count() const { return chosen.empty() ? declared : chosen.size(); }
};

// Chooses the vertices that the indices use, if these are at most half of those in the accessors, and makes
// the indices refer to them.
VertexChoice chooseVertices(std::size_t declared, std::vector<std::uint32_t>& indices);

// As readFloats(), for the vertices of a primitive. Throws vct::Error if the accessor has another number of
// elements.
std::vector<float> readVertexFloats(GltfFile& file, int accessor, int width, Components components,
                                    const std::string& attribute, const VertexChoice& vertices);

// Reads indices of any unsigned type. Throws vct::Error if one is not below `vertexCount`.
std::vector<std::uint32_t> readIndices(GltfFile& file, int accessor, std::size_t vertexCount);

}  // namespace vct
