#include "lab/driver_checks.h"

#include <array>
#include <cstdint>
#include <functional>

#include "gl/debug.h"
#include "gl/objects.h"
#include "gl/render_pass.h"

namespace vct {

namespace {

constexpr int checkPixels = 64, checkFragments = checkPixels * checkPixels;
constexpr int checkTexels = 64;                // of an image in which invocations meet
constexpr int checkSide = 8, checkLevels = 3;  // a level of one texel has no position between texels
constexpr std::size_t groupWords = 4, checkWords = 64, countedWord = 63;

gl::ProgramDescription atomicsProgram() {
    return {"check atomics", {"passes/full_screen.vert", "lab/check_atomics.frag"}, {}};
}
gl::ProgramDescription derivativesProgram() {
    return {"check derivatives", {"passes/full_screen.vert", "lab/check_derivatives.frag"}, {}};
}
gl::ProgramDescription samplesProgram() {
    return {"check samples", {"passes/full_screen.vert", "lab/check_samples.frag"}, {}};
}
gl::ProgramDescription fillProgram(GLenum format) {
    return {"check fill",
            {"lab/check_fill.comp"},
            {format == GL_RGBA8 ? "VCT_CHECK_FORMAT rgba8" : "VCT_CHECK_FORMAT rgba16f"}};
}
gl::ProgramDescription filteredProgram(bool cleared) {
    return {"check filtered",
            {"lab/check_filtered.comp"},
            {cleared ? "VCT_CHECK_CLEARED true" : "VCT_CHECK_CLEARED false"}};
}
gl::ProgramDescription imageAtomicsProgram() {
    return {"check image atomics", {"passes/full_screen.vert", "lab/check_image_atomics.frag"}, {}};
}
gl::ProgramDescription imageSwapsProgram() {
    return {"check image swaps", {"lab/check_image_swaps.comp"}, {}};
}
gl::ProgramDescription imageValuesProgram(bool swaps) {
    return {"check image values",
            {"lab/check_image_values.comp"},
            {swaps ? "VCT_CHECK_SWAPS true" : "VCT_CHECK_SWAPS false"}};
}
gl::ProgramDescription sharedAtomicsProgram() {
    return {"check shared atomics", {"lab/check_shared_atomics.comp"}, {}};
}
gl::ProgramDescription countProgram() {
    return {"check count", {"lab/check_count.comp"}, {}};
}

class Checks {
  public:
    explicit Checks(const gl::ShaderLibrary& shaders)
        : shaders_(shaders),
          count_(shaders, countProgram()),
          framebuffer_("driver check", checkPixels, checkPixels) {}

    std::string atomics() {
        return check([&] { draw(atomicsProgram(), framebuffer_); }, checkFragments / 64,
                     [&](const auto& found) -> std::string {
                         const std::uint32_t sum = checkFragments * (checkFragments - 1) / 2;
                         if (found[0] != sum || found[1] != checkFragments - 1 || found[2] != 0xFFFFFFFFU ||
                             found[3] != checkFragments || found[4] != sum)
                             return "atomics on storage buffers from fragments: sum " +
                                    std::to_string(found[0]) + ", maximum " + std::to_string(found[1]) +
                                    ", bits " + std::to_string(found[2]) + ", count " +
                                    std::to_string(found[3]) + ", sum of returned values " +
                                    std::to_string(found[4]) + "; expected " + std::to_string(sum) + ", " +
                                    std::to_string(checkFragments - 1) + ", " + std::to_string(0xFFFFFFFFU) +
                                    ", " + std::to_string(checkFragments) + ", " + std::to_string(sum);
                         return "";
                     });
    }

    std::string derivatives() {
        return check([&] { draw(derivativesProgram(), framebuffer_); }, 0,
                     [&](const auto& found) -> std::string {
                         if (found[0] == 0 && found[1] == checkFragments) return "";
                         return "derivatives (dFdx, dFdy): wrong in " + std::to_string(found[0]) + " of " +
                                std::to_string(found[1]) + " fragments; expected 0 of " +
                                std::to_string(checkFragments);
                     });
    }

