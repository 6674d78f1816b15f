// The ways around faults that real phones have, seen in what frames ask of GL.
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "engine/material_texture.h"
#include "gl/call_log.h"
#include "image/image.h"
#include "support/playing_scene.h"
#include "support/scenes.h"
#include "support/temporary_folder.h"

namespace vct::test {
namespace {

bool isCall(const gl::Call& call, const char* name) {
    return std::strcmp(call.name, name) == 0;
}

// Of some frames in which something moves, after the first.
std::vector<gl::Call> callsOfFrames(const Context& context, const char* preset) {
    Settings settings = presetSettings(preset);
    settings.grid = 64;
    settings.size = glm::ivec2(32);
    settings.shadowMapSize = 64;
    const Scene scene = load(twoThatMove());
    PlayingScene stage(context, scene, settings);
    stage.frameAt(0.0);
    gl::CallLog log;
    for (const double seconds : {0.2, 0.4})
        stage.frameAt(seconds, Output::giConeShadow);
    return log.calls();
}

TEST(DriverFaultsOfFrames, ElementsAreBoundAfterTheirVertexArray) {
    const Context context = openContext(Backend::egl);
    for (const char* preset : {"thesis", "mobile"}) {
        bool bound = false;
        int draws = 0;
        for (const gl::Call& call : callsOfFrames(context, preset)) {
            if (isCall(call, "BindVertexArray")) bound = false;
            if (isCall(call, "BindBuffer") && call.arguments[0] == GL_ELEMENT_ARRAY_BUFFER) bound = true;
            if (!isCall(call, "DrawElements")) continue;
            EXPECT_TRUE(bound) << preset;
            ++draws;
        }
        EXPECT_GT(draws, 0) << preset;
    }
}

TEST(DriverFaultsOfFrames, NoBufferIsCopiedToOneThatWasRead) {
    const Context context = openContext(Backend::egl);
    for (const char* preset : {"thesis", "mobile"}) {
        int dispatches = 0;
        std::int64_t target = 0;
        std::vector<std::int64_t> used;  // by anything before
        for (const gl::Call& call : callsOfFrames(context, preset)) {
            dispatches += isCall(call, "DispatchComputeIndirect");
            if (isCall(call, "BindBufferBase")) used.push_back(call.arguments[2]);
            if (isCall(call, "BindBuffer") && call.arguments[0] == GL_COPY_WRITE_BUFFER)
                target = call.arguments[1];
            if (isCall(call, "CopyBufferSubData")) {
                EXPECT_EQ(std::count(used.begin(), used.end(), target), 0) << preset;
            }
        }
        EXPECT_GT(dispatches, 0) << preset;
    }
}

// The texels of a level, through the framebuffer: sRGB codes.
std::vector<std::uint8_t> levelOf(const gl::Texture& texture, int level) {
    const gl::Framebuffer framebuffer("read", {&texture}, nullptr, level);
    const int width = std::max(texture.width() >> level, 1), height = std::max(texture.height() >> level, 1);
    framebuffer.bind();
    gl::ReadBuffer(GL_COLOR_ATTACHMENT0);
    std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) * height * 4);
    gl::PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl::ReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    return rgba;
}

// Those of a texture and of the same one lying, which the driver makes.
TEST(DriverFaultsOfFrames, MipsOfPortraitTexturesAreMadeWithoutTheDriver) {
    const Context context = openContext(Backend::egl);
    vct::Texture upright, lying;
    upright.width = lying.height = 16;
    upright.height = lying.width = 64;
    std::vector<std::uint8_t> standing(16 * 64 * 4), turned(standing);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 16; ++x)
            for (int c = 0; c < 4; ++c)
                standing[(y * 16 + x) * 4 + c] = turned[(x * 64 + y) * 4 + c] =
                    static_cast<std::uint8_t>((x * 37 + y * 101 + c * 59 + x * y * 13) & 255);
    upright.rgba = standing;
    lying.rgba = turned;
    gl::CallLog log;
    const gl::Texture made = materialTexture(upright);
    EXPECT_EQ(gl::summarize(log.calls()).byName.count("GenerateMipmap"), 0U);
    const gl::Texture driversOwn = materialTexture(lying);
    EXPECT_EQ(gl::summarize(log.calls()).byName.count("GenerateMipmap"), 1U);
    ASSERT_EQ(made.levels(), 7);
    for (int level = 0; level < made.levels(); ++level) {
        const int width = std::max(16 >> level, 1), height = std::max(64 >> level, 1);
        const std::vector<std::uint8_t> ours = levelOf(made, level), theirs = levelOf(driversOwn, level);
        int worst = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                for (int c = 0; c < 4; ++c)
                    worst = std::max(
                        worst, std::abs(ours[(y * width + x) * 4 + c] - theirs[(x * height + y) * 4 + c]));
        EXPECT_LE(worst, level == 0 ? 0 : 2) << "level " << level;
    }
}

// What stands before an operator, without the parentheses around it: "uvec3(h, h >> 10u)".
std::string operandBefore(const std::string& text, std::size_t at) {
    while (at > 0 && std::isspace(static_cast<unsigned char>(text[at - 1])))
        --at;
    const std::size_t end = at;
    int depth = 0;
    const auto isPart = [&](char c) {
        return depth > 0 || std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '[';
    };
    while (at > 0) {
        const char c = text[at - 1];
        if (c == ')' || c == ']')
            ++depth;
        else if ((c == '(' || c == '[') && depth > 0)
            --depth;
        else if (!isPart(c))
            break;
        --at;
    }
    return text.substr(at, end - at);
}

bool isVector(const std::string& operand) {
    if (operand.find("vec") != std::string::npos && operand.find(")[") == std::string::npos) return true;
    // A swizzle of more than one component at its end, or in what is chosen from.
    for (std::size_t dot = operand.find('.'); dot != std::string::npos; dot = operand.find('.', dot + 1)) {
        std::size_t end = dot + 1;
        while (end < operand.size() && std::strchr("xyzwrgba", operand[end]) != nullptr)
            ++end;
        const bool ends =
            end == operand.size() || std::isalnum(static_cast<unsigned char>(operand[end])) == 0;
        if (ends && end - dot > 2) return true;
    }
    return false;
}

TEST(DriverFaultsOfFrames, NoShaderMasksAVector) {
    EXPECT_TRUE(isVector(operandBefore("(uvec3(word) >> uvec3(16, 8, 0)) & 255u", 33)));
    EXPECT_TRUE(isVector(operandBefore("(axis == 0 ? voxel.yz : voxel.xy) & 3", 34)));
    EXPECT_TRUE(isVector(operandBefore("steps.yz & 3", 9)));
    EXPECT_FALSE(isVector(operandBefore("listed.face & 1", 12)));
    EXPECT_FALSE(isVector(operandBefore("uvec3(h & 1023u", 8)));
    int found = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(VCT_SOURCE_DIR "/shaders")) {
        if (!entry.is_regular_file()) continue;
        const std::string text = readBytes(entry.path().string());
        for (std::size_t at = text.find(" & "); at != std::string::npos; at = text.find(" & ", at + 1)) {
            ++found;
            const std::string operand = operandBefore(text, at);
            EXPECT_FALSE(isVector(operand)) << entry.path() << ": " << operand;
        }
    }
    EXPECT_GT(found, 20);
}

}  // namespace
}  // namespace vct::test
