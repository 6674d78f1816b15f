// vct compare: compares two pictures with a tolerance.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include "cli/commands.h"
#include "core/error.h"
#include "image/compare.h"
#include "image/files.h"
#include "scene/gltf.h"

namespace vct::cli {
namespace {

struct Options {
    std::string first;
    std::string second;
    std::string maxDifference;
    double maxFraction = 0.0;
    std::string diff;
};

struct Picture {
    Image image;
    ImageFormat format;
};

const char* const example =
    "A pixel differs if one of its channels differs by more than --max-difference. The pictures differ if "
    "more than --max-fraction of their pixels do.\n"
    "PNGs are compared by their stored values (sRGB, full scale is 1), EXRs by their linear values.\n"
    "Exit code: 0 if the pictures agree, 1 if they differ or cannot be compared.\n"
    "Example: allows differences of up to 5/255 everywhere, and larger ones in one pixel of a thousand\n"
    "  vct compare out.png golden.png --max-difference 5/255 --max-fraction 0.001 --diff diff.png";

// Reads "0.02" or "5/255". Returns what is wrong with the text; empty if it is valid.
std::string parseNumber(const std::string& text, double& value) {
    char* end = nullptr;
    value = std::strtod(text.c_str(), &end);
    bool good = end != text.c_str();
    if (good && *end == '/') {
        const char* denominator = end + 1;
        value /= std::strtod(denominator, &end);
        good = end != denominator;
    }
    if (good && *end == '\0' && std::isfinite(value) && value >= 0.0) return {};
    return "'" + text + "' is not a number of 0 or more, such as 0.02 or 5/255";
}

Picture read(const std::string& path) {
    const Bytes bytes = readFileFromDisk(path);
    const ImageFormat format = imageFormat(path, bytes);
    if (format == ImageFormat::exr) return {decodeExr(path, bytes), format};
    Image image = decodePng(path, bytes);
    // decodePng() returns linear values. Rounding restores the stored 8-bit values exactly.
    for (glm::vec3& pixel : image.pixels) {
        for (int c = 0; c < 3; ++c)
            pixel[c] = std::round(srgbEncode(pixel[c]) * 255.0F) / 255.0F;
    }
    return {std::move(image), format};
}

int compare(const Options& options) {
    double maxDifference = 0.0;
    parseNumber(options.maxDifference, maxDifference);  // never fails: CLI11 has checked the option
    const Picture a = read(options.first);
    const Picture b = read(options.second);
    const std::string pair = "'" + options.first + "' and '" + options.second + "'";
    if (a.format != b.format) {
        throw Error("cannot compare " + pair +
                    ": one is a PNG, the other an EXR; give two pictures of the same format");
    }
    const bool png = a.format == ImageFormat::png;
    if (png && maxDifference > 1.0) {
        throw Error("cannot compare " + pair + ": --max-difference " + options.maxDifference +
                    " is above full scale; for PNGs give a number from 0 to 1, such as 5/255");
    }
    const auto limit = static_cast<float>(maxDifference);
    const Difference difference = compareImages(a.image, b.image, limit);
    const bool sameSize = a.image.width == b.image.width && a.image.height == b.image.height;
    if (!options.diff.empty() && sameSize) {
        writePng(options.diff, differenceImage(a.image, b.image, limit));
    }
    if (!difference.comparable) {
        throw Error("cannot compare " + pair + ": " + difference.reason +
                    "; give two pictures of one size, without NaN and infinity");
    }
    const bool agree = difference.fraction <= options.maxFraction;
    std::printf("%s: largest difference %.6g", agree ? "agree" : "DIFFER", double(difference.largest));
    if (png) std::printf(" (%.0f/255)", 255.0 * double(difference.largest));
    std::printf(", fraction of pixels beyond %s: %.6g (at most %.6g allowed)\n",
                options.maxDifference.c_str(), difference.fraction, options.maxFraction);
    return agree ? 0 : 1;
}

}  // namespace

void addCompare(CLI::App& app, int& exitCode) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("compare", "Compare two pictures within a tolerance");
    command->footer(example);
    command->add_option("A", options->first, "First picture, PNG or EXR")->required();
    command->add_option("B", options->second, "Second picture, of the same format and size")->required();
    command
        ->add_option("--max-difference", options->maxDifference,
                     "Largest difference of a channel that is allowed in every pixel: for PNGs 0 to 1 or "
                     "n/255, for EXRs in linear units (required)")
        ->check([](const std::string& text) {
            double value = 0.0;
            return parseNumber(text, value);
        });
    command
        ->add_option("--max-fraction", options->maxFraction,
                     "Fraction of the pixels that may exceed --max-difference, 0 to 1 (required)")
        ->check(CLI::Range(0.0, 1.0));
    command->add_option(
        "--diff", options->diff,
        "File for |A - B| as a PNG: mid-grey means --max-difference, magenta NaN or infinity");
    command->callback([options, command, &exitCode] {
        // In one message, which CLI11's own check of required options cannot do.
        if (command->count("--max-difference") == 0 || command->count("--max-fraction") == 0)
            throw CLI::RequiredError(
                "--max-difference and --max-fraction are required, such as --max-difference 5/255 "
                "--max-fraction 0.001",
                CLI::ExitCodes::RequiredError);
        exitCode = compare(*options);
    });
}

}  // namespace vct::cli