    std::string samples() {
        constexpr std::uint32_t samples = 4 * checkFragments;
        const gl::Framebuffer target("driver check of samples", checkPixels, checkPixels, 4);
        return check([&] { draw(samplesProgram(), target); }, 0,
                     [&](const auto& found) -> std::string {
                         if (found[0] == samples) return "";
                         return "samples that a triangle covers (gl_SampleMaskIn): " +
                                std::to_string(found[0]) + ", expected " + std::to_string(samples);
                     });
    }

    // Checks stores to the levels of a filtered 3D texture, and then clearing the levels by a framebuffer.
    std::string levelsOf(GLenum format) {
        const std::string name = format == GL_RGBA8 ? "rgba8" : "rgba16f";
        const gl::Texture texture =
            gl::Texture::make3d("check " + name, format, checkSide, checkSide, checkSide, checkLevels);
        texture.setFilter(GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR);
        const gl::Program fill(shaders_, fillProgram(format));
        const std::string stores = check(
            [&] {
                fill.use();
                for (int level = 0; level < checkLevels; ++level) {
                    texture.bindImage(0, level, GL_WRITE_ONLY);
                    gl::Uniform1ui(0, static_cast<GLuint>(level));
                    gl::DispatchCompute(2, 2, 2);
                }
                gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
                sample(texture, false);
            },
            checkLevels, wrongLevels("stores to the levels of a filtered 3D texture (" + name + ")"));
        if (!stores.empty()) return stores;
        // The framebuffer overwrites texels that compute shaders wrote.
        gl::MemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT);
        gl::clearTexture3d(texture, checkSide);
        return check([&] { sample(texture, true); }, checkLevels,
                     wrongLevels("clears of the slices of a 3D texture (" + name + ")"));
    }

    std::string imageAtomics() {
        return checkImage("atomics of fragments on a 3D image", false, 3 * checkTexels,
                          [&] { draw(imageAtomicsProgram(), framebuffer_); });
    }
    std::string imageSwaps() {
        const gl::Program swaps(shaders_, imageSwapsProgram());
        return checkImage("compare-and-swap on a 3D image", true, checkTexels, [&] {
            swaps.use();
            gl::DispatchCompute(checkFragments / checkTexels, 1, 1);
        });
    }

    std::string sharedAtomics() {
        const gl::Program atomics(shaders_, sharedAtomicsProgram());
        constexpr std::uint32_t groups = 16;
        return check(
            [&] {
                atomics.use();
                gl::DispatchCompute(groups, 1, 1);
            },
            groups,
            [&](const auto& found) -> std::string {
                if (found[0] == groups && found[1] == 0) return "";
                return "atomics on shared variables: wrong in " + std::to_string(found[1]) + " of " +
                       std::to_string(found[0]) + " work groups; expected 0 of " + std::to_string(groups);
            });
    }

  private:
    // Runs `work` on a cleared image. `firsts`: the number of its operations that must find a texel empty.
    template <typename Work>
    std::string checkImage(const std::string& what, bool swaps, std::uint32_t firsts,
                           const Work& work) const {
        const gl::Texture image =
            gl::Texture::make3d("check " + what, GL_R32UI, checkSide, checkSide, checkSide, 1);
        const gl::Program values(shaders_, imageValuesProgram(swaps));
        gl::clearTexture3d(image, checkSide);
        return check(
            [&] {
                image.bindImage(0, 0, GL_READ_WRITE);
                work();
                gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
                values.use();
                gl::DispatchCompute(1, 1, 1);
            },
            1,
            [&](const auto& found) -> std::string {
                if (found[0] == 0 && found[1] == firsts) return "";
                return what + ": " + std::to_string(found[0]) + " of " + std::to_string(checkTexels) +
                       " texels are wrong, and " + std::to_string(found[1]) +
                       " operations found an empty texel; expected 0 and " + std::to_string(firsts);
            });
    }

