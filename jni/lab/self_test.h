// Tests the driver: first the assumptions of driver_checks.h one by one, then every preset on a scene that is
// simple enough to know the exact result. Driver faults are frequent on phones.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "gl/capabilities.h"
#include "gl/shader_source.h"

namespace vct {

struct SelfTest {
    bool passed = false;
    std::string text;  // on success the comparison; on failure the cause, its place and the remedy
};

// Runs the test. Throws only gl::ContextLost; every other error is a failed test.
SelfTest runSelfTest(const gl::Capabilities& capabilities, const gl::ReadShader& shaders);

nlohmann::ordered_json selfTestJson(const SelfTest& result);

}  // namespace vct
