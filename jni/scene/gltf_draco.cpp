// Decompresses KHR_draco_mesh_compression by the library draco. tinygltf's own support is not used, because
// it does not check the stream and the ranges of the file.
#ifdef VCT_HAS_DRACO
#include <draco/compression/decode.h>
#include <draco/compression/point_cloud/point_cloud_decoder.h>
#include <draco/core/varint_decoding.h>
#include <draco/metadata/metadata_decoder.h>
#endif

#include <algorithm>
#include <cstring>
#include <memory>

#include "core/memory.h"
#include "core/number_text.h"
#include "scene/gltf_accessors.h"
#include "scene/gltf_extensions.h"
#include "scene/gltf_packings.h"

namespace vct {

namespace {

constexpr const char* extensionName = "KHR_draco_mesh_compression";

#ifdef VCT_HAS_DRACO

// One Draco stream. Its errors name the mesh.
class DracoStream {
  public:
    DracoStream(GltfFile& file, const tinygltf::Value& extension, const std::string& mesh)
        : file_(file), context_(mesh + ": its Draco stream") {
        const int view = indexAt(extension, "bufferView");
        bytes_ = viewBytes(file, view);
        context_ += " (buffer view " + std::to_string(view) + ")";
        checkMemory();
        draco::DecoderBuffer buffer;
        buffer.Init(chars(), bytes_.size);
        auto decoded = draco::Decoder().DecodeMeshFromBuffer(&buffer);
        if (!decoded.ok()) fail("cannot be unpacked (" + asClause(decoded.status().error_msg_string()) + ")");
        mesh_ = std::move(decoded).value();
    }

    std::size_t points() const { return mesh_->num_points(); }

    // Returns the attribute `id` of the stream as the elements of an accessor.
    std::vector<unsigned char> attribute(int id, const tinygltf::Accessor& accessor,
                                         const std::string& name) {
        const draco::PointAttribute* const source =
            id < 0 ? nullptr : mesh_->GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
        if (source == nullptr) fail("has no attribute " + std::to_string(id) + " (" + name + ")");
        const int width = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
        if (source->num_components() != width)
            fail("has " + std::to_string(source->num_components()) + " numbers per element for " + name +
                 ", whose accessor has " + std::to_string(width));
        const std::size_t stored = source->buffer()->data_size();
        const auto stride = static_cast<std::size_t>(source->byte_stride());
        if (source->indices_map_size() != 0 && source->indices_map_size() < points())
            fail("does not assign a " + name + " to each of its vertices");
        for (std::size_t i = 0; i < points(); ++i) {
            const std::size_t at = source->mapped_index(point(i)).value();
            if (at >= source->size() || (at + 1) * stride > stored)
                fail("has vertices whose " + name + " is missing");
        }
        switch (accessor.componentType) {
            case TINYGLTF_COMPONENT_TYPE_BYTE:
                return values<std::int8_t>(*source, width, name);
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
                return values<std::uint8_t>(*source, width, name);
            case TINYGLTF_COMPONENT_TYPE_SHORT:
                return values<std::int16_t>(*source, width, name);
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
                return values<std::uint16_t>(*source, width, name);
            case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
                return values<std::uint32_t>(*source, width, name);
            default:
                return values<float>(*source, width, name);
        }
    }

    std::vector<std::uint32_t> indices() {
        file_.reserveGeometry(mesh_->num_faces(), 3 * sizeof(std::uint32_t));
        std::vector<std::uint32_t> result;
        result.reserve(std::size_t{3} * mesh_->num_faces());
        for (std::uint32_t face = 0; face < mesh_->num_faces(); ++face)
            for (const draco::PointIndex& corner : mesh_->face(draco::FaceIndex(face)))
                result.push_back(corner.value());
        return result;
    }

  private:
    [[noreturn]] void fail(const std::string& cause) const { file_.fail(context_ + " " + cause); }

