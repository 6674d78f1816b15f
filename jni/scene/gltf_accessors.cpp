#include "scene/gltf_accessors.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

#include "scene/gltf_packings.h"

namespace vct {
namespace {

std::string named(int accessor) {
    return "accessor " + std::to_string(accessor);
}

bool isUnsignedInteger(int type) {
    return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

// Size of a component type in bytes, or 0 if there is no such type.
std::size_t componentBytes(int type) {
    return static_cast<std::size_t>(
        std::max(tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(type)), 0));
}

// Returns the first of `count` elements, after checking that all of them lie inside the buffer view.
const unsigned char* checkedElements(const GltfFile& file, ByteRange view, std::size_t offset,
                                     std::size_t stride, std::size_t elementSize, std::size_t count,
                                     const std::string& what) {
    const bool fits = count == 0 || (offset <= view.size && elementSize <= view.size - offset &&
                                     count - 1 <= (view.size - offset - elementSize) / stride);
    if (!fits)
        file.fail(what + " (" + std::to_string(count) + " elements) reaches beyond its buffer view of " +
                  std::to_string(view.size) + " bytes");
    return count == 0 ? nullptr : view.data + offset;
}

template <class T>
T load(const unsigned char* bytes) {
    T value;
    std::memcpy(&value, bytes,
                sizeof value);  // the data may be unaligned; glTF and all targets are little-endian
    return value;
}

std::uint32_t loadUnsigned(const unsigned char* bytes, std::size_t size) {
    if (size == 1) return bytes[0];
    return size == 2 ? load<std::uint16_t>(bytes) : load<std::uint32_t>(bytes);
}

// glTF 2.0 section 3.6.2.2: a normalized integer is divided by the largest value of its type and clamped at
// -1.
template <class T>
float loadInteger(const unsigned char* bytes, bool normalized) {
    const float value = load<T>(bytes);
    return normalized ? std::max(value / std::numeric_limits<T>::max(), -1.0F) : value;
}

float loadFloat(const unsigned char* bytes, int type, bool normalized) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
            return loadInteger<std::int8_t>(bytes, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return loadInteger<std::uint8_t>(bytes, normalized);
        case TINYGLTF_COMPONENT_TYPE_SHORT:
            return loadInteger<std::int16_t>(bytes, normalized);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return loadInteger<std::uint16_t>(bytes, normalized);
        default:
            return load<float>(bytes);
    }
}

void applySparse(GltfFile& file, const tinygltf::Accessor& accessor, std::size_t elementSize,
                 const std::vector<std::uint32_t>* chosen, std::vector<unsigned char>& elements,
                 const std::string& name) {
    const auto& sparse = accessor.sparse;
    const int indexType = sparse.indices.componentType;
    if (!isUnsignedInteger(indexType))
        file.fail("the sparse part of " + name + " has indices of type " + std::to_string(indexType));
    const auto count = static_cast<std::size_t>(sparse.count);
    const std::size_t indexSize = componentBytes(indexType);
    const unsigned char* indices = checkedElements(
        file, viewBytes(file, sparse.indices.bufferView), static_cast<std::size_t>(sparse.indices.byteOffset),
        indexSize, indexSize, count, "the sparse indices of " + name);
    const unsigned char* values = checkedElements(
        file, viewBytes(file, sparse.values.bufferView), static_cast<std::size_t>(sparse.values.byteOffset),
        elementSize, elementSize, count, "the sparse values of " + name);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t target = loadUnsigned(indices + i * indexSize, indexSize);
        if (target >= accessor.count)
            file.fail("the sparse part of " + name + " writes element " + std::to_string(target) + " of " +
                      std::to_string(accessor.count));
        std::size_t place = target;
        if (chosen != nullptr) {
            const auto found = std::lower_bound(chosen->begin(), chosen->end(), target);
            if (found == chosen->end() || *found != target) continue;
            place = static_cast<std::size_t>(found - chosen->begin());
        }
        std::memcpy(&elements[place * elementSize], values + i * elementSize, elementSize);
    }
}

// Copies the elements of an accessor without gaps, or only the chosen ones.
std::vector<unsigned char> packedElements(GltfFile& file, int index, std::size_t elementSize,
                                          const std::string& name,
                                          const std::vector<std::uint32_t>* chosen = nullptr) {
    const tinygltf::Accessor& accessor = file.model.accessors[static_cast<std::size_t>(index)];
    const unsigned char* first = nullptr;  // null without a buffer view: zeros, usually with sparse values
    std::size_t stride = elementSize;
    const auto unpacked = file.unpackedAccessors.find(index);
    if (unpacked != file.unpackedAccessors.end()) {
        const ByteRange elements{unpacked->second.data(), unpacked->second.size()};
        first = checkedElements(file, elements, 0, stride, elementSize, accessor.count, name);
    } else if (accessor.bufferView >= 0) {
        const ByteRange view = viewBytes(file, accessor.bufferView);
        const std::size_t declared = file.model.bufferViews[accessor.bufferView].byteStride;
        if (declared != 0) stride = declared;
        if (stride < elementSize)
            file.fail(name + " has a stride of " + std::to_string(stride) + " bytes for elements of " +
                      std::to_string(elementSize) + " bytes");
        first = checkedElements(file, view, accessor.byteOffset, stride, elementSize, accessor.count, name);
    }
    // If the file requires an unsupported extension, elements without a buffer view are probably stored by
    // it, and not zeros.
    if (first == nullptr && accessor.count > 0 && !accessor.sparse.isSparse &&
        !file.missingExtensions.empty())
        file.fail(name + " has no data in a buffer, and the file requires unsupported extensions: " +
                      file.missingExtensions,
                  "export it without them");
    const std::size_t count = chosen != nullptr ? chosen->size() : accessor.count;
    file.reserveGeometry(count, elementSize);
    std::vector<unsigned char> elements(count * elementSize);
    for (std::size_t i = 0; first != nullptr && i < count; ++i)
        std::memcpy(&elements[i * elementSize], first + (chosen != nullptr ? (*chosen)[i] : i) * stride,
                    elementSize);
    if (accessor.sparse.isSparse) applySparse(file, accessor, elementSize, chosen, elements, name);
    return elements;
}

}  // namespace

