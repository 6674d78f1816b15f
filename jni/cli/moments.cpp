#include "cli/moments.h"

#include <cstdio>

#include "cli/numbers.h"
#include "core/error.h"

namespace vct::cli {

void MomentOptions::addTo(CLI::App& command) {
    command
        .add_option("--time", timeS,
                    "The moment of the scene's animation, in seconds; before its first key and after its "
                    "last it stands still (default: at rest, as the file puts the nodes)")
        ->check(CLI::Range(0.0, 1e6));
    CLI::Option* const framesOption =
        command
            .add_option("--frames", frames,
                        "A sequence of so many pictures, from --time (default 0) on, --fps of them a second")
            ->check(CLI::Range(1, 10000));  // as many as four digits count
    CLI::Option* const fpsOption =
        command.add_option("--fps", fps, "Pictures for each second of the animation")->check(positive);
    framesOption->needs(fpsOption);
    fpsOption->needs(framesOption);
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
