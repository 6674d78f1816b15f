#include "lab/shader_counters.h"

#include "core/error.h"
#include "gl/objects.h"
#include "lab/shader_loops.h"
#include "shared/layout.h"

namespace vct {

namespace {

constexpr std::size_t maxCounters = 1 << 14;

StageCount countOf(const std::string& shader, const CountedShader& counted,
                   const std::vector<std::uint32_t>& counts) {
    StageCount count{shader, counts[counted.invocations], {}};
    for (const ShaderLoop& loop : counted.loops)
        count.loops.push_back({loop, counts[loop.counter]});
    return count;
}

}  // namespace

struct ShaderCounters::Stages {
    struct Stage {
        gl::ProgramDescription program;
        std::string shader;
        CountedShader counted;
    };
    std::vector<Stage> all;
    std::size_t counterCount = 0;
};

ShaderCounters::ShaderCounters() : stages_(std::make_shared<Stages>()) {
    gl::ProgramHooks hooks;
    hooks.onSource = [stages = stages_](const gl::ProgramDescription& program, const std::string& shader,
                                        gl::AssembledShader& source) {
        const GLenum kind = gl::shaderStage(shader);
        if (kind != GL_FRAGMENT_SHADER && kind != GL_COMPUTE_SHADER) return;
        const CountedShader counted = countLoops(source, stages->counterCount);
        stages->counterCount += counted.counterCount;
        if (stages->counterCount > maxCounters)
            throw Error("the shaders have more than " + std::to_string(maxCounters) +
                        " loops; raise maxCounters in jni/lab/shader_counters.cpp");
        stages->all.push_back({program, shader, counted});
    };
    programs_ = std::make_shared<gl::ProgramCache>(std::move(hooks));
}

std::vector<ProgramCount> ShaderCounters::count(const std::function<void()>& frames) const {
    std::vector<std::uint32_t> counts(maxCounters);
    const std::size_t bytes = counts.size() * sizeof counts[0];
    const gl::Buffer counters("shader counters", GL_SHADER_STORAGE_BUFFER, bytes, counts.data(),
                              GL_DYNAMIC_COPY);
    counters.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_COUNTERS);
    frames();
    counters.read(counts.data(), bytes);

    std::vector<ProgramCount> found;
    for (const auto& [program, shader, counted] : stages_->all)
        if (counts[counted.invocations] > 0) found.push_back({program, countOf(shader, counted, counts)});
    return found;
}

}  // namespace vct
