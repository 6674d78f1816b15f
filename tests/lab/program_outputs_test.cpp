// The outputs that the programs declare equal the limits that are required of a driver. With a lower
// requirement a phone might not link a program.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "gl/program.h"
#include "gl/requirements.h"
#include "lab/program_list.h"
#include "support/renderers.h"

namespace vct::test {
namespace {

// Active resources of a program.
struct Outputs {
    int images = 0, storageBlocks = 0, colours = 0;
    int combined() const { return images + storageBlocks + colours; }
};

class ProgramInterface {
  public:
    explicit ProgramInterface(const Platform& platform) {
        const auto get = [&](auto& entry, const char* name) {
            entry = reinterpret_cast<std::decay_t<decltype(entry)>>(platform.getProcAddress(name));
        };
        get(interface_, "glGetProgramInterfaceiv");
        get(resource_, "glGetProgramResourceiv");
    }
    Outputs of(const gl::Program& program) const {
        program.use();
        GLint name = 0;
        gl::GetIntegerv(GL_CURRENT_PROGRAM, &name);
        const auto id = static_cast<GLuint>(name);
        const auto count = [&](GLenum what) {
            GLint found = 0;
            interface_(id, what, GL_ACTIVE_RESOURCES, &found);
            return found;
        };
        Outputs outputs{0, count(GL_SHADER_STORAGE_BLOCK), 0};
        for (GLint i = 0; i < count(GL_UNIFORM); ++i) {
            const GLenum property = GL_TYPE;
            GLint type = 0;
            resource_(id, GL_UNIFORM, static_cast<GLuint>(i), 1, &property, 1, nullptr, &type);
            outputs.images += type == GL_IMAGE_3D || type == GL_UNSIGNED_INT_IMAGE_3D;
        }
        const GLenum stage = GL_REFERENCED_BY_FRAGMENT_SHADER;
        for (GLint i = 0; i < count(GL_PROGRAM_OUTPUT); ++i) {
            GLint fragment = 0;
            resource_(id, GL_PROGRAM_OUTPUT, static_cast<GLuint>(i), 1, &stage, 1, nullptr, &fragment);
            outputs.colours += fragment != 0;
        }
        return outputs;
    }

  private:
    PFNGLGETPROGRAMINTERFACEIVPROC interface_;
    PFNGLGETPROGRAMRESOURCEIVPROC resource_;
};

// The programs of everyProgram() whose defines are not a part of another's with the same shaders: a define
// adds outputs and removes none.
std::vector<gl::ProgramDescription> largestPrograms() {
    std::vector<gl::ProgramDescription> programs = everyProgram();
    std::map<std::vector<std::string>, std::vector<std::set<std::string>>> defines;
    const auto definesOf = [](const gl::ProgramDescription& program) {
        return std::set<std::string>(program.defines.begin(), program.defines.end());
    };
    for (const gl::ProgramDescription& program : programs)
        defines[program.shaders].push_back(definesOf(program));
    const auto isPart = [&](const gl::ProgramDescription& program) {
        const std::set<std::string> own = definesOf(program);
        const auto& all = defines[program.shaders];
        return std::any_of(all.begin(), all.end(), [&](const std::set<std::string>& other) {
            return other.size() > own.size() &&
                   std::includes(other.begin(), other.end(), own.begin(), own.end());
        });
    };
    programs.erase(std::remove_if(programs.begin(), programs.end(), isPart), programs.end());
    return programs;
}

TEST(ProgramOutputs, EqualTheRequirementsAndAreAtMostSeven) {
    const Context context = openContext(Backend::egl);
    const ProgramInterface interface(*context.platform);
    const gl::ShaderLibrary shaders{testShaders(), context.capabilities.language()};
    std::map<std::string, int> most;
    const auto note = [&](const std::string& what, int count) { most[what] = std::max(most[what], count); };
    for (const gl::ProgramDescription& description : largestPrograms()) {
        const Outputs outputs = interface.of(gl::Program(shaders, description));
        const bool compute = description.shaders.size() == 1;
        // A PowerVR Rogue has eight, and according to ANGLE other drivers report too many.
        EXPECT_LE(outputs.combined(), 7) << description.name;
        note("combined", outputs.combined());
        note(compute ? "compute images" : "fragment images", outputs.images);
        note(compute ? "compute storage blocks" : "fragment storage blocks", outputs.storageBlocks);
        note("colours", outputs.colours);
    }
    const std::map<std::string, std::string> rows{
        {"combined", "GL_MAX_COMBINED_SHADER_OUTPUT_RESOURCES"},
        {"compute images", "GL_MAX_COMPUTE_IMAGE_UNIFORMS"},
        {"fragment images", "GL_MAX_FRAGMENT_IMAGE_UNIFORMS"},
        {"compute storage blocks", "GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS"},
        {"fragment storage blocks", "GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS"},
        {"colours", "GL_MAX_COLOR_ATTACHMENTS"},
    };
    for (const auto& [what, row] : rows) {
        int asked = 0;
        for (const gl::Requirement& requirement : context.capabilities.requirements)
            if (requirement.name.find(row + " >= ") == 0)
                asked = std::max(asked, std::stoi(requirement.name.substr(row.size() + 4)));
        EXPECT_EQ(most[what], asked) << what;
    }
}

}  // namespace
}  // namespace vct::test
