// The limits that real phones report (phones.csv) against those that the renderer needs.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include "engine/driver_needs.h"
#include "gl/requirements.h"
#include "support/errors.h"

namespace vct::test {
namespace {

struct Phone {
    std::string gpu, reports;
    gl::Capabilities capabilities;
};

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, at);)
        parts.push_back(part);
    return parts;
}

std::vector<Phone> phones() {
    static const std::map<std::string, GLenum> limitNames{
        {"fragment_images", GL_MAX_FRAGMENT_IMAGE_UNIFORMS},
        {"compute_images", GL_MAX_COMPUTE_IMAGE_UNIFORMS},
        {"fragment_storage_blocks", GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS},
        {"compute_storage_blocks", GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS},
        {"combined_outputs", GL_MAX_COMBINED_SHADER_OUTPUT_RESOURCES},
        {"texture_3d", GL_MAX_3D_TEXTURE_SIZE},
        {"texture_2d", GL_MAX_TEXTURE_SIZE},
        {"storage_block_mib", GL_MAX_SHADER_STORAGE_BLOCK_SIZE},
        {"group_invocations", GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS},
        {"framebuffer_width", GL_MAX_FRAMEBUFFER_WIDTH},
        {"color_attachments", GL_MAX_COLOR_ATTACHMENTS},
        {"vertex_textures", GL_MAX_VERTEX_TEXTURE_IMAGE_UNITS},
    };
    std::ifstream file(VCT_SOURCE_DIR "/tests/engine/phones.csv");
    std::vector<std::string> columns;
    std::vector<Phone> phones;
    for (std::string line; std::getline(file, line);) {
        if (line[0] == '#') continue;
        const std::vector<std::string> cells = split(line, ';');
        if (columns.empty()) {
            columns = cells;
            continue;
        }
        std::map<GLenum, GLint> limits;
        for (std::size_t i = 6; i < columns.size(); ++i)
            limits[limitNames.at(columns[i])] = static_cast<GLint>(std::min(
                std::stoll(cells.at(i)) << (columns[i] == "storage_block_mib" ? 20 : 0), 0x7FFFFFFFLL));
        Phone phone{cells[0], cells[1], {}};
        gl::Capabilities& capabilities = phone.capabilities;
        capabilities.renderer = cells[3];
        capabilities.version = cells[4];
        capabilities.essl320 = cells[4].find("OpenGL ES 3.2") == 0;
        const auto limit = [&](GLenum name) { return limits.at(name); };
        capabilities.limits = gl::limitsOf(limit);
        capabilities.faults = gl::faultsOf(capabilities.renderer, capabilities.version);
        capabilities.requirements =
            gl::evaluateRequirements({cells[4], split(cells[5], ' '), true, capabilities.essl320, limit});
        phones.push_back(phone);
    }
    return phones;
}

// The number of phones by the finest grid that a preset runs at, 0 where it does not run.
std::map<int, int> phonesByGrid(const std::string& preset) {
    std::map<int, int> count;
    for (const Phone& phone : phones()) {
        const std::vector<gl::Requirement>& rows = phone.capabilities.requirements;
        const std::vector<int> grids = possibleGrids(presetSettings(preset), phone.capabilities,
                                                     std::numeric_limits<std::size_t>::max());
        const bool runs = std::none_of(rows.begin(), rows.end(),
                                       [](const gl::Requirement& row) { return row.required && !row.met; });
        ++count[runs && !grids.empty() ? grids.back() : 0];
    }
    return count;
}

// A requirement that grows shuts phones out.
TEST(Phones, RunEachPresetUpToTheGridThatDocsPhoneMdStates) {
    using Count = std::map<int, int>;
    EXPECT_EQ(phonesByGrid("thesis"), (Count{{0, 4}, {512, 73}}));
    EXPECT_EQ(phonesByGrid("mobile"), (Count{{0, 13}, {512, 64}}));
    EXPECT_EQ(phonesByGrid("quality"), (Count{{0, 13}, {512, 64}}));
}

TEST(Phones, WithWrongDerivativesAreToldToUseThePresetThesis) {
    int told = 0;
    for (const Phone& phone : phones()) {
        if (phone.capabilities.faults.derivatives.empty()) continue;
        expectMentions(errorOf([&] { requireNeeds(presetSettings("mobile"), phone.capabilities); }),
                       {"PowerVR Rogue before driver 1.16", "use the preset thesis"});
        EXPECT_NO_THROW(requireNeeds(presetSettings("thesis"), phone.capabilities)) << phone.gpu;
        ++told;
    }
    EXPECT_GT(told, 0);
}

TEST(DriverNeeds, EachIsNamedWhereALimitIsOneTooSmall) {
    Settings mobile = presetSettings("mobile"), finest = presetSettings("quality"),
             thesis = presetSettings("thesis"), nested = presetSettings("mobile");
    nested.cascades = 2;
    nested.shadowMapSize = 2048;
    mobile.size = glm::ivec2(640, 2340);
    finest.grid = 512;
    thesis.grid = 512;
    thesis.shadowMapSize = 4096;
    gl::Capabilities enough;
    enough.limits = {4096, 1024, 2048, 3};
    for (const Settings& settings : {mobile, finest, thesis, nested})
        EXPECT_NO_THROW(requireNeeds(settings, enough));
    const struct {
        const Settings& settings;
        int gl::Limits::* limit;
        int least;
        const char* name;
    } needs[] = {
        {mobile, &gl::Limits::texture3d, 64, "GL_MAX_3D_TEXTURE_SIZE >= 64"},
        {finest, &gl::Limits::texture3d, 512, "GL_MAX_3D_TEXTURE_SIZE >= 512"},
        {thesis, &gl::Limits::texture3d, 512, "GL_MAX_3D_TEXTURE_SIZE >= 512"},
        {mobile, &gl::Limits::framebufferWidth, 128, "GL_MAX_FRAMEBUFFER_WIDTH >= 128"},
        {thesis, &gl::Limits::framebufferWidth, 512, "GL_MAX_FRAMEBUFFER_WIDTH >= 512"},
        {mobile, &gl::Limits::texture2d, 2340, "GL_MAX_TEXTURE_SIZE >= 2340"},
        {thesis, &gl::Limits::texture2d, 4096, "GL_MAX_TEXTURE_SIZE >= 4096"},
        {nested, &gl::Limits::texture2d, 4096, "GL_MAX_TEXTURE_SIZE >= 4096"},
        {mobile, &gl::Limits::fragmentStorageBlocks, 3, "GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS >= 3"},
    };
    for (const auto& need : needs) {
        gl::Capabilities capabilities = enough;
        capabilities.limits.*need.limit = need.least;
        EXPECT_NO_THROW(requireNeeds(need.settings, capabilities)) << need.name;
        capabilities.limits.*need.limit = need.least - 1;
        expectMentions(errorOf([&] { requireNeeds(need.settings, capabilities); }), {need.name});
    }
}

}  // namespace
}  // namespace vct::test
