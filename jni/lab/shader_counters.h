// Counts how often the shaders of frames and their loops run. The shaders themselves count
// (lab/shader_loops.h).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "gl/program.h"
#include "lab/shader_loops.h"

namespace vct {

struct LoopCount : ShaderLoop {
    std::uint32_t iterations;  // begun ones, by all calls of the loop's function together
};

struct StageCount {
    std::string shader;  // "passes/shade.frag"
    std::uint32_t invocations;
    std::vector<LoopCount> loops;  // in the order in which they run; a nested loop after the one around it
};

struct ProgramCount {
    gl::ProgramDescription program;
    StageCount stage;  // the fragment or the compute shader
};

class ShaderCounters {
  public:
    ShaderCounters();

    // The cache for a renderer whose shaders count. They are slower than others.
    std::shared_ptr<gl::ProgramCache> programs() const { return programs_; }

    // Counts what `frames` draws, by a renderer with the programs of programs(). Fragments are counted before
    // the depth test. Returns the programs that ran.
    std::vector<ProgramCount> count(const std::function<void()>& frames) const;

  private:
    struct Stages;
    std::shared_ptr<Stages> stages_;  // of all programs that were linked
    std::shared_ptr<gl::ProgramCache> programs_;
};

}  // namespace vct
