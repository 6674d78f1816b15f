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
// normalized integers and applies sparse values. `attribute` names the accessor in an error.
std::vector<float> readFloats(GltfFile& file, int accessor, int width, Components components,
                              const std::string& attribute);

// Reads indices of any unsigned type. Throws vct::Error if one is not below `vertexCount`.
std::vector<std::uint32_t> readIndices(GltfFile& file, int accessor, std::size_t vertexCount);

}  // namespace vct
