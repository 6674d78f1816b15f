// The self-test passes on every driver here, and fails if a shader is wrong as a driver could be.
#include <gtest/gtest.h>

#include "lab/self_test.h"
#include "platform/contexts.h"
#include "support/errors.h"
#include "support/renderers.h"

namespace vct::test {
namespace {

class SelfTestOn : public testing::TestWithParam<Backend> {};
INSTANTIATE_TEST_SUITE_P(Backends, SelfTestOn, testing::Values(Backend::egl, Backend::osmesa, Backend::zink),
                         [](const auto& test) { return std::string(backendName(test.param)); });

SelfTestResult runSelfTest(const gl::Capabilities& capabilities, const gl::ReadShader& shaders) {
    SelfTest test(capabilities, shaders, std::make_shared<gl::ProgramCache>());
    while (test.advance()) {
    }
    return test.result();
}

TEST_P(SelfTestOn, Passes) {
    VCT_SKIP_IF_ABSENT(GetParam());
    const Context context = openContext(GetParam());
    const SelfTestResult result = runSelfTest(context.capabilities, testShaders());
    EXPECT_TRUE(result.passed) << result.text;
    expectMentions(result.text, {"7 levels"});
}

// `from` in a shader becomes `to`, as if the driver computed that instead.
SelfTestResult withBrokenShader(const std::string& file, const std::string& from, const std::string& to) {
    const Context context = openContext(Backend::egl);
    bool found = false;
    const SelfTestResult result = runSelfTest(context.capabilities, [&](const std::string& path) {
        std::string text = testShaders()(path);
        const std::size_t at = path == file ? text.find(from) : std::string::npos;
        if (at != std::string::npos) {
            text.replace(at, from.size(), to);
            found = true;
        }
        return text;
    });
    EXPECT_TRUE(found) << file << " has no " << from;
    return result;
}

struct Broken {
    const char* name;
    const char *file, *from, *to;
    const char* says;
};
class SelfTestBroken : public testing::TestWithParam<Broken> {};
INSTANTIATE_TEST_SUITE_P(
    Shaders, SelfTestBroken,
    testing::Values(Broken{"AtomicMaxThatKeepsTheLastFragment", "packed/voxelizer.frag",
                           "if (imageAtomicMax(voxels, voxel, word) == 0u)",
                           "if (imageAtomicExchange(voxels, voxel, word) == 0u)", "level 0"},
                    Broken{"IndirectDispatchWithTooFewGroups", "packed/mipmapper.comp",
                           "i < count; i += stride", "i < min(count, 64u); i += stride", "level 1"},
                    Broken{"ClearWithoutEffect", "packed/clear.comp", "void main() {",
                           "void main() { if (level > 0u) return;", "second frame"},
                    Broken{"FragmentsWhoseAtomicsAreLost", "lab/check_atomics.frag",
                           "atomicAdd(words[0], pixel);", "words[0] += pixel;",
                           "atomics on storage buffers from fragments"},
                    Broken{"ImageAtomicsThatAreLost", "lab/check_image_atomics.frag",
                           "if (imageAtomicMax(image, texel + ivec3(4, 0, 0), turn + 1u) == 0u)",
                           "if (imageAtomicExchange(image, texel + ivec3(4, 0, 0), 7u) == 0u)",
                           "atomics of fragments on a 3D image: 64 of 64 texels"},
                    Broken{"ImageAtomicsThatReturnNothing", "lab/check_image_atomics.frag",
                           "if (imageAtomicOr(image, texel, 1u << (turn & 31u)) == 0u)",
                           "if (imageAtomicOr(image, texel, 1u << (turn & 31u)) == 5u)",
                           "use a newer driver"},
                    Broken{"SwapsThatNeverSucceed", "lab/check_image_swaps.comp", "if (found == before)",
                           "if (found == before + 1u)", "compare-and-swap on a 3D image"},
                    Broken{"SharedAtomicsThatAreLost", "lab/check_shared_atomics.comp",
                           "atomicAdd(sum, index);", "sum += index;", "atomics on shared variables"},
                    Broken{"DerivativesOfHalfSize", "lab/check_derivatives.frag", "dFdx(position)",
                           "0.5 * dFdx(position)", "derivatives"},
                    Broken{"SamplesThatAreNotCounted", "lab/check_samples.frag", "gl_SampleMaskIn[0]",
                           "gl_SampleMaskIn[0] & 1", "gl_SampleMaskIn"},
                    Broken{"ClearsThatMissASlice", "lab/check_filtered.comp", "VCT_CHECK_CLEARED ? vec4(0.0)",
                           "VCT_CHECK_CLEARED ? vec4(0.0, 0.0, 0.0, 0.2)", "clears of the slices"},
                    Broken{"CoverageThatIsLost", "directional/coverage.glsl",
                           "if (isCovered(abs(coverage.y)))", "if (false)", "preset mobile: first frame"},
                    Broken{"FacesThatAreNotEmptied", "directional/clear_dynamic.comp", "void main() {",
                           "void main() { return;", "preset mobile: first frame"},
                    Broken{"ShaderThatDoesNotCompile", "packed/mipmapper.comp", "void main() {",
                           "void main() { nonsense;", "packed/mipmapper.comp"}),
    [](const auto& test) { return std::string(test.param.name); });

TEST_P(SelfTestBroken, FailsAndNamesTheFault) {
    const auto& [name, file, from, to, says] = GetParam();
    const SelfTestResult result = withBrokenShader(file, from, to);
    EXPECT_FALSE(result.passed);
    expectMentions(result.text, {says});
    const bool compiles = std::string(says).find(".comp") == std::string::npos;
    if (compiles) expectMentions(result.text, {"use "});
}

}  // namespace
}  // namespace vct::test
