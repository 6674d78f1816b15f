#include "engine/directional/block_scissor.h"

#include "gl/api.h"

namespace vct {

namespace {

void scissor(const glm::ivec4& pixels) {
    gl::Scissor(pixels.x, pixels.y, pixels.z - pixels.x, pixels.w - pixels.y);
}

}  // namespace

BlockScissor::BlockScissor(const BlockMask& blocks, const glm::ivec4& viewport) {
    const Bounds box = blocks.box();
    const double side = viewport.z;
    const glm::dvec3 first = glm::floor(glm::clamp(box.min, 0.0, 1.0) * side);
    const glm::dvec3 end = glm::max(glm::ceil(glm::clamp(box.max, 0.0, 1.0) * side), first);
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        pixels_[static_cast<std::size_t>(axis)] = glm::ivec4(viewport.x, viewport.y, viewport.x, viewport.y) +
                                                  glm::ivec4(glm::dvec4(first[u], first[v], end[u], end[v]));
    }
    gl::Enable(GL_SCISSOR_TEST);
}

BlockScissor::~BlockScissor() {
    gl::Disable(GL_SCISSOR_TEST);
}

void BlockScissor::along(std::size_t axis) const {
    scissor(pixels_[axis]);
}

void BlockScissor::alongAnyAxis() const {
    const auto& [x, y, z] = pixels_;
    const glm::ivec4 first = glm::min(glm::min(x, y), z), end = glm::max(glm::max(x, y), z);
    scissor({first.x, first.y, end.z, end.w});
}

}  // namespace vct
