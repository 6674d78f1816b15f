// Tests the driver: first the assumptions of driver_checks.h one by one, then every preset on a scene that is
// simple enough to know the exact result. Driver faults are frequent on phones.
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gl/capabilities.h"
#include "gl/program.h"

namespace vct {

struct SelfTestResult {
    bool passed = false;
    std::string text;  // on success the comparison; on failure the cause, its place and the remedy
};

// The test in small parts, so that an app can show frames and handle events in between. A driver may take a
// tenth of a second to compile a program, when it is linked or when it is first used. Therefore each part
// ends before the second program that is new; the next part begins the same check from its start and gets one
// program further.
class SelfTest {
  public:
    SelfTest(const gl::Capabilities& capabilities, const gl::ReadShader& shaders,
             std::shared_ptr<gl::ProgramCache> programs);
    SelfTest(const SelfTest&) = delete;
    SelfTest& operator=(const SelfTest&) = delete;

    // Runs the next part. Returns false once there is a result. Throws only gl::ContextLost; every other
    // error is a failed test.
    bool advance();
    const SelfTestResult& result() const { return result_.value(); }

    std::string progress() const;  // "preset mobile (6 of 7 checks), 31 programs"

  private:
    struct Check {
        std::string place;                 // for messages: "driver", "preset mobile"
        std::function<std::string()> run;  // returns an error text or ""
        std::string remedy;                // follows the error text
    };

    std::shared_ptr<gl::ProgramCache> programs_;
    std::vector<Check> checks_;
    std::size_t check_ = 0;
    int newPrograms_ = 0;
    std::size_t packedVoxels_ = 0;  // of the preset thesis
    std::string notTested_;         // says which presets the driver cannot run
    std::optional<SelfTestResult> result_;
};

nlohmann::ordered_json selfTestJson(const SelfTestResult& result);

}  // namespace vct
