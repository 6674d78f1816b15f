// Writes the picture files of `vct render`.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/output.h"
#include "image/tone_map.h"
#include "lab/debug_view.h"

namespace vct::cli {

constexpr const char* picturesGroup = "Pictures";  // heading in --help

// Adds --exposure and --tone-map.
void addPngOptions(CLI::App& command, std::string& exposure, std::string& toneMap);

// True if the value of --out names a picture (.png or .exr) and not a folder. Throws vct::Error if it names a
// file of another kind.
bool namesOnePicture(const std::string& out);

class PictureWriter {
  public:
    // `out`: a folder, or one picture (namesOnePicture()). `exposure` applies to the PNGs. Without it,
    // chooseExposure() must be called before write(). Throws vct::Error if the folder cannot be created or
    // written to.
    PictureWriter(const std::string& out, std::optional<float> exposure, ToneMap toneMap, bool contactSheet);

    // Throws vct::Error if a folder stands where write() of this name would write a file.
    void requireRoomFor(const std::string& name) const;
    // The same for writeContactSheet() and for writeDebugViews().
    void requireRoomForContactSheet() const;
    void requireRoomForDebugViews() const;

    // Chooses the exposure for `image` and uses it for all PNGs of the run, so that sequences do not flicker
    // and modes can be compared. Prints it, with a warning if the picture is much darker than `white`, the
    // radiance of a white surface in the scene's light.
    void chooseExposure(const Image& image, float white);

    // Writes NAME.png and NAME.exr, or the one picture that --out names. `shown`: the values of the PNG,
    // linear.
    void write(const std::string& name, const Image& image, Image shown);
    // If the exposure was given by the user, warns about the first PNG that is white over much of its area.
    void warnIfWhite(const std::string& name, const Image& radiance);
    // Returns what a PNG shows of radiance: with exposure and tone mapping, linear.
    Image shown(const Image& radiance) const { return toneMapped(radiance, toneMap_, exposure_); }
    // Writes the pictures so far on one sheet, if that was asked for and there are several.
    void writeContactSheet();
    void writeDebugViews(const std::vector<DebugView>& views);

    // Prints where the pictures are, and a note with those in the folder that are older than this run,
    // because nothing is deleted from a folder that was used before.
    void nameWrittenPictures() const;

  private:
    std::vector<std::string> filesOf(const std::string& name) const;

    std::filesystem::file_time_type start_ = std::filesystem::file_time_type::clock::now();
    std::string onePicture_;  // name of the only file, or ""
    OutputFolder folder_;
    std::vector<std::string> written_;
    float exposure_;
    ToneMap toneMap_;
    bool contactSheet_, warned_;
    std::vector<std::pair<std::string, Image>> sheet_;  // with the values of the PNGs
};

}  // namespace vct::cli
