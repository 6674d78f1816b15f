// The files that `vct render` makes of what it has rendered.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "cli/output.h"
#include "lab/debug_view.h"

namespace vct::cli {

class PictureWriter {
  public:
    // `exposure` is of PNGs. Throws vct::Error where the folder cannot be made or written to.
    PictureWriter(const std::string& folder, float exposure, bool contactSheet);

    // NAME.png and NAME.exr. Warns of the first picture whose PNG is cut off at white over much of its area.
    void write(const std::string& name, const Image& image);
    // The pictures so far side by side, where that was asked for and there are several.
    void writeContactSheet();
    void writeDebugViews(const std::vector<DebugView>& views);

    // Nothing is deleted from a folder that was used before, so what is older than this run is named.
    void nameOlderPictures() const;

  private:
    void warnIfCutOff(const std::string& name, const Image& image);

    std::filesystem::file_time_type start_ = std::filesystem::file_time_type::clock::now();
    OutputFolder folder_;
    float exposure_;
    bool contactSheet_, warned_ = false;
    std::vector<std::pair<std::string, Image>> sheet_;  // with exposure
};

}  // namespace vct::cli
