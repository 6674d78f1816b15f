#include "scene/gltf_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "core/error.h"
#include "core/memory.h"
#include "core/number_text.h"
#include "scene/gltf_extensions.h"
#include "scene/gltf_foreign.h"
#include "scene/gltf_packings.h"

namespace vct {
namespace {

using nlohmann::json;
using Bytes = std::vector<unsigned char>;

// tinygltf and the JSON writer recurse once per level. glTF itself needs about ten levels.
constexpr int maxJsonDepth = 64;

// Bytes of memory that reading the JSON takes, per comma and bracket of its text. Measured: 50 for empty
// objects, 200 for numbers, 280 for small objects, 450 for empty nodes.
constexpr std::size_t bytesPerJsonMark = 200;

// Limits of several times the largest public scenes, so that a small malicious file cannot ask for all of the
// memory.
constexpr std::size_t maxGeometryBytes = std::size_t{2} << 30;
constexpr std::size_t maxTextureBytes = std::size_t{4} << 30;

struct Chunks {
    const unsigned char* json = nullptr;
    std::size_t jsonSize = 0;
    const unsigned char* binary = nullptr;
    std::size_t binarySize = 0;
};

std::uint32_t littleEndian32(const unsigned char* bytes) {
    return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8 |
           static_cast<std::uint32_t>(bytes[2]) << 16 | static_cast<std::uint32_t>(bytes[3]) << 24;
}

constexpr std::uint32_t jsonChunk = 0x4E4F534A;
constexpr std::uint32_t binaryChunk = 0x004E4942;

// Returns the end of a chunk whose length is not a multiple of four, against the specification. Some
// exporters write the padding and do not count it, others write none.
std::size_t unpaddedEnd(GltfFile& file, const Bytes& bytes, std::size_t end) {
    file.warn(
        "a chunk has a length that is not a multiple of 4 bytes, as glTF requires; it is read as it is");
    const bool chunkFollows = end + 8 <= bytes.size() && littleEndian32(&bytes[end + 4]) == binaryChunk;
    return chunkFollows ? end : (end + 3) / 4 * 4;
}

// glTF 2.0 section 4.4: header of 12 bytes, then chunks of length, type and content.
Chunks splitGlb(GltfFile& file, const Bytes& bytes) {
    const char* const copyRemedy = "copy or export it again";
    if (bytes.size() < 12) file.fail("the file ends inside its header", copyRemedy);
    const std::uint32_t version = littleEndian32(&bytes[4]);
    if (version != 2)
        file.fail(
            "it is binary glTF version " + std::to_string(version) + ", and only version 2 is supported",
            "export it as glTF 2.0");
    const std::size_t length = littleEndian32(&bytes[8]);
    if (length > bytes.size())
        file.fail("the file is cut short: it holds " + std::to_string(bytes.size()) + " of " +
                      std::to_string(length) + " bytes",
                  copyRemedy);

    Chunks chunks;
    std::size_t offset = 12;
    while (offset + 8 <= length) {
        const std::size_t size = littleEndian32(&bytes[offset]);
        const std::uint32_t type = littleEndian32(&bytes[offset + 4]);
        offset += 8;
        if (size > length - offset) file.fail("a chunk reaches beyond the end of the file", copyRemedy);
        const unsigned char* content = bytes.data() + offset;
        if (type == jsonChunk && chunks.json == nullptr) {
            chunks.json = content;
            chunks.jsonSize = size;
        } else if (type == binaryChunk && chunks.binary == nullptr) {
            chunks.binary = content;
            chunks.binarySize = size;
        }
        offset += size;
        if (size % 4 != 0 && offset < length) offset = unpaddedEnd(file, bytes, offset);
    }
    if (chunks.json == nullptr) file.fail("it has no JSON chunk", copyRemedy);
    return chunks;
}

// Checks the nesting and counts commas and opening brackets, in one pass over the text. The parser's own
// callback knows the depth too, but takes quadratic time for lists.
std::size_t checkedMarkCount(const GltfFile& file, const Chunks& chunks) {
    int depth = 0;
    std::size_t marks = 0;
    bool inString = false;
    for (std::size_t i = 0; i < chunks.jsonSize; ++i) {
        const unsigned char c = chunks.json[i];
        if (inString) {
            if (c == '\\') ++i;
            inString = c != '"';
        } else if (c == '"') {
            inString = true;
        } else if (c == '[' || c == '{') {
            if (++depth > maxJsonDepth)
                file.fail("its JSON is nested more than " + std::to_string(maxJsonDepth) + " levels deep");
        } else if (c == ']' || c == '}') {
            --depth;
        }
        marks += !inString && (c == ',' || c == '[' || c == '{');
    }
    return marks;
}

// True if the first byte after a byte order mark and white space can begin an object or a list.
bool beginsAsJson(const Bytes& bytes) {
    const Bytes mark{0xEF, 0xBB, 0xBF};
    const bool isMarked = bytes.size() >= 3 && std::equal(mark.begin(), mark.end(), bytes.begin());
    const auto first = std::find_if(bytes.begin() + (isMarked ? 3 : 0), bytes.end(), [](unsigned char c) {
        return c != ' ' && c != '\t' && c != '\n' && c != '\r';
    });
    return first != bytes.end() && (*first == '{' || *first == '[');
}

json parseJson(const GltfFile& file, const Chunks& chunks) {
    try {
        json document = json::parse(chunks.json, chunks.json + chunks.jsonSize);
        if (!document.is_object()) file.fail("its JSON is not an object");
        return document;
    } catch (const json::exception& error) {
        // The message begins with the number of the exception in brackets.
        const std::string text = error.what();
        const std::size_t number = text.find("] ");
        file.fail("its JSON is damaged (" +
                  asClause(number == std::string::npos ? text : text.substr(number + 2)) + ")");
    }
}

// Converts whole numbers to integers. By the specification 60.0 is an integer (section 3.1), but not for
// tinygltf. Numbers beyond 32 bits stay, because tinygltf's integers in extensions have 32 bits.
void integersAsSuch(json& value) {
    if (value.is_number_float()) {
        const double number = value.get<double>();
        if (std::abs(number) > std::numeric_limits<std::int32_t>::max() || number != std::floor(number))
            return;
        if (number < 0.0)
            value = static_cast<std::int64_t>(number);
        else
            value = static_cast<std::uint64_t>(number);
    } else if (value.is_structured()) {
        for (json& element : value)
            integersAsSuch(element);
    }
}

void checkAsset(const GltfFile& file, const json& document) {
    const auto asset = document.find("asset");
    const std::string version = asset == document.end() ? std::string() : textAt(*asset, "version");
    if (version.empty()) file.fail("its JSON has no asset.version, so it is not glTF 2.0");
    const std::string minVersion = textAt(*asset, "minVersion");
    if (version.compare(0, 2, "2.") != 0 || (!minVersion.empty() && minVersion != "2.0"))
        file.fail("it needs glTF " + oneLine(minVersion.empty() ? version : minVersion) +
                      ", and only 2.0 is supported",
                  "export it as glTF 2.0");
}

// Refuses negative offsets before tinygltf sees them, because version 2.8 reads them as missing.
void checkSparseOffsets(const GltfFile& file, const json& document) {
    const auto accessors = document.find("accessors");
    if (accessors == document.end() || !accessors->is_array()) return;
    for (std::size_t i = 0; i < accessors->size(); ++i)
        for (const char* part : {"/sparse/indices/byteOffset", "/sparse/values/byteOffset"}) {
            const json::json_pointer place(part);
            const json& accessor = (*accessors)[i];
            if (!accessor.is_object() || !accessor.contains(place)) continue;
            const json& offset = accessor.at(place);
            if (offset.is_number() && offset.get<double>() < 0.0)
                file.fail("the sparse part of accessor " + std::to_string(i) + " has a negative offset");
        }
}

// Allows skins without inverse bind matrices, which tinygltf refuses. By the specification (section 5.28) the
// matrices are then the identity. The index -1 means none.
void allowMissingInverseBindMatrices(json& document) {
    const auto skins = document.find("skins");
    if (skins == document.end() || !skins->is_array()) return;
    for (json& skin : *skins)
        if (skin.is_object()) skin.emplace("inverseBindMatrices", -1);
}

// Gives accessors without a buffer view a view for the time of parsing, because tinygltf refuses indices
// without one. Returns the indices of these accessors. By the specification (section 3.6.2.3) their elements
// are zeros, or come from a compressed stream.
std::vector<std::size_t> lendViews(json& document) {
    std::vector<std::size_t> borrowers;
    const auto accessors = document.find("accessors");
    if (accessors == document.end() || !accessors->is_array()) return borrowers;
    json& views = document["bufferViews"];
    if (views.is_null()) views = json::array();
    if (!views.is_array()) return borrowers;
    for (std::size_t i = 0; i < accessors->size(); ++i) {
        json& accessor = (*accessors)[i];
        if (!accessor.is_object() || !accessor.emplace("bufferView", views.size()).second) continue;
        borrowers.push_back(i);
    }
    if (!borrowers.empty()) views.push_back({{"buffer", 0}, {"byteLength", 1}});
    return borrowers;
}

void takeViewsBack(tinygltf::Model& model, const std::vector<std::size_t>& borrowers) {
    if (borrowers.empty()) return;
    for (const std::size_t accessor : borrowers)
        model.accessors.at(accessor).bufferView = -1;
    model.bufferViews.pop_back();
}

// Returns the name of the element at which tinygltf stopped, such as "skins[0]: ", because its own message
// names the property at most. Returns "" if it read all of them.
std::string refusedElement(const tinygltf::Model& model, const json& document) {
    // The order is tinygltf's.
    const std::pair<const char*, std::size_t> lists[] = {
        {"bufferViews", model.bufferViews.size()}, {"accessors", model.accessors.size()},
        {"meshes", model.meshes.size()},           {"nodes", model.nodes.size()},
        {"scenes", model.scenes.size()},           {"materials", model.materials.size()},
        {"textures", model.textures.size()},       {"skins", model.skins.size()},
        {"samplers", model.samplers.size()},       {"cameras", model.cameras.size()}};
    for (const auto& [name, read] : lists) {
        const auto list = document.find(name);
        if (list == document.end() || !list->is_array() || read == list->size()) continue;
        // tinygltf checks the indices of meshes before the first node, and names the place itself.
        if (name == std::string("nodes")) return "";
        return std::string(name) + "[" + std::to_string(read) + "]: ";
    }
    return "";
}

// Lets tinygltf parse the document, without a copy of it in memory.
void parseStructure(GltfFile& file, json document) {
    const std::vector<std::size_t> borrowers = lendViews(document);
    const std::string text = document.dump();
    document.clear();
    tinygltf::TinyGLTF parser;
    std::string errors, ignored;
    const bool parsed = parser.LoadASCIIFromString(&file.model, &errors, &ignored, text.c_str(),
                                                   static_cast<unsigned>(text.size()), "");
    // tinygltf leaves out an object with a missing property and continues. An incomplete scene would be worse
    // than an error.
    if (!parsed || !errors.empty())
        file.fail("its structure is not valid (" + refusedElement(file.model, json::parse(text)) +
                  (errors.empty() ? "a property is missing or has a wrong type" : asClause(errors)) + ")");
    takeViewsBack(file.model, borrowers);
}

// True if a buffer exists only for programs that cannot read meshoptimizer's streams.
bool isFallback(const json& source) {
    for (const char* extension : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
        const json::json_pointer place(std::string("/extensions/") + extension + "/fallback");
        if (source.contains(place) && source.at(place) == true) return true;
    }
    return false;
}

// True if a buffer's own bytes are not needed, because all of its views are decompressed from another buffer.
bool isUnread(const GltfFile& file, std::size_t buffer) {
    const std::vector<tinygltf::BufferView>& views = file.model.bufferViews;
    return canUnpackMeshopt && std::all_of(views.begin(), views.end(), [&](const tinygltf::BufferView& view) {
               return view.buffer != static_cast<int>(buffer) || meshoptOf(view.extensions) != nullptr;
           });
}

void readBuffers(GltfFile& file, const json& buffers, const Chunks& chunks) {
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        const json& source = buffers[i];
        const std::string what = "buffer " + std::to_string(i);
        const auto length = source.find("byteLength");
        if (length == source.end() || !length->is_number_unsigned()) file.fail(what + " has no byteLength");
        const auto byteLength = length->get<std::uint64_t>();

        ByteRange available{chunks.binary, chunks.binarySize};
        const std::string uri = textAt(source, "uri");
        const bool fallback = isFallback(source);
        const bool isMissing = uri.empty() && (i != 0 || chunks.binary == nullptr || fallback);
        // Some files do not mark their fallback buffers.
        if (fallback ? isMissing || isUnread(file, i) : isMissing && isUnread(file, i)) {
            file.buffers.push_back({});
            continue;
        }
        if (!uri.empty()) {
            const std::string resolved = resolvedUri(file, uri, what);
            const auto [known, isNew] = file.bytesOf.try_emplace(identityOf(resolved, what));
            if (isNew) known->second = readResolved(file, resolved, what);
            available = {known->second.data(), known->second.size()};
        } else if (isMissing) {
            file.fail(what + " has neither a uri nor a binary chunk");
        }
        if (byteLength > available.size)
            file.fail(what + " is cut short: it holds " + std::to_string(available.size) + " of " +
                      std::to_string(byteLength) + " bytes");
        file.buffers.push_back({available.data, static_cast<std::size_t>(byteLength)});
    }
}

void readImageSources(GltfFile& file, const json& images) {
    for (const json& source : images) {
        tinygltf::Image image;
        image.name = textAt(source, "name");
        image.uri = textAt(source, "uri");
        const auto view = source.find("bufferView");
        if (view != source.end() && view->is_number_unsigned())
            image.bufferView =
                static_cast<int>(std::min<std::uint64_t>(view->get<std::uint64_t>(), INT32_MAX));
        file.model.images.push_back(std::move(image));
    }
}

}  // namespace

