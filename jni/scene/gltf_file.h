// A glTF file taken apart: its structure as a tinygltf model, its bytes checked, nothing interpreted yet.
//
// tinygltf parses the structure only. It trusts the byte ranges it is given and decodes every image of the
// file, so buffers and images are kept from it and read here.
#pragma once

#include <tiny_gltf.h>

#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "core/one_line.h"
#include "scene/gltf.h"

namespace vct {

// What fail() advises where nothing better is known.
inline constexpr const char* reexportRemedy = "export it again, or check it with the Khronos glTF validator";

struct ByteRange {
    const unsigned char* data = nullptr;
    std::size_t size = 0;
};

struct GltfFile {
    std::string path;
    ReadFile readFile;
    bool allowOutside = false;  // as GltfOptions has it
    tinygltf::Model model;      // without buffers; images hold name, uri and bufferView, not pixels
    std::vector<ByteRange> buffers;
    // What the buffers are parts of: each file and data URI once, however many buffers name it.
    std::map<std::string, std::vector<unsigned char>> bytesOf;
    // Buffer views that were packed, by index, each from when something first asks for it.
    std::map<int, std::vector<unsigned char>> unpackedViews;
    // Elements of accessors, without gaps, that a Draco stream holds: of the primitive that is being loaded.
    std::map<int, std::vector<unsigned char>> unpackedAccessors;
    // A list of objects. In place of tinygltf's, which drops what it cannot read and does not say of which
    // animation it was.
    nlohmann::json animations;
    std::vector<std::string> warnings;  // the first of them, each once
    std::set<std::string> knownWarnings;
    std::string
        missingExtensions;     // those that it requires and that are not supported; "" where there are none
    bool isQuantized = false;  // by KHR_mesh_quantization
    // Of buffers, images and meshes together: half of the memory that was available, as a driver in main
    // memory has a copy of most of it.
    std::size_t limitBytes = std::numeric_limits<std::size_t>::max();
    std::size_t usedBytes = 0;
    std::size_t geometryBytes = 0;
    std::size_t textureBytes = 0;

    // Throws vct::Error: "cannot load <path>: <cause>; <remedy>".
    [[noreturn]] void fail(const std::string& cause, const std::string& remedy = reexportRemedy) const;

    // Adds a warning that is not there yet, up to a number that can be read.
    void warn(const std::string& what);
    // The warnings, and how many there are no room for.
    std::vector<std::string> takeWarnings();

    // Count what is about to be allocated; throw where the file asks for more than the program or the
    // machine's memory allows. `what` asks for it: "image 3 (wall.png), 4096 x 4096 pixels,".
    void reserve(std::size_t bytes, const std::string& what);
    void reserveGeometry(std::size_t count, std::size_t bytesEach);
    void reserveTexture(std::size_t bytes, const std::string& what);

    // Element `index` of one of the model's arrays; throws where it is out of range. `kind` as in "mesh".
    template <class T>
    const T& at(const std::vector<T>& array, int index, const std::string& kind) const {
        if (index < 0 || static_cast<std::size_t>(index) >= array.size())
            fail("it refers to " + kind + " " + std::to_string(index) + " of " +
                 std::to_string(array.size()));
        return array[index];
    }
};

// `bytes`: of the file at `path`, which outlive the result.
GltfFile openGltf(const std::string& path, const std::vector<unsigned char>& bytes, const ReadFile& readFile,
                  bool allowOutside);

// Where the bytes behind a URI are: a data URI stays as it is; of a file, relative to the glTF file, the path
// with its links resolved. Throws where it is outside of the glTF file's folder and
// that is not allowed. `what` names it in an error.
std::string resolvedUri(const GltfFile& file, const std::string& uri, const std::string& what);

// Equal for the same bytes; a data URI is known by `what` is in it, as it may be long.
std::string identityOf(const std::string& resolved, const std::string& what);

// The bytes at a place that resolvedUri() gave, counted by reserve() before they are read.
std::vector<unsigned char> readResolved(GltfFile& file, const std::string& resolved, const std::string& what);

// The text at `key` of an object, "" where there is none.
std::string textAt(const nlohmann::json& object, const char* key);

// Takes the list `key` out of an object; an empty one where there is none. Throws where it is not a list of
// objects; `whose` begins the message, as in "its".
nlohmann::json takeObjects(const GltfFile& file, nlohmann::json& object, const char* key,
                           const std::string& whose);

// How messages name an element of one of the model's arrays: "3 (wall)", "3" where it has no name.
std::string indexAndName(std::size_t index, const std::string& name);

}  // namespace vct