    using Words = std::array<std::uint32_t, groupWords + checkWords>;

    static std::function<std::string(const std::uint32_t*)> wrongLevels(const std::string& what) {
        return [what](const std::uint32_t* found) -> std::string {
            for (int level = 0; level < checkLevels; ++level)
                if (found[level] != 0)
                    return what + ": wrong in level " + std::to_string(level) + " at " +
                           std::to_string(found[level]) + " texels";
            return "";
        };
    }

    void draw(const gl::ProgramDescription& description, const gl::Framebuffer& target) const {
        const gl::Program program(shaders_, description);
        const gl::RenderPass pass(target);
        program.use();
        noVertices_.bind();
        gl::DrawArrays(GL_TRIANGLES, 0, 3);
    }

    void sample(const gl::Texture& texture, bool cleared) const {
        const gl::Program filtered(shaders_, filteredProgram(cleared));
        filtered.use();
        texture.bind(0);
        for (int level = 0; level < checkLevels; ++level) {
            gl::Uniform1ui(0, static_cast<GLuint>(level));
            gl::DispatchCompute(1, 1, 1);
        }
    }

    // Runs `work`, then an indirect dispatch with the number of groups that it wrote. `wrong` checks the
    // words that it wrote and returns an error text or "".
    template <typename Work, typename Wrong>
    std::string check(const Work& work, std::uint32_t groups, const Wrong& wrong) const {
        Words found{};
        found[1] = found[2] = 1;  // groups along y and z
        const gl::Buffer buffer("driver check", GL_SHADER_STORAGE_BUFFER, sizeof found, found.data(),
                                GL_DYNAMIC_COPY);
        buffer.bindBase(GL_SHADER_STORAGE_BUFFER, 0);
        work();
        gl::MemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
        count_.use();
        buffer.bind(GL_DISPATCH_INDIRECT_BUFFER);
        gl::DispatchComputeIndirect(0);
        buffer.read(found.data(), sizeof found);
        gl::checkErrors("driver check");
        if (const std::string text = wrong(found.data() + groupWords); !text.empty()) return text;
        const std::uint32_t invocations = found[groupWords + countedWord];
        if (invocations == 64 * groups) return "";
        return "indirect dispatch of a size that shaders wrote: " + std::to_string(invocations) +
               " invocations, expected " + std::to_string(64 * groups);
    }

    const gl::ShaderLibrary& shaders_;
    gl::Program count_;
    gl::Framebuffer framebuffer_;
    gl::VertexArray noVertices_;
};

}  // namespace

std::vector<DriverCheck> driverChecks(int pixelSamples) {
    using Shaders = const gl::ShaderLibrary&;
    std::vector<DriverCheck> all{{[](Shaders shaders) { return Checks(shaders).imageAtomics(); }, true},
                                 {[](Shaders shaders) { return Checks(shaders).atomics(); }},
                                 {[](Shaders shaders) { return Checks(shaders).imageSwaps(); }},
                                 {[](Shaders shaders) { return Checks(shaders).sharedAtomics(); }},
                                 {[](Shaders shaders) { return Checks(shaders).derivatives(); }},
                                 {[](Shaders shaders) { return Checks(shaders).levelsOf(GL_RGBA8); }},
                                 {[](Shaders shaders) { return Checks(shaders).levelsOf(GL_RGBA16F); }}};
    if (pixelSamples > 1) all.push_back({[](Shaders shaders) { return Checks(shaders).samples(); }});
    return all;
}

std::vector<gl::ProgramDescription> driverCheckPrograms() {
    return {
        imageAtomicsProgram(),   imageValuesProgram(false), imageSwapsProgram(),    imageValuesProgram(true),
        sharedAtomicsProgram(),  atomicsProgram(),          derivativesProgram(),   fillProgram(GL_RGBA8),
        fillProgram(GL_RGBA16F), filteredProgram(true),     filteredProgram(false), samplesProgram(),
        countProgram()};
}

}  // namespace vct
