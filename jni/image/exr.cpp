// EXR files by OpenEXR.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>

#include "core/error.h"
#include "core/one_line.h"
#include "image/files.h"

namespace vct {
namespace {

const std::vector<const char*> rgb{"R", "G", "B"};

// Describes the pixels' components as OpenEXR's planes. `corner` is the position of the first pixel in the
// file.
Imf::FrameBuffer planesOf(const Image& image, const std::vector<const char*>& names, Imath::V2i corner) {
    Imf::FrameBuffer planes;
    for (std::size_t c = 0; c < names.size(); ++c)
        planes.insert(names[c], Imf::Slice::Make(Imf::FLOAT, &image.pixels[0][static_cast<int>(c)], corner,
                                                 image.width, image.height, sizeof(glm::vec3)));
    return planes;
}

// The reason of an OpenEXR error, without its name of the file: a stream in memory is called "(string)".
std::string reasonOf(const std::exception& error) {
    const std::string text = error.what(), name = "\"(string)\". ";
    const std::size_t found = text.find(name);
    return asClause(found == std::string::npos ? text : text.substr(found + name.size()));
}

}  // namespace

void writeExr(const std::string& path, const Image& image) {
    checkWritable(path, image);
    Imf::Header header(image.width, image.height);
    for (const char* name : rgb)
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    Imf::StdOSStream stream;
    try {
        Imf::OutputFile file(stream, header);
        file.setFrameBuffer(planesOf(image, rgb, {0, 0}));
        file.writePixels(image.height);
    } catch (const std::exception& error) {
        throw Error("cannot write picture '" + path + "': EXR encoding failed (" + reasonOf(error) +
                    "); choose a smaller size");
    }
    replaceFile(path, stream.str());
}

Image decodeExr(const std::string& path, const Bytes& bytes) {
    try {
        Imf::Header::setMaxImageSize(maxImageSide, maxImageSide);
        Imf::StdISStream stream;
        stream.str(std::string(bytes.begin(), bytes.end()));
        Imf::InputFile file(stream);
        // A few bytes can announce an enormous picture.
        if (!file.isComplete()) throw Error("it is incomplete");
        const Imf::ChannelList& channels = file.header().channels();
        const auto has = [&](const char* name) { return channels.findChannel(name) != nullptr; };
        const bool colored = has("R") && has("G") && has("B");
        if (!colored && !has("Y")) throw Error("it has neither the channels R, G and B nor Y");
        const Imath::Box2i window = file.header().dataWindow();
        const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
        requirePixelMemory(width, height, 0);
        Image image(width, height);
        file.setFrameBuffer(planesOf(image, colored ? rgb : std::vector<const char*>{"Y"}, window.min));
        file.readPixels(window.min.y, window.max.y);
        if (!colored)
            for (glm::vec3& pixel : image.pixels)
                pixel = glm::vec3(pixel.r);
        return image;
    } catch (const std::exception& error) {
        throw Error("cannot read EXR '" + path + "': " + reasonOf(error) +
                    "; write the file again, or with fewer pixels");
    }
}

}  // namespace vct
