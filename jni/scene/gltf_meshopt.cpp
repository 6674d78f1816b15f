// Decompresses EXT_meshopt_compression and its successor KHR_meshopt_compression by the library
// meshoptimizer.
#ifdef VCT_HAS_MESHOPT
#include <meshoptimizer.h>
#endif

#include "scene/gltf_accessors.h"
#include "scene/gltf_extensions.h"
#include "scene/gltf_packings.h"

namespace vct {

const tinygltf::Value* meshoptOf(const tinygltf::ExtensionMap& extensions) {
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
        if (const tinygltf::Value* const found = extensionOf(extensions, name)) return found;
    return nullptr;
}

#ifdef VCT_HAS_MESHOPT

const bool canUnpackMeshopt = true;

namespace {

struct Packed {
    ByteRange bytes;
    std::size_t count = 0, stride = 0;
    std::string mode, filter;
};

std::string wordAt(const tinygltf::Value& object, const char* key) {
    return object.Has(key) && object.Get(key).IsString() ? object.Get(key).Get<std::string>() : "";
}

// Reads the parameters and checks everything that the library only asserts. Throws vct::Error.
Packed checkedPacking(const GltfFile& file, int index, const tinygltf::Value& packing,
                      const std::string& what) {
    const int buffer = indexAt(packing, "buffer"), length = indexAt(packing, "byteLength");
    const int offset = packing.IsObject() && packing.Has("byteOffset") ? indexAt(packing, "byteOffset") : 0;
    const int stride = indexAt(packing, "byteStride"), count = indexAt(packing, "count");
    if (buffer < 0 || length < 0 || offset < 0 || stride < 1 || count < 0)
        file.fail(what + " lacks the position or the number of its elements");
    Packed packed;
    const ByteRange& all = file.at(file.buffers, buffer, "buffer");
    const auto from = static_cast<std::size_t>(offset), size = static_cast<std::size_t>(length);
    if (from > all.size || size > all.size - from)
        file.fail(what + " reaches beyond its buffer of " + std::to_string(all.size) + " bytes");
    packed.bytes = {all.data + from, size};
    packed.count = static_cast<std::size_t>(count);
    packed.stride = static_cast<std::size_t>(stride);
    packed.mode = wordAt(packing, "mode");
    packed.filter = packing.Has("filter") ? wordAt(packing, "filter") : "NONE";

    const bool attributes = packed.mode == "ATTRIBUTES";
    if (!attributes && packed.mode != "TRIANGLES" && packed.mode != "INDICES")
        file.fail(what + " has the unknown mode \"" + oneLine(packed.mode) + "\"");
    const bool strideFits = attributes ? packed.stride % 4 == 0 && packed.stride <= 256
                                       : packed.stride == 2 || packed.stride == 4;
    if (!strideFits || (packed.mode == "TRIANGLES" && packed.count % 3 != 0))
        file.fail(what + " has " + std::to_string(count) + " elements of " + std::to_string(stride) +
                  " bytes, which its mode " + packed.mode + " does not allow");
    const std::string& filter = packed.filter;
    const bool filterFits =
        filter == "NONE" ||
        (attributes && ((filter == "OCTAHEDRAL" && (stride == 4 || stride == 8)) ||
                        (filter == "QUATERNION" && stride == 8) || filter == "EXPONENTIAL"));
    if (!filterFits)
        file.fail(what + " has the filter \"" + oneLine(filter) + "\" for elements of " +
                      std::to_string(stride) + " bytes, which is not supported",
                  "compress it without that filter");
    const std::size_t declared = file.model.bufferViews[static_cast<std::size_t>(index)].byteLength;
    if (packed.count > declared / packed.stride)
        file.fail(what + " has more elements than fit into its buffer view of " + std::to_string(declared) +
                  " bytes");
    return packed;
}

}  // namespace

std::vector<unsigned char> unpackMeshopt(GltfFile& file, int index, const tinygltf::Value& packing) {
    const std::string what = "the meshopt compression of buffer view " + std::to_string(index);
    const Packed packed = checkedPacking(file, index, packing, what);
    file.reserve(packed.count * packed.stride, "buffer view " + std::to_string(index) + ", unpacked,");
    std::vector<unsigned char> bytes(packed.count * packed.stride);
    if (bytes.empty()) return bytes;

    // The type selects the library's C functions, because its header also has templates of these names.
    using Decode = int (*)(void*, std::size_t, std::size_t, const unsigned char*, std::size_t);
    const bool attributes = packed.mode == "ATTRIBUTES";
    Decode decode = meshopt_decodeVertexBuffer;
    if (packed.mode == "TRIANGLES") decode = meshopt_decodeIndexBuffer;
    if (packed.mode == "INDICES") decode = meshopt_decodeIndexSequence;
    if (decode(bytes.data(), packed.count, packed.stride, packed.bytes.data, packed.bytes.size) != 0) {
        // The first byte of a stream of attributes is 0xA0 and the codec's version.
        const bool newer = attributes && packed.bytes.size > 0 && packed.bytes.data[0] > 0xA0 &&
                           packed.bytes.data[0] < 0xB0 && MESHOPTIMIZER_VERSION < 230;
        if (newer)
            file.fail(what + " uses a version of its codec that this build's meshoptimizer does not support",
                      "export it with EXT_meshopt_compression, or build with meshoptimizer 0.23 or newer");
        file.fail(what + " cannot be undone: its data are damaged");
    }
    if (packed.filter == "OCTAHEDRAL") meshopt_decodeFilterOct(bytes.data(), packed.count, packed.stride);
    if (packed.filter == "QUATERNION") meshopt_decodeFilterQuat(bytes.data(), packed.count, packed.stride);
    if (packed.filter == "EXPONENTIAL") meshopt_decodeFilterExp(bytes.data(), packed.count, packed.stride);
    return bytes;
}

#else

const bool canUnpackMeshopt = false;

std::vector<unsigned char> unpackMeshopt(GltfFile& file, int index, const tinygltf::Value&) {
    file.fail("buffer view " + std::to_string(index) +
                  " is compressed by meshoptimizer (EXT_meshopt_compression), which this build cannot read",
              "install libmeshoptimizer-dev and build with the CMake option VCT_MESHOPT=ON, or export the "
              "scene without that compression");
}

#endif

}  // namespace vct
