// What OpenEXR's "OpenEXR File Layout" says of a single-part scan-line file, checked before tinyexr sees it.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>

#include "core/error.h"
#include "image/files.h"

namespace vct {
namespace {

struct Malformed {
    std::string cause;
};

class Reader {
  public:
    explicit Reader(const Bytes& bytes) : bytes_(bytes) {}

    std::size_t position() const { return at_; }
    std::size_t left() const { return bytes_.size() - at_; }
    void skip(std::size_t count) {
        need(count);
        at_ += count;
    }
    template <typename T>
    T read() {  // EXR is little-endian, as is everything this runs on
        T value;
        need(sizeof value);
        std::memcpy(&value, bytes_.data() + at_, sizeof value);
        at_ += sizeof value;
        return value;
    }
    std::string text() {
        const auto first = bytes_.begin() + static_cast<std::ptrdiff_t>(at_);
        const auto end = std::find(first, bytes_.end(), '\0');
        if (end == bytes_.end()) throw Malformed{"it ends inside its header"};
        if (end - first > 255) throw Malformed{"it has a name of more than 255 characters"};
        at_ += static_cast<std::size_t>(end - first) + 1;
        return std::string(first, end);
    }

  private:
    void need(std::size_t count) const {
        if (left() < count) throw Malformed{"it ends too early"};
    }

