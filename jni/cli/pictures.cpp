#include "cli/pictures.h"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <set>

#include "cli/options.h"
#include "cli/progress.h"
#include "core/error.h"
#include "core/list_text.h"
#include "core/number_text.h"

namespace vct::cli {

namespace fs = std::filesystem;

namespace {

// The largest automatic exposure without a warning, relative to the one that shows a white surface in full
// light as white. The dark side of a wall in the sun needs 13 (assets/thin_wall.glb).
constexpr float maxBrightening = 16.0F;

}  // namespace

void addPngOptions(CLI::App& command, std::string& exposure, std::string& toneMap) {
    command
        .add_option(
            "--exposure", exposure,
            "Brightness of the PNGs: a factor, or auto, which brings the geometric mean of the last mode's "
            "first picture to middle grey and prints the factor, with a warning if it brightens the scene "
            "more "
            "than 16 times. All PNGs of a run use the same factor; EXRs "
            "are never scaled")
        ->check([](const std::string& text) { return text == "auto" ? std::string() : positive(text); })
        ->capture_default_str()
        ->group(picturesGroup);
    command
        .add_option(
            "--tone-map", toneMap,
            "Tone mapping of the PNGs: neutral (Khronos PBR Neutral, which keeps colours up to 0.8 and "
            "compresses brighter ones), agx (as in Blender: bright colours turn white gradually), aces (as "
            "of "
            "film: more contrast, darker) or none (values above 1 are clamped)")
        ->capture_default_str()
        ->group(picturesGroup);
}

bool namesOnePicture(const std::string& out) {
    std::string ending = fs::path(out).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    std::error_code ignored;
    if (fs::is_directory(out, ignored)) return false;
    for (const char* other :
         {".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".gif", ".webp", ".hdr", ".mp4", ".webm"})
        if (ending == other)
            throw Error("--out " + out + ": vct writes no " + ending +
                        " files; name a .png, an .exr or a folder");
    return ending == ".png" || ending == ".exr";
}

PictureWriter::PictureWriter(const std::string& out, std::optional<float> exposure, ToneMap toneMap,
                             bool contactSheet)
    : onePicture_(namesOnePicture(out) ? fs::path(out).filename().string() : ""),
      folder_(onePicture_.empty()               ? out
              : fs::path(out).has_parent_path() ? fs::path(out).parent_path().string()
                                                : "."),
      exposure_(exposure.value_or(1.0F)),
      toneMap_(toneMap),
      contactSheet_(contactSheet),
      warned_(!exposure) {}

std::vector<std::string> PictureWriter::filesOf(const std::string& name) const {
    if (!onePicture_.empty()) return {folder_.file(onePicture_)};
    return {folder_.file(name + ".exr"), folder_.file(name + ".png")};
}

void PictureWriter::requireRoomFor(const std::string& name) const {
    for (const std::string& file : filesOf(name))
        requireNoFolder(file);
}

void PictureWriter::requireRoomForContactSheet() const {
    requireNoFolder(folder_.file("contact_sheet.png"));
}

void PictureWriter::requireRoomForDebugViews() const {
    const OutputFolder folder(folder_.file("debug_views"));
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        if (entry.path().extension() == ".png" || entry.path().extension() == ".exr")
            requireNoFolder(entry.path().string());
}

void PictureWriter::chooseExposure(const Image& image, float white) {
    exposure_ = automaticExposure(image);
    say("exposure of all PNGs: " + numberText(exposure_) + " (--exposure " + numberText(exposure_) +
        " repeats it)");
    if (exposure_ * white <= maxBrightening) return;
    char text[320];
    std::snprintf(text, sizeof text,
                  "warning: little of the scene's light reaches the picture. Its exposure would show a white "
                  "surface in full light %.2g times too bright, and above %g errors become visible, such as "
                  "light that leaks through walls. Choose another --camera, or other light with --light and "
                  "--sky",
                  double{exposure_ * white}, double{maxBrightening});
    say(text);
}

void PictureWriter::write(const std::string& name, const Image& image, Image shown) {
    for (const std::string& file : filesOf(name)) {
        if (file.back() == 'r' || file.back() == 'R')  // .exr
            writeExr(file, image);
        else
            writePng(file, shown);
        folder_.keep();
        written_.push_back(file);
    }
    if (contactSheet_) sheet_.emplace_back(name, std::move(shown));
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

void PictureWriter::nameWrittenPictures() const {
    if (written_.size() <= 2)
        say("wrote " + listText(written_));
    else
        say("wrote " + std::to_string(written_.size()) + " pictures into " + folder_.path());
    if (!onePicture_.empty()) return;
    std::set<std::string> older;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
        const std::filesystem::path& path = entry.path();
        const bool picture = path.extension() == ".png" || path.extension() == ".exr";
        if ((picture || path.filename() == "debug_views") && entry.last_write_time() < start_)
            older.insert(path.filename().string());
    }
    if (!older.empty())
        say("note: " + folder_.path() +
            " also has files of earlier runs: " + listText({older.begin(), older.end()}));
}

void PictureWriter::warnIfWhite(const std::string& name, const Image& radiance) {
    constexpr float overWhite = 1.1F;      // white paper in full light may slightly exceed 1
    constexpr double largeShare = 0.25;    // windows and emitters may be too bright for the picture
    constexpr double advisedShare = 0.95;  // share of pixels that the advised exposure keeps below white
    if (warned_) return;
    std::vector<float> brightest;
    std::ptrdiff_t cutOff = 0;
    for (const glm::vec3& pixel : radiance.pixels) {
        cutOff += std::min({pixel.r, pixel.g, pixel.b}) * exposure_ > overWhite;
        brightest.push_back(std::max({pixel.r, pixel.g, pixel.b}));
    }
    const auto count = static_cast<double>(brightest.size());
    warned_ = static_cast<double>(cutOff) > largeShare * count;
    if (!warned_) return;
    const auto limit = brightest.begin() + static_cast<std::ptrdiff_t>(advisedShare * count);
    std::nth_element(brightest.begin(), limit, brightest.end());
    char text[200];
    std::snprintf(text, sizeof text,
                  "warning: %s.png: %.0f %% of the pixels are brighter than white; try --exposure %.1g (the "
                  "EXR keeps all values)",
                  name.c_str(), 100.0 * static_cast<double>(cutOff) / count, 1.0 / double{*limit});
    say(text);
}

}  // namespace vct::cli
