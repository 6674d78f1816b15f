// The files that `vct render` makes of what it has rendered.
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

// --exposure and --tone-map.
void addPngOptions(CLI::App& command, std::string& exposure, std::string& toneMap);

class PictureWriter {
  public:
    // `exposure`: of PNGs; without it chooseExposure() comes first. Throws vct::Error where the folder cannot
    // be made or written to.
    PictureWriter(const std::string& folder, std::optional<float> exposure, ToneMap toneMap,
                  bool contactSheet);

    // Takes the exposure that a picture asks for, for all PNGs of the run: nothing flickers, and modes can be
    // compared. Says it.
    void chooseExposure(const Image& image);

    // NAME.png and NAME.exr. Warns of the first picture whose PNG is white over much of its area by an
    // exposure that was given. `isShare`: of 1, no light, so its PNG is as it is.
    void write(const std::string& name, const Image& image, bool isShare = false);
    // The pictures so far side by side, where that was asked for and there are several.
    void writeContactSheet();
    void writeDebugViews(const std::vector<DebugView>& views);

    // Nothing is deleted from a folder that was used before, so what is older than this run is named.
    void nameOlderPictures() const;

  private:
    void warnIfWhite(const std::string& name, const Image& image);

    std::filesystem::file_time_type start_ = std::filesystem::file_time_type::clock::now();
    OutputFolder folder_;
    float exposure_;
    ToneMap toneMap_;
    bool contactSheet_, warned_;
    std::vector<std::pair<std::string, Image>> sheet_;  // as in the PNGs
};

}  // namespace vct::cli
