// Reads accessors. Every range is checked before a byte is read: offsets, strides and counts may lie.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/gltf_file.h"

namespace vct {

// The bytes of a buffer view, unpacked where it is packed; throws where it does not lie inside its buffer, or
// cannot be unpacked.
ByteRange viewBytes(GltfFile& file, int bufferView);

// Which component types an attribute may have besides float.
enum class Components { floatOnly, floatOrNormalizedUnsigned, floatOrNormalized, anySmallInteger };

// `width` (1 to 4, or the 16 of a matrix, column by column) floats per element, normalized integers
// converted, sparse values put in place. `attribute` names it in an error.
std::vector<float> readFloats(GltfFile& file, int accessor, int width, Components components,
                              const std::string& attribute);

// Indices of any unsigned type; throws where one is not below `vertexCount`.
std::vector<std::uint32_t> readIndices(GltfFile& file, int accessor, std::size_t vertexCount);

}  // namespace vct
