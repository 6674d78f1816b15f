#include "cli/pictures.h"

#include <algorithm>
#include <cstdio>
#include <set>

#include "cli/progress.h"

namespace vct::cli {

PictureWriter::PictureWriter(const std::string& folder, float exposure, bool contactSheet)
    : folder_(folder), exposure_(exposure), contactSheet_(contactSheet) {}

void PictureWriter::write(const std::string& name, const Image& image) {
    warnIfCutOff(name, image);
    writeExr(folder_.file(name + ".exr"), image);
    Image exposed = image;
    for (glm::vec3& pixel : exposed.pixels)
        pixel *= exposure_;
    writePng(folder_.file(name + ".png"), exposed);
    folder_.keep();
    if (contactSheet_) sheet_.emplace_back(name, std::move(exposed));
}

void PictureWriter::writeContactSheet() {
    if (sheet_.size() > 1) writePng(folder_.file("contact_sheet.png"), contactSheet(sheet_, 3));
}

void PictureWriter::writeDebugViews(const std::vector<DebugView>& views) {
    OutputFolder folder(folder_.file("debug_views"));
    for (const DebugView& view : views) {
        writePng(folder.file(view.name + ".png"), view.image);
        if (view.hasUnits) writeExr(folder.file(view.name + ".exr"), view.image);
        folder.keep();
    }
}

void PictureWriter::nameOlderPictures() const {
    std::set<std::string> older;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
        const std::filesystem::path& path = entry.path();
        const bool picture = path.extension() == ".png" || path.extension() == ".exr";
        if ((picture || path.filename() == "debug_views") && entry.last_write_time() < start_)
            older.insert(path.filename().string());
    }
    std::string names;
    for (const std::string& name : older)
        names += (names.empty() ? "" : ", ") + name;
    if (!names.empty()) say("note: not of this run, but in " + folder_.path() + ": " + names);
}

void PictureWriter::warnIfCutOff(const std::string& name, const Image& image) {
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