void GltfFile::fail(const std::string& cause, const std::string& remedy) const {
    throw Error("cannot load " + oneLine(path) + ": " + cause + "; " + remedy);
}

void GltfFile::warn(const std::string& what) {
    constexpr std::size_t most = 20;
    if (knownWarnings.insert(what).second && warnings.size() < most) warnings.push_back(what);
}

std::vector<std::string> GltfFile::takeWarnings() {
    const std::size_t more = knownWarnings.size() - warnings.size();
    if (more > 0) warnings.push_back(std::to_string(more) + " more warnings are left out");
    return std::move(warnings);
}

void GltfFile::reserve(std::size_t bytes, const std::string& what) {
    if (bytes > limitBytes - usedBytes)
        fail(what + " asks for " + megabytesText(bytes) + ", and only " +
                 megabytesText(limitBytes - usedBytes) + " are left of the " + megabytesText(limitBytes) +
                 " that a scene may take (half of the available memory)",
             std::string("make the scene smaller, or ") + memoryRemedy());
    usedBytes += bytes;
}

void GltfFile::reserveGeometry(std::size_t count, std::size_t bytesEach) {
    if (count > (maxGeometryBytes - geometryBytes) / bytesEach)
        fail("its meshes ask for more than " + std::to_string(maxGeometryBytes >> 20) + " MiB of vertices",
             "simplify the scene");
    geometryBytes += count * bytesEach;
    reserve(count * bytesEach, "one of its meshes");
}