ByteRange viewBytes(GltfFile& file, int bufferView) {
    const tinygltf::BufferView& view = file.at(file.model.bufferViews, bufferView, "buffer view");
    const ByteRange& buffer = file.at(file.buffers, view.buffer, "buffer");
    const tinygltf::Value* const packing = meshoptOf(view.extensions);
    if (packing != nullptr && (canUnpackMeshopt || buffer.data == nullptr)) {
        const auto known = file.unpackedViews.find(bufferView);
        const std::vector<unsigned char>& bytes =
            known != file.unpackedViews.end()
                ? known->second
                : file.unpackedViews.emplace(bufferView, unpackMeshopt(file, bufferView, *packing))
                      .first->second;
        return {bytes.data(), bytes.size()};
    }
    if (view.byteOffset > buffer.size || view.byteLength > buffer.size - view.byteOffset)
        file.fail("buffer view " + std::to_string(bufferView) + " reaches beyond its buffer of " +
                  std::to_string(buffer.size) + " bytes");
    return {buffer.data + view.byteOffset, view.byteLength};
}

std::vector<float> readFloats(GltfFile& file, int index, int width, Components components,
                              const std::string& attribute, const std::vector<std::uint32_t>* chosen) {
    const tinygltf::Accessor& accessor = file.at(file.model.accessors, index, "accessor");
    const std::string name = named(index) + " (" + attribute + ")";
    constexpr int types[] = {TINYGLTF_TYPE_SCALAR, TINYGLTF_TYPE_VEC2, TINYGLTF_TYPE_VEC3,
                             TINYGLTF_TYPE_VEC4};
    if (accessor.type != (width == 16 ? TINYGLTF_TYPE_MAT4 : types[width - 1]))
        file.fail(name + " is not a " +
                  (width == 1    ? "SCALAR"
                   : width == 16 ? "MAT4"
                                 : "VEC" + std::to_string(width)));

    const int type = accessor.componentType;
    const std::size_t componentSize = componentBytes(type);
    const bool isSmall = componentSize == 1 || componentSize == 2;
    const bool allowed = type == TINYGLTF_COMPONENT_TYPE_FLOAT ||
                         (components == Components::floatOrNormalizedUnsigned && isSmall &&
                          isUnsignedInteger(type) && accessor.normalized) ||
                         (components == Components::floatOrNormalized && isSmall && accessor.normalized) ||
                         (components == Components::anySmallInteger && isSmall);
    if (!allowed)
        file.fail(name + " has component type " + std::to_string(type) + ", which is not allowed there");

    const auto scalars = static_cast<std::size_t>(width);
    const std::vector<unsigned char> bytes =
        packedElements(file, index, scalars * componentSize, name, chosen);
    const std::size_t count = chosen != nullptr ? chosen->size() : accessor.count;
    file.reserveGeometry(count, scalars * sizeof(float));
    std::vector<float> values(count * scalars);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = loadFloat(&bytes[i * componentSize], type, accessor.normalized);
    return values;
}

VertexChoice chooseVertices(std::size_t declared, std::vector<std::uint32_t>& indices) {
    VertexChoice vertices{declared, {}};
    if (indices.empty() || indices.size() >= declared) return vertices;
    std::vector<std::uint32_t> used = indices;
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    if (used.size() > declared / 2) return vertices;
    for (std::uint32_t& index : indices)
        index = static_cast<std::uint32_t>(std::lower_bound(used.begin(), used.end(), index) - used.begin());
    vertices.chosen = std::move(used);
    return vertices;
}

std::vector<float> readVertexFloats(GltfFile& file, int accessor, int width, Components components,
                                    const std::string& attribute, const VertexChoice& vertices) {
    const std::size_t count = file.at(file.model.accessors, accessor, "accessor").count;
    if (count != vertices.declared)
        file.fail(attribute + " has " + std::to_string(count) + " elements for " +
                  std::to_string(vertices.declared) + " vertices");
    return readFloats(file, accessor, width, components, attribute,
                      vertices.chosen.empty() ? nullptr : &vertices.chosen);
}

std::vector<std::uint32_t> readIndices(GltfFile& file, int index, std::size_t vertexCount) {
    const tinygltf::Accessor& accessor = file.at(file.model.accessors, index, "accessor");
    const std::string name = named(index) + " (indices)";
    const int type = accessor.componentType;
    if (accessor.type != TINYGLTF_TYPE_SCALAR || !isUnsignedInteger(type))
        file.fail(name + " is not a list of unsigned integers (component type " + std::to_string(type) + ")");

    const std::size_t size = componentBytes(type);
    const std::vector<unsigned char> bytes = packedElements(file, index, size, name);
    file.reserveGeometry(accessor.count, sizeof(std::uint32_t));
    std::vector<std::uint32_t> indices(accessor.count);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        indices[i] = loadUnsigned(&bytes[i * size], size);
        if (indices[i] >= vertexCount)
            file.fail(name + " points at vertex " + std::to_string(indices[i]) + " of " +
                      std::to_string(vertexCount));
    }
    return indices;
}

}  // namespace vct