    const char* chars() const { return reinterpret_cast<const char*>(bytes_.data); }

    static draco::PointIndex point(std::size_t i) { return draco::PointIndex(static_cast<std::uint32_t>(i)); }

    // Checks the counts at the beginning of the stream, because the library allocates memory for them before
    // it finds that they are wrong.
    void checkMemory() const {
        draco::DecoderBuffer buffer;
        buffer.Init(chars(), bytes_.size);
        draco::DracoHeader header;
        if (!draco::PointCloudDecoder::DecodeHeader(&buffer, &header).ok()) fail("has a damaged header");
        if (header.encoder_type != draco::TRIANGULAR_MESH) fail("holds points instead of triangles");
        const int version = DRACO_BITSTREAM_VERSION(header.version_major, header.version_minor);
        buffer.set_bitstream_version(static_cast<std::uint16_t>(version));
        if ((header.flags & METADATA_FLAG_MASK) != 0) {
            draco::GeometryMetadata metadata;
            if (!draco::MetadataDecoder().DecodeGeometryMetadata(&buffer, &metadata))
                fail("has damaged metadata");
        }
        const bool edgebreaker = header.encoder_method == draco::MESH_EDGEBREAKER_ENCODING;
        const auto count = [&](int varintSince) {
            std::uint32_t value = 0;
            const bool read =
                version < varintSince ? buffer.Decode(&value) : draco::DecodeVarint(&value, &buffer);
            if (!read) fail("ends inside its header");
            return std::size_t{value};
        };
        std::size_t elements = 0;
        if (edgebreaker) {
            buffer.Advance(1);  // skips the kind of the traversal
            if (version < DRACO_BITSTREAM_VERSION(2, 2)) count(DRACO_BITSTREAM_VERSION(2, 0));
            elements = count(DRACO_BITSTREAM_VERSION(2, 0));
            elements += count(DRACO_BITSTREAM_VERSION(2, 0));
        } else {
            elements = count(DRACO_BITSTREAM_VERSION(2, 2));
            elements += count(DRACO_BITSTREAM_VERSION(2, 2));
        }
        // Memory per vertex or triangle, including the tables of neighbours; measured and rounded up.
        constexpr std::size_t bytesEach = 256;
        const std::size_t available = std::min(availableMemory(), file_.limitBytes - file_.usedBytes);
        if (elements > available / bytesEach)
            fail("claims to have " + std::to_string(elements) + " vertices and triangles, which take " +
                 megabytesText(elements * bytesEach) + " to unpack, and only " + megabytesText(available) +
                 " are available");
    }

    template <class T>
    std::vector<unsigned char> values(const draco::PointAttribute& source, int width,
                                      const std::string& name) {
        const std::size_t size = static_cast<std::size_t>(width) * sizeof(T);
        file_.reserveGeometry(points(), size);
        std::vector<unsigned char> result(points() * size);
        const bool same = source.data_type() == typeOf(T{});
        T element[4] = {};
        for (std::size_t i = 0; i < points(); ++i) {
            const draco::AttributeValueIndex at = source.mapped_index(point(i));
            if (same)
                std::memcpy(&result[i * size], source.GetAddress(at), size);
            else if (source.ConvertValue<T>(at, static_cast<std::int8_t>(width), element))
                std::memcpy(&result[i * size], element, size);
            else
                fail("has a " + name + " that its accessor's component type cannot hold");
        }
        return result;
    }

    static draco::DataType typeOf(std::int8_t) { return draco::DT_INT8; }
    static draco::DataType typeOf(std::uint8_t) { return draco::DT_UINT8; }
    static draco::DataType typeOf(std::int16_t) { return draco::DT_INT16; }
    static draco::DataType typeOf(std::uint16_t) { return draco::DT_UINT16; }
    static draco::DataType typeOf(std::uint32_t) { return draco::DT_UINT32; }
    static draco::DataType typeOf(float) { return draco::DT_FLOAT32; }

