// The render passes in a log of GL calls, as a tile-based GPU sees them: each begins when a framebuffer is
// bound and ends when another one is.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "gl/call_log.h"

namespace vct::test {

struct RenderPasses {
    int count = 0;  // passes that draw into attachments
    // "G-buffer: depth" for each attachment that a pass draws into without having cleared or invalidated all
    // of it.
    std::set<std::string> loaded;
    // The same for each attachment that a pass leaves in memory although nothing in the log samples it.
    std::set<std::string> unread;
};

// The log must begin before the framebuffers are made. Those made earlier are left out, except the window's.
// `outputs`: textures that are read after the log.
RenderPasses renderPassesOf(const std::vector<gl::Call>& calls, const std::set<std::int64_t>& outputs = {});

}  // namespace vct::test
