// Records the time of each frame that the user sees, for a while. docs/phone.md describes the file.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "lab/bench_run.h"

namespace vct::app {

class Recording {
  public:
    // Creates the folder of results below `folder`. Throws vct::Error.
    Recording(const std::string& folder, int seconds) : results_(folder + "/results"), seconds_(seconds) {}

    struct Frame {
        double frameMs = 0.0;           // since the frame before it
        double workMs = 0.0;            // from its start until the GPU has finished it
        double divisor = 1.0;           // of the window's sides
        std::optional<float> headroom;  // as the device told last
    };
    // Returns false once the time has passed. Then the file is written. Throws vct::Error.
    bool add(const Frame& frame);

    void failed(const std::string& why) { results_.failed(why); }

  private:
    ResultsFolder results_;
    int seconds_;
    double passedMs_ = 0.0;
    int frames_ = 0;
    std::string rows_ = "end_ms,frame_ms,work_ms,divisor,headroom\n";
};

}  // namespace vct::app
