#include "app/recording.h"

#include "app/log.h"
#include "core/files.h"
#include "core/number_text.h"

namespace vct::app {

bool Recording::add(const Frame& frame) {
    passedMs_ += frame.frameMs;
    ++frames_;
    for (const double value : {passedMs_, frame.frameMs, frame.workMs, frame.divisor})
        rows_ += numberText(value) + ",";
    rows_ += (frame.headroom ? numberText(*frame.headroom) : "") + "\n";
    if (passedMs_ < 1e3 * seconds_) return true;
    replaceFile(results_.path() + "/frames.csv", rows_);
    const std::string text = "recorded " + std::to_string(frames_) + " frames";
    results_.done(text);
    log(text);
    return false;
}

}  // namespace vct::app
