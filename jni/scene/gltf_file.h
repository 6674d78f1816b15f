// A glTF file taken apart: its structure as a tinygltf model, its bytes checked, nothing interpreted yet.
//
// tinygltf parses the structure only. It trusts the byte ranges it is given and decodes every image of the
// file, so buffers and images are kept from it and read here.
#pragma once

#include <tiny_gltf.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "scene/gltf.h"

namespace vct {

// What fail() advises where nothing better is known.
inline constexpr const char* reexportRemedy = "export it again, or check it with the Khronos glTF validator";

struct GltfFile {
    std::string path;
    ReadFile readFile;
    tinygltf::Model model;  // buffers hold their bytes; images hold name, uri and bufferView, not pixels
    // A list of objects. In place of tinygltf's, which drops what it cannot read and does not say of which
    // animation it was.
    nlohmann::json animations;
    std::vector<std::string> warnings;
    std::size_t geometryBytes = 0;
    std::size_t textureBytes = 0;

    // Throws vct::Error: "cannot load <path>: <cause>; <remedy>".
    [[noreturn]] void fail(const std::string& cause, const std::string& remedy = reexportRemedy) const;

    // Adds a warning that is not there yet.
    void warn(const std::string& what);

    // Counts what is about to be allocated; throws where the file asks for more than the program allows.
    void reserveGeometry(std::size_t count, std::size_t bytesEach);
    void reserveTexture(std::size_t bytes);

    bool uses(const std::string& extension) const;

    // Element `index` of one of the model's arrays; throws where it is out of range. `kind` as in "mesh".
    template <class T>
    const T& at(const std::vector<T>& array, int index, const std::string& kind) const {
        if (index < 0 || static_cast<std::size_t>(index) >= array.size())
            fail("it refers to " + kind + " " + std::to_string(index) + " of " +
                 std::to_string(array.size()));
        return array[index];
    }
};

GltfFile openGltf(const std::string& path, const ReadFile& readFile);

// The bytes behind a URI of the file: a data URI, or a file relative to it. `what` names it in an error.
std::vector<unsigned char> readUri(const GltfFile& file, const std::string& uri, const std::string& what);

// The text at `key` of an object, "" where there is none.
std::string textAt(const nlohmann::json& object, const char* key);

// Takes the list `key` out of an object; an empty one where there is none. Throws where it is not a list of
// objects; `whose` begins the message, as in "its".
nlohmann::json takeObjects(const GltfFile& file, nlohmann::json& object, const char* key,
                           const std::string& whose);

// How messages name an element of one of the model's arrays: "3 (wall)", "3" where it has no name.
std::string indexAndName(std::size_t index, const std::string& name);

// Text of the file or of a library as a part of a sentence: one line, not too long.
std::string oneLine(std::string text);

}  // namespace vct
