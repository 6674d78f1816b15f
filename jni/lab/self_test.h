// Whether this driver can be trusted: the assumptions of driver_checks.h one by one, and then every preset on
// a scene small and simple enough to be known exactly. Drivers are wrong more often than one thinks.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "gl/capabilities.h"
#include "gl/shader_source.h"

namespace vct {

struct SelfTest {
    bool passed = false;
    std::string text;  // what was compared, or what is wrong, where, and what to do
};

// Throws gl::ContextLost only; every other error is a failed test.
SelfTest runSelfTest(const gl::Capabilities& capabilities, const gl::ReadShader& shaders);

nlohmann::ordered_json selfTestJson(const SelfTest& result);

}  // namespace vct
