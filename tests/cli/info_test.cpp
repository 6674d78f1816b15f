#include <gtest/gtest.h>

#include <regex>
#include <string>

#include "cli/program_run.h"
#include "platform/contexts.h"
#include "support/errors.h"
#include "support/gltf_builder.h"

namespace vct::test {
namespace {

struct Outcome {
    int exitCode;
    std::string output;
};

// Mesa can be told through the environment to have less than it has; it reads that once in a process.
Outcome info(const std::string& environment, const std::string& arguments) {
    ProgramRun program;
    const int exitCode = program.run("info " + arguments, environment);
    return {exitCode, program.err + program.out};
}

// The output has the text, apart from the padding of tables.
bool has(const Outcome& outcome, const std::string& text) {
    return std::regex_replace(outcome.output, std::regex(" +"), " ").find(text) != std::string::npos;
}

TEST(Info, NamesTheDriverAndMissesNothing) {
    const Outcome outcome = info("", "");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    EXPECT_TRUE(has(outcome, "OpenGL ES 3.")) << outcome.output;
    EXPECT_FALSE(has(outcome, "MISSING")) << outcome.output;
}

TEST(Info, NamesMissingExtensionsAndExitsWithOne) {
    if (!has(info("", ""), "Mesa")) GTEST_SKIP() << "only Mesa can be told to lack an extension";
    const Outcome outcome = info(
        "MESA_GLES_VERSION_OVERRIDE=3.1 "
        "MESA_EXTENSION_OVERRIDE='-GL_OES_shader_image_atomic -GL_EXT_geometry_shader'",
        "");
    EXPECT_EQ(outcome.exitCode, 1) << outcome.output;
    EXPECT_TRUE(has(outcome, "MISSING GL_OES_shader_image_atomic")) << outcome.output;
    EXPECT_TRUE(has(outcome, "absent GL_EXT_geometry_shader")) << outcome.output;
    EXPECT_TRUE(has(outcome, "no global illumination without")) << outcome.output;
}

TEST(Info, PrintsNothingButItsReportOnZink) {
    VCT_SKIP_IF_ABSENT(Backend::zink);
    const Outcome outcome = info("env -u XDG_RUNTIME_DIR", "--backend zink");
    EXPECT_EQ(outcome.exitCode, 0) << outcome.output;
    EXPECT_EQ(outcome.output.compare(0, 9, "back end:"), 0) << outcome.output;
    EXPECT_FALSE(has(outcome, "XDG_RUNTIME_DIR")) << outcome.output;
}

TEST(Info, ListsWhatAFileHasAndWhatOfItIsNotDrawn) {
    GltfBuilder builder;
    builder.triangle();
    builder.document["extensionsUsed"] = {"KHR_lights_punctual", "KHR_materials_variants"};
    builder.document["extensions"] = {
        {"KHR_lights_punctual",
         {{"lights",
           {{{"type", "directional"}},
            {{"type", "spot"}, {"name", "desk"}, {"spot", json::object()}, {"intensity", 5}}}}}},
        {"KHR_materials_variants", {{"variants", {{{"name", "oak"}}, {{"name", "steel"}}}}}}};
    for (const int light : {0, 1})
        builder.node({{"extensions", {{"KHR_lights_punctual", {{"light", light}}}}}});
    builder.node(
        {{"name", "front"},
         {"camera", builder.add("cameras", {{"type", "perspective"},
                                            {"perspective", {{"yfov", 1.0471976}, {"znear", 1}}}})}});
    for (const std::size_t i : {0U, 1U}) {
        builder.animate(0, "translation", {0, 1}, {0, 0, 0, 1, 0, 0}, "LINEAR", i);
        builder.document["animations"][i]["name"] = i == 0 ? "walk" : "run";
    }
    ProgramRun program;
    writeBytes(program.folder.file("a.glb"), builder.glb());
    EXPECT_EQ(program.run("info a.glb"), 0) << program.err;
    expectMentions(
        program.out,
        {"cameras:    0 \"front\" (60 degrees)\n", "lights:     the sun (1 lx), \"desk\" (spot, 5 cd)\n",
         "animations: 0 (walk), 1 (run)\n", "variants:   oak, steel\n", "not drawn: variants of materials",
         "not drawn: extension KHR_materials_variants is ignored"});
}

}  // namespace
}  // namespace vct::test