void GltfFile::reserveTexture(std::size_t bytes, const std::string& what) {
    if (bytes > maxTextureBytes - textureBytes)
        fail("its textures ask for more than " + std::to_string(maxTextureBytes >> 20) + " MiB, the last " +
                 megabytesText(bytes) + " of them for " + what,
             "scale them down");
    textureBytes += bytes;
    reserve(bytes, what);
}

std::string textAt(const json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

json takeObjects(const GltfFile& file, json& object, const char* key, const std::string& whose) {
    const auto found = object.find(key);
    if (found == object.end()) return json::array();
    json list = std::move(*found);
    object.erase(found);
    const auto isObject = [](const json& element) { return element.is_object(); };
    if (!list.is_array() || !std::all_of(list.begin(), list.end(), isObject))
        file.fail(whose + " " + key + " are not a list of objects");
    return list;
}

std::string indexAndName(std::size_t index, const std::string& name) {
    return std::to_string(index) + (name.empty() ? "" : " (" + oneLine(name) + ")");
}

GltfFile openGltf(const std::string& path, const Bytes& bytes, const ReadFile& readFile, bool allowOutside) {
    GltfFile file;
    file.path = path;
    file.readFile = readFile;
    file.allowOutside = allowOutside;
    file.limitBytes = availableMemory() / 2;

    if (bytes.empty()) file.fail("the file is empty", "copy or export it again");
    Chunks chunks{bytes.data(), bytes.size(), nullptr, 0};
    if (bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0) {
        chunks = splitGlb(file, bytes);
    } else if (const ForeignFile foreign = foreignFile(path, bytes); !foreign.cause.empty()) {
        file.fail(foreign.cause, foreign.remedy);
    } else if (!beginsAsJson(bytes)) {
        file.fail("it is neither JSON (.gltf) nor binary glTF (.glb)", "check that it is the right file");
    }

    const std::size_t readingBytes = checkedMarkCount(file, chunks) * bytesPerJsonMark;
    file.reserve(readingBytes, "reading its JSON");
    json document = parseJson(file, chunks);
    integersAsSuch(document);
    checkAsset(file, document);
    checkExtensions(file, document);
    checkSparseOffsets(file, document);
    allowMissingInverseBindMatrices(document);
    // These lists are removed from the document, so tinygltf does not see them.
    const json buffers = takeObjects(file, document, "buffers", "its");
    const json images = takeObjects(file, document, "images", "its");
    file.animations = takeObjects(file, document, "animations", "its");

    parseStructure(file, std::move(document));
    file.usedBytes -= readingBytes;

    file.reserve(chunks.binarySize, "its binary chunk");
    readBuffers(file, buffers, chunks);
    readImageSources(file, images);
    return file;
}

}  // namespace vct
