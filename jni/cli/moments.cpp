#include "cli/moments.h"

#include <cstdio>

#include "core/error.h"

namespace vct::cli {

namespace {
constexpr int mostFrames = 10000;  // as many as four digits count
}

void validate(const MomentOptions& options) {
    if (options.timeS && *options.timeS < 0.0) throw Error("--time must be a number of seconds from 0 on");
    if (options.frames.has_value() != options.fps.has_value())
        throw Error("--frames and --fps go together: --frames 48 --fps 24 renders two seconds");
    if (options.frames && (*options.frames < 1 || *options.frames > mostFrames))
        throw Error("--frames must be between 1 and " + std::to_string(mostFrames));
    if (options.fps && !(*options.fps > 0.0)) throw Error("--fps must be a number above 0");
}

std::vector<double> momentsOf(const MomentOptions& options, const Scene& scene) {
    if (!options.asked()) return {};
    if (scene.animation.channels.empty())
        throw Error("the scene " + scene.path +
                    " has no animation of its nodes, so it looks the same at all times; leave out --time, "
                    "--frames and --fps");
    const double start = options.timeS.value_or(0.0);
    std::vector<double> moments;
    for (int frame = 0; frame < options.frames.value_or(1); ++frame)
        moments.push_back(start + (frame == 0 ? 0.0 : frame / *options.fps));
    return moments;
}

std::string frameSuffix(std::size_t index) {
    char text[32];
    std::snprintf(text, sizeof text, "_%04zu", index);
    return text;
}

}  // namespace vct::cli
