// Some drivers forget the element buffer of a vertex array, so it is bound again after each bind of the
// array.
#pragma once

#include <gtest/gtest.h>

#include "support/gl_spy.h"

namespace vct::test {

// Expects an element buffer to be bound after the vertex array wherever one is used.
class ElementBufferCheck {
  public:
    int uses = 0;

  private:
    void use() {
        ++uses;
        EXPECT_TRUE(isBound_) << "use " << uses;
    }
    bool isBound_ = false;
    const GlSpy<&gl::BindVertexArray> arrays_{[this](GLuint) { isBound_ = false; }};
    const GlSpy<&gl::BindBuffer> buffers_{
        [this](GLenum target, GLuint) { isBound_ |= target == GL_ELEMENT_ARRAY_BUFFER; }};
    const GlSpy<&gl::BufferData> uploads_{[this](GLenum target, GLsizeiptr, const void*, GLenum) {
        if (target == GL_ELEMENT_ARRAY_BUFFER) use();
    }};
    const GlSpy<&gl::DrawElements> draws_{[this](GLenum, GLsizei, GLenum, const void*) { use(); }};
};

}  // namespace vct::test
