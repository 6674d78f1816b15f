#include "cli/pictures.h"
#include "lab/debug_view.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "cli/progress.h"

namespace vct::cli {

namespace {

Image exposed(Image image, float exposure) {
    for (glm::vec3& pixel : image.pixels)
        pixel *= exposure;
    return image;
}

}  // namespace

void writePicture(const std::string& name, const Image& image, const PictureOptions& options,
                  const OutputFolder& out) {
    writeExr(out.file(name + ".exr"), image);
    writePng(out.file(name + ".png"), exposed(image, options.exposure));
}

std::set<std::string> write(const Pictures& pictures, const PictureOptions& options, OutputFolder& out) {
    std::set<std::string> made;
    std::vector<std::pair<std::string, Image>> sheet;
    for (const auto* group : {&pictures.modes, &pictures.lightParts})
        for (const auto& [name, image] : *group) {
            writePicture(name, image, options, out);
            made.insert({name + ".exr", name + ".png"});
            if (group == &pictures.modes) sheet.emplace_back(name, exposed(image, options.exposure));
        }
    if (options.contactSheet && sheet.size() > 1) {
        writePng(out.file("contact_sheet.png"), contactSheet(sheet, 3));
        made.insert("contact_sheet.png");
    }
    if (!pictures.debugViews.empty()) {
        OutputFolder views(out.file("debug_views"));
        for (const DebugView& view : pictures.debugViews) {
            writePng(views.file(view.name + ".png"), view.image);
            if (view.hasUnits) writeExr(views.file(view.name + ".exr"), view.image);
        }
        views.keep();
        made.insert("debug_views");
    }
    out.keep();
    return made;
}

void nameOlderPictures(const std::set<std::string>& made, const PictureOptions& options) {
    std::set<std::string> older;
    for (const auto& entry : std::filesystem::directory_iterator(options.out)) {
        const std::filesystem::path& path = entry.path();
        const bool picture = path.extension() == ".png" || path.extension() == ".exr";
        if ((picture || path.filename() == "debug_views") && made.count(path.filename().string()) == 0)
            older.insert(path.filename().string());
    }
    std::string names;
    for (const std::string& name : older)
        names += (names.empty() ? "" : ", ") + name;
    if (!names.empty()) say("note: not of this run, but in " + options.out + ": " + names);
}

void ExposureCheck::operator()(const std::string& name, const Image& image) {
    constexpr float overWhite = 1.1F;      // a sheet of paper in full light may be white
    constexpr double largeShare = 0.25;    // a window or a lamp may be too bright for the picture
    constexpr double advisedShare = 0.95;  // that the advised exposure keeps below white
    if (warned_) return;
    std::vector<float> brightest;
    std::ptrdiff_t cutOff = 0;
    for (const glm::vec3& pixel : image.pixels) {
        cutOff += std::min({pixel.r, pixel.g, pixel.b}) * exposure_ > overWhite;
        brightest.push_back(std::max({pixel.r, pixel.g, pixel.b}));
    }
    const auto count = static_cast<double>(brightest.size());
    warned_ = static_cast<double>(cutOff) > largeShare * count;
    if (!warned_) return;
    const auto limit = brightest.begin() + static_cast<std::ptrdiff_t>(advisedShare * count);
    std::nth_element(brightest.begin(), limit, brightest.end());
    char text[200];
    std::snprintf(
        text, sizeof text,
        "warning: %s.png: %.0f %% of the pixels are brighter than white and cut off; try --exposure "
        "%.1g (the EXR has all of it)",
        name.c_str(), 100.0 * static_cast<double>(cutOff) / count, 1.0 / double{*limit});
    say(text);
}

}  // namespace vct::cli
