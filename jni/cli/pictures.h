// The files that `vct render` makes of what it has rendered.
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cli/output.h"
#include "engine/renderer.h"
#include "image/image.h"
#include "lab/debug_view.h"

namespace vct::cli {

struct PictureOptions {
    std::string out;          // folder
    float exposure = 1.0F;    // of PNGs
    bool debugViews = false;  // and every intermediate
    bool contactSheet = false;
};

// The pictures of one moment. Everything is rendered before anything is written.
struct Pictures {
    std::vector<std::pair<std::string, Image>> modes;       // PNG with exposure, and EXR
    std::vector<std::pair<std::string, Image>> lightParts;  // PNG with exposure, and EXR
    std::vector<DebugView> debugViews;
};

// NAME.png and NAME.exr.
void writePicture(const std::string& name, const Image& image, const PictureOptions& options,
                  const OutputFolder& out);
// Returns the names of what it made.
std::set<std::string> write(const Pictures& pictures, const PictureOptions& options, OutputFolder& out);

// Nothing is deleted from a folder that was used before, so what is not of this run is named.
void nameOlderPictures(const std::set<std::string>& made, const PictureOptions& options);

// Warns of the first picture whose PNG is cut off at white over much of its area.
class ExposureCheck {
  public:
    explicit ExposureCheck(float exposure) : exposure_(exposure) {}
    void operator()(const std::string& name, const Image& image);

  private:
    float exposure_;
    bool warned_ = false;
};

}  // namespace vct::cli
