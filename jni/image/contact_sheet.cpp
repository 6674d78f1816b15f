// Puts pictures and their labels on one sheet.
#include <stb_easy_font.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "image/image.h"

namespace vct {
namespace {

constexpr int gap = 8;
constexpr int textScale = 2;
constexpr int labelHeight = 12 * textScale;  // stb_easy_font: 12 pixels a line
constexpr glm::vec3 paper(1.0F);
constexpr glm::vec3 ink(0.02F);

// The font covers only ASCII; stb_easy_font reads outside its table for any other character.
std::string printable(std::string text) {
    std::replace_if(text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
    return text;
}

int textWidth(std::string text) {
    return textScale * stb_easy_font_width(text.data());
}

void drawText(Image& sheet, int left, int top, std::string text) {
    struct Corner {
        float x, y, z;
        unsigned char color[4];
    };
    using Quad = std::array<Corner, 4>;
    // 24 quads are 1536 bytes per character; stb_easy_font needs 270 on average.
    std::vector<Quad> quads(text.size() * 24 + 1);
    const int count = stb_easy_font_print(0.0F, 0.0F, text.data(), nullptr, quads.data(),
                                          static_cast<int>(quads.size() * sizeof(Quad)));
    for (int i = 0; i < count; ++i) {
        const Quad& quad = quads[i];
        const auto pixel = [](float v) { return textScale * static_cast<int>(std::lround(v)); };
        const int endX = std::min(left + pixel(quad[2].x), sheet.width);
        const int endY = std::min(top + pixel(quad[2].y), sheet.height);
        for (int y = top + pixel(quad[0].y); y < endY; ++y) {
            for (int x = left + pixel(quad[0].x); x < endX; ++x)
                sheet.at(x, y) = ink;
        }
    }
}

}  // namespace

Image contactSheet(const std::vector<std::pair<std::string, Image>>& pictures, int columns) {
    if (pictures.empty() || columns < 1) {
        throw Error("cannot make a contact sheet of " + std::to_string(pictures.size()) + " pictures in " +
                    std::to_string(columns) + " columns; give at least one picture and one column");
    }
    const int count = static_cast<int>(pictures.size());
    columns = std::min(columns, count);
    const int rows = (count + columns - 1) / columns;
    int cellWidth = 0;
    int pictureHeight = 0;
    for (const auto& [label, picture] : pictures) {
        cellWidth = std::max({cellWidth, picture.width, textWidth(printable(label))});
        pictureHeight = std::max(pictureHeight, picture.height);
    }
    const int cellHeight = pictureHeight + gap / 2 + labelHeight;

    Image sheet(columns * (cellWidth + gap) + gap, rows * (cellHeight + gap) + gap, paper);
    for (int i = 0; i < count; ++i) {
        const auto& [label, picture] = pictures[i];
        const int left = gap + i % columns * (cellWidth + gap);
        const int top = gap + i / columns * (cellHeight + gap);
        for (int y = 0; y < picture.height; ++y) {
            for (int x = 0; x < picture.width; ++x)
                sheet.at(left + x, top + y) = picture.at(x, y);
        }
        drawText(sheet, left, top + picture.height + gap / 2, printable(label));
    }
    return sheet;
}

}  // namespace vct
