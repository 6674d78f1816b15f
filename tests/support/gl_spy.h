// Watches one entry point of GL, for tests of what the renderer asks of a driver.
#pragma once

#include <functional>
#include <utility>

#include "gl/api.h"

namespace vct::test {

// While `const GlSpy<&gl::Finish> finishes([&] { ++count; });` lives, each call of that entry point calls the
// function first. One at a time for each entry point; gl::load() must have run.
template <auto* entry>
class GlSpy;

template <typename Result, typename... Arguments, Result(GL_APIENTRY** entry)(Arguments...)>
class GlSpy<entry> {
  public:
    explicit GlSpy(std::function<void(Arguments...)> before) {
        before_ = std::move(before);
        driver_ = std::exchange(*entry, call);
    }
    ~GlSpy() { *entry = driver_; }
    GlSpy(const GlSpy&) = delete;
    GlSpy& operator=(const GlSpy&) = delete;

  private:
    static Result GL_APIENTRY call(Arguments... arguments) {
        before_(arguments...);
        return driver_(arguments...);
    }
    static inline std::function<void(Arguments...)> before_;
    static inline Result(GL_APIENTRY* driver_)(Arguments...) = nullptr;
};

}  // namespace vct::test
