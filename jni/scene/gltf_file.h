// Opens a glTF file: its structure as a tinygltf model, and its bytes, checked but not yet interpreted.
//
// tinygltf parses only the structure. It does not check byte ranges and decodes every image of the file, so
// buffers and images are hidden from it and read here.
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

// The advice of fail() if there is no better one.
inline constexpr const char* reexportRemedy = "export it again, or check it with the Khronos glTF validator";

struct ByteRange {
    const unsigned char* data = nullptr;
    std::size_t size = 0;
};

struct GltfFile {
    std::string path;
    ReadFile readFile;
    bool allowOutside = false;  // see GltfOptions
    tinygltf::Model model;      // without buffers; images hold name, uri and bufferView, not pixels
    std::vector<ByteRange> buffers;
    // Content of the files and data URIs that the buffers refer to. Each exists once, however many buffers
    // refer to it.
    std::map<std::string, std::vector<unsigned char>> bytesOf;
    // Decompressed buffer views by index, each filled when it is first needed.
    std::map<int, std::vector<unsigned char>> unpackedViews;
    // Decompressed elements, without gaps, of accessors of the Draco-compressed primitive that is being
    // loaded.
    std::map<int, std::vector<unsigned char>> unpackedAccessors;
    // A list of objects. tinygltf's own is not used, because it leaves out invalid parts without telling in
    // which animation.
    nlohmann::json animations;
    std::vector<std::string> warnings;  // the first warnings, each once
    std::set<std::string> knownWarnings;
    std::string missingExtensions;  // required extensions that are not supported; "" if there are none
    bool isQuantized = false;       // the file uses KHR_mesh_quantization
    // Memory limit of buffers, images and meshes together: half of the available memory, because a driver
    // that keeps its data in main memory has a copy of most of it.
    std::size_t limitBytes = std::numeric_limits<std::size_t>::max();
    std::size_t usedBytes = 0;
    std::size_t geometryBytes = 0;
    std::size_t textureBytes = 0;

    // Throws vct::Error with the message "cannot load PATH: CAUSE; REMEDY".
    [[noreturn]] void fail(const std::string& cause, const std::string& remedy = reexportRemedy) const;

    // Adds a warning, once. After the first 20 it only counts them.
    void warn(const std::string& what);
    // Returns the warnings, and as the last one the number of those left out.
    std::vector<std::string> takeWarnings();

    // Count memory that is about to be allocated. They throw vct::Error if the file asks for more than the
    // program's limits or the machine's memory allow. `what` names the part that asks for it: "image 3
    // (wall.png), 4096 x 4096 pixels,".
    void reserve(std::size_t bytes, const std::string& what);
    void reserveGeometry(std::size_t count, std::size_t bytesEach);
    void reserveTexture(std::size_t bytes, const std::string& what);

    // Returns element `index` of one of the model's arrays. Throws vct::Error if it is out of range; `kind`
    // names the element ("mesh").
    template <class T>
    const T& at(const std::vector<T>& array, int index, const std::string& kind) const {
        if (index < 0 || static_cast<std::size_t>(index) >= array.size())
            fail("it refers to " + kind + " " + std::to_string(index) + " of " +
                 std::to_string(array.size()));
        return array[index];
    }
};

// `bytes`: content of the file at `path`. It must outlive the result.
GltfFile openGltf(const std::string& path, const std::vector<unsigned char>& bytes, const ReadFile& readFile,
                  bool allowOutside);

// Resolves a URI of the file. The result is a path with its links resolved; a data URI stays as it is. Throws
// vct::Error if the path is outside of the glTF file's folder and that is not allowed. `what` names the URI
// in an error.
std::string resolvedUri(const GltfFile& file, const std::string& uri, const std::string& what);

// Returns a key that is equal for the same bytes: the path, or `what` for a data URI, which may be long.
std::string identityOf(const std::string& resolved, const std::string& what);

// Reads the bytes of a URI that resolvedUri() returned, and counts them by reserve().
std::vector<unsigned char> readResolved(GltfFile& file, const std::string& resolved, const std::string& what);

// Returns the text at `key` of an object, or "" if there is none.
std::string textAt(const nlohmann::json& object, const char* key);

// Removes the list `key` from an object and returns it; returns an empty list if there is none. Throws
// vct::Error if it is not a list of objects; `whose` begins the message ("its").
nlohmann::json takeObjects(const GltfFile& file, nlohmann::json& object, const char* key,
                           const std::string& whose);

// Name of an element of one of the model's arrays in messages: "3 (wall)", or "3" if it has no name.
std::string indexAndName(std::size_t index, const std::string& name);

}  // namespace vct