    GltfFile& file_;
    std::string context_;
    ByteRange bytes_;
    std::unique_ptr<draco::Mesh> mesh_;
};

#else

// True if the file also holds the primitive uncompressed: every accessor has a buffer view.
bool isPlainToo(const GltfFile& file, const tinygltf::Primitive& primitive) {
    const auto hasView = [&](int accessor) {
        return file.at(file.model.accessors, accessor, "accessor").bufferView >= 0;
    };
    for (const auto& [name, accessor] : primitive.attributes)
        if (!hasView(accessor)) return false;
    return primitive.indices == -1 || hasView(primitive.indices);
}

#endif

}  // namespace

#ifdef VCT_HAS_DRACO

std::optional<tinygltf::Primitive> unpackDraco(GltfFile& file, const tinygltf::Primitive& primitive,
                                               const std::string& mesh) {
    file.unpackedAccessors.clear();
    const tinygltf::Value* const extension = extensionOf(primitive.extensions, extensionName);
    if (extension == nullptr) return std::nullopt;
    if (!extension->IsObject() || !extension->Has("attributes") || !extension->Get("attributes").IsObject())
        file.fail(mesh + ": its Draco compression names no attributes");
    const tinygltf::Value& attributes = extension->Get("attributes");
    DracoStream stream(file, *extension, mesh);

    // If the accessors' counts differ from the stream's, the stream's are right. Its faces are triangles,
    // whatever the mode of the primitive.
    tinygltf::Primitive unpacked = primitive;
    unpacked.mode = TINYGLTF_MODE_TRIANGLES;
    const auto put = [&](int index, std::size_t count, std::vector<unsigned char> bytes) {
        tinygltf::Accessor& accessor = file.model.accessors[static_cast<std::size_t>(index)];
        if (accessor.count != count)
            file.warn(
                "accessors have other counts than their Draco streams; the counts of the streams are used");
        accessor.count = count;
        file.unpackedAccessors[index] = std::move(bytes);
    };
    for (const auto& [name, index] : primitive.attributes) {
        const tinygltf::Accessor& accessor = file.at(file.model.accessors, index, "accessor");
        if (attributes.Has(name))
            put(index, stream.points(), stream.attribute(indexAt(attributes, name.c_str()), accessor, name));
        // glTF defines all other attributes without a buffer view as zeros.
        else if (name == "POSITION" && accessor.bufferView < 0 && !accessor.sparse.isSparse)
            file.fail(mesh + ": its POSITION is neither in its Draco stream nor in a buffer view");
    }
    if (unpacked.indices == -1) {
        unpacked.indices = static_cast<int>(file.model.accessors.size());
        file.model.accessors.emplace_back().type = TINYGLTF_TYPE_SCALAR;
        file.model.accessors.back().count = 0;
    }
    file.at(file.model.accessors, unpacked.indices, "accessor");
    const std::vector<std::uint32_t> indices = stream.indices();
    const auto* const bytes = reinterpret_cast<const unsigned char*>(indices.data());
    file.model.accessors[static_cast<std::size_t>(unpacked.indices)].componentType =
        TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    put(unpacked.indices, indices.size(), {bytes, bytes + indices.size() * sizeof(std::uint32_t)});
    return unpacked;
}

#else

std::optional<tinygltf::Primitive> unpackDraco(GltfFile& file, const tinygltf::Primitive& primitive,
                                               const std::string& mesh) {
    const tinygltf::Value* const extension = extensionOf(primitive.extensions, extensionName);
    if (extension == nullptr) return std::nullopt;
    if (isPlainToo(file, primitive)) return primitive;
    file.fail(
        mesh + " is compressed by Draco (" + extensionName + "), which this build cannot read",
        "install libdraco-dev and build with the CMake option VCT_DRACO=ON, or export the scene without "
        "that compression");
}

#endif

}  // namespace vct