    const Bytes& bytes_;
    std::size_t at_ = 0;
};

// Sizes of the attributes that tinyexr reads without looking at their length.
const std::map<std::string, std::uint32_t> fixedSizes = {
    {"compression", 1},      {"dataWindow", 16},        {"displayWindow", 16},    {"lineOrder", 1},
    {"pixelAspectRatio", 4}, {"screenWindowCenter", 8}, {"screenWindowWidth", 4}, {"chunkCount", 4},
};

// Lines in a chunk, by compression: none, RLE, ZIPS, ZIP, PIZ.
constexpr int linesPerChunk[] = {1, 1, 1, 16, 32};

struct Header {
    std::int64_t bytesPerPixel = 0;
    int compression = -1;
    std::int64_t minX = 0, minY = 0, maxX = -1, maxY = -1;
};

std::int64_t readChannels(Reader& reader) {
    std::int64_t bytesPerPixel = 0;
    for (int count = 0;; ++count) {
        if (reader.text().empty()) return bytesPerPixel;
        if (count == 64) throw Malformed{"it has more than 64 channels"};
        const auto type = reader.read<std::uint32_t>();  // 0 uint, 1 half, 2 float
        reader.skip(4);
        const auto samplingX = reader.read<std::int32_t>();
        const auto samplingY = reader.read<std::int32_t>();
        if (type > 2) throw Malformed{"it has a channel of unknown type"};
        if (samplingX != 1 || samplingY != 1) throw Malformed{"it has a subsampled channel"};
        bytesPerPixel += type == 1 ? 2 : 4;
    }
}

Header readHeader(Reader& reader) {
    reader.skip(4);  // magic number, checked by imageFormat()
    const auto version = reader.read<std::uint32_t>();
    if ((version & 0xFFU) != 2) throw Malformed{"it is not of version 2"};
    // Bit 10 (names of up to 255 characters) is the only flag that is harmless here.
    if ((version & ~0x4FFU) != 0)
        throw Malformed{"it is tiled, deep or of several parts, which is not read here"};

    Header header;
    for (std::string name = reader.text(); !name.empty(); name = reader.text()) {
        reader.text();  // type
        const auto size = reader.read<std::uint32_t>();
        if (size > reader.left()) throw Malformed{"it ends inside its header"};
        const std::size_t end = reader.position() + size;
        const auto fixed = fixedSizes.find(name);
        if (fixed != fixedSizes.end() && fixed->second != size)
            throw Malformed{"its '" + name + "' is malformed"};
        if (name == "channels") header.bytesPerPixel = readChannels(reader);
        if (name == "compression") header.compression = reader.read<std::uint8_t>();
        if (name == "dataWindow") {
            header.minX = reader.read<std::int32_t>();
            header.minY = reader.read<std::int32_t>();
            header.maxX = reader.read<std::int32_t>();
            header.maxY = reader.read<std::int32_t>();
        }
        if (reader.position() > end) throw Malformed{"its '" + name + "' is malformed"};
        reader.skip(end - reader.position());
    }
    return header;
}

// The range of the bitmap of used values, its bytes, the length of the Huffman code, the code.
void checkPiz(Reader chunk, std::size_t size) {
    const std::size_t end = chunk.position() + size;
    const auto first = chunk.read<std::uint16_t>();
    const auto last = chunk.read<std::uint16_t>();
    if (last >= 8192) throw Malformed{"a chunk is malformed"};
    if (first <= last) chunk.skip(static_cast<std::size_t>(last - first) + 1);
    const auto length = chunk.read<std::int32_t>();
    if (length < 0 || chunk.position() + static_cast<std::size_t>(length) > end) {
        throw Malformed{"a chunk is malformed"};
    }
}

void checkChunks(Reader& reader, const Header& header, std::size_t fileSize) {
    const std::int64_t width = header.maxX - header.minX + 1;
    const std::int64_t height = header.maxY - header.minY + 1;
    if (width < 1 || height < 1 || width > maxImageSide || height > maxImageSide) {
        throw Malformed{"it is " + std::to_string(width) + " x " + std::to_string(height) +
                        ", outside 1 to " + std::to_string(maxImageSide) + " a side"};
    }
    if (header.bytesPerPixel == 0) throw Malformed{"it has no channels"};
    if (header.compression < 0 || header.compression > 4) {
        throw Malformed{"its compression is not one of none, RLE, ZIPS, ZIP and PIZ"};
    }
    const std::int64_t lines = linesPerChunk[header.compression];
    const std::int64_t chunkCount = (height + lines - 1) / lines;
    if (static_cast<std::uint64_t>(chunkCount) * 8 > reader.left()) throw Malformed{"it ends too early"};
    Reader table = reader;
    reader.skip(static_cast<std::size_t>(chunkCount) * 8);
    const std::size_t firstChunk = reader.position();
    std::vector<bool> seen(static_cast<std::size_t>(chunkCount), false);
    for (std::int64_t i = 0; i < chunkCount; ++i) {
        const auto offset = table.read<std::uint64_t>();
        if (offset < firstChunk || offset > fileSize) throw Malformed{"it is incomplete"};
        Reader chunk = reader;
        chunk.skip(static_cast<std::size_t>(offset) - firstChunk);
        const std::int64_t y = chunk.read<std::int32_t>() - header.minY;
        const auto size = chunk.read<std::int32_t>();
        if (y < 0 || y >= height || y % lines != 0 || seen[static_cast<std::size_t>(y / lines)]) {
            throw Malformed{"its lines are out of place"};
        }
        seen[static_cast<std::size_t>(y / lines)] = true;
        const std::int64_t unpacked = std::min(lines, height - y) * width * header.bytesPerPixel;
        // A chunk that compression would enlarge is stored as it is.
        if (size < 1 || size > unpacked || (header.compression == 0 && size != unpacked)) {
            throw Malformed{"a chunk has the wrong size"};
        }
        if (header.compression == 4 && size != unpacked) checkPiz(chunk, static_cast<std::size_t>(size));
        chunk.skip(static_cast<std::size_t>(size));
    }
}

}  // namespace

void checkExrLayout(const std::string& path, const Bytes& bytes) {
    try {
        Reader reader(bytes);
        const Header header = readHeader(reader);
        checkChunks(reader, header, bytes.size());
    } catch (const Malformed& malformed) {
        throw Error("cannot read EXR '" + path + "': " + malformed.cause +
                    "; save it as one part of scan lines, or make it again");
    }
}

}  // namespace vct
