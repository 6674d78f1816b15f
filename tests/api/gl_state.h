// GL's state, read from the driver, to compare it before and after a call.
#pragma once

#include <EGL/egl.h>

#include <map>
#include <string>
#include <vector>

#include "gl/objects.h"

namespace vct::test {

using GlState = std::map<std::string, std::vector<double>>;

template <class Function>
Function entryPoint(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}
// An entry point that gl/api.h does not have.
#define VCT_ENTRY_POINT(NAME) ::vct::test::entryPoint<decltype(&::gl##NAME)>("gl" #NAME)

// A buffer binding point with an index: how many there are, and the names of its three queries.
struct IndexedTarget {
    const char* name;
    GLenum target, limit, binding, start, size;
};
inline const std::vector<IndexedTarget>& indexedTargets() {
    static const std::vector<IndexedTarget> targets{
        {"uniform buffer", GL_UNIFORM_BUFFER, GL_MAX_UNIFORM_BUFFER_BINDINGS, GL_UNIFORM_BUFFER_BINDING,
         GL_UNIFORM_BUFFER_START, GL_UNIFORM_BUFFER_SIZE},
        {"storage buffer", GL_SHADER_STORAGE_BUFFER, GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS,
         GL_SHADER_STORAGE_BUFFER_BINDING, GL_SHADER_STORAGE_BUFFER_START, GL_SHADER_STORAGE_BUFFER_SIZE},
        {"atomic counter buffer", GL_ATOMIC_COUNTER_BUFFER, GL_MAX_ATOMIC_COUNTER_BUFFER_BINDINGS,
         GL_ATOMIC_COUNTER_BUFFER_BINDING, GL_ATOMIC_COUNTER_BUFFER_START, GL_ATOMIC_COUNTER_BUFFER_SIZE},
        {"transform feedback buffer", GL_TRANSFORM_FEEDBACK_BUFFER,
         GL_MAX_TRANSFORM_FEEDBACK_SEPARATE_ATTRIBS, GL_TRANSFORM_FEEDBACK_BUFFER_BINDING,
         GL_TRANSFORM_FEEDBACK_BUFFER_START, GL_TRANSFORM_FEEDBACK_BUFFER_SIZE}};
    return targets;
}

struct TextureTarget {
    GLenum target, binding;
};
inline const std::vector<TextureTarget>& textureTargets() {
    static const std::vector<TextureTarget> targets{
        {GL_TEXTURE_2D, GL_TEXTURE_BINDING_2D},
        {GL_TEXTURE_3D, GL_TEXTURE_BINDING_3D},
        {GL_TEXTURE_2D_ARRAY, GL_TEXTURE_BINDING_2D_ARRAY},
        {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_BINDING_CUBE_MAP},
        {GL_TEXTURE_2D_MULTISAMPLE, GL_TEXTURE_BINDING_2D_MULTISAMPLE},
        {GL_TEXTURE_2D_MULTISAMPLE_ARRAY, GL_TEXTURE_BINDING_2D_MULTISAMPLE_ARRAY},
        {GL_TEXTURE_BUFFER, GL_TEXTURE_BINDING_BUFFER},
        {GL_TEXTURE_CUBE_MAP_ARRAY, GL_TEXTURE_BINDING_CUBE_MAP_ARRAY}};
    return targets;
}

struct NamedState {
    const char* name;
    GLenum value;
};
#define VCT_STATE(NAME) {#NAME, NAME}

inline const std::vector<NamedState>& glSwitches() {
    static const std::vector<NamedState> names{VCT_STATE(GL_BLEND),
                                               VCT_STATE(GL_CULL_FACE),
                                               VCT_STATE(GL_DEPTH_TEST),
                                               VCT_STATE(GL_DITHER),
                                               VCT_STATE(GL_POLYGON_OFFSET_FILL),
                                               VCT_STATE(GL_PRIMITIVE_RESTART_FIXED_INDEX),
                                               VCT_STATE(GL_RASTERIZER_DISCARD),
                                               VCT_STATE(GL_SAMPLE_ALPHA_TO_COVERAGE),
                                               VCT_STATE(GL_SAMPLE_COVERAGE),
                                               VCT_STATE(GL_SAMPLE_MASK),
                                               VCT_STATE(GL_SAMPLE_SHADING),
                                               VCT_STATE(GL_SCISSOR_TEST),
                                               VCT_STATE(GL_STENCIL_TEST)};
    return names;
}

inline const std::vector<NamedState>& glScalars() {
    static const std::vector<NamedState> names{
        // Bindings
        VCT_STATE(GL_ACTIVE_TEXTURE), VCT_STATE(GL_ARRAY_BUFFER_BINDING),
        VCT_STATE(GL_ATOMIC_COUNTER_BUFFER_BINDING), VCT_STATE(GL_COPY_READ_BUFFER_BINDING),
        VCT_STATE(GL_COPY_WRITE_BUFFER_BINDING), VCT_STATE(GL_CURRENT_PROGRAM),
        VCT_STATE(GL_DISPATCH_INDIRECT_BUFFER_BINDING), VCT_STATE(GL_DRAW_FRAMEBUFFER_BINDING),
        VCT_STATE(GL_DRAW_INDIRECT_BUFFER_BINDING), VCT_STATE(GL_ELEMENT_ARRAY_BUFFER_BINDING),
        VCT_STATE(GL_PIXEL_PACK_BUFFER_BINDING), VCT_STATE(GL_PIXEL_UNPACK_BUFFER_BINDING),
        VCT_STATE(GL_PROGRAM_PIPELINE_BINDING), VCT_STATE(GL_READ_FRAMEBUFFER_BINDING),
        VCT_STATE(GL_RENDERBUFFER_BINDING), VCT_STATE(GL_SHADER_STORAGE_BUFFER_BINDING),
        VCT_STATE(GL_TEXTURE_BUFFER_BINDING), VCT_STATE(GL_TRANSFORM_FEEDBACK_ACTIVE),
        VCT_STATE(GL_TRANSFORM_FEEDBACK_BINDING), VCT_STATE(GL_TRANSFORM_FEEDBACK_BUFFER_BINDING),
        VCT_STATE(GL_TRANSFORM_FEEDBACK_PAUSED), VCT_STATE(GL_UNIFORM_BUFFER_BINDING),
        VCT_STATE(GL_VERTEX_ARRAY_BINDING),
        // Pixels in memory
        VCT_STATE(GL_PACK_ALIGNMENT), VCT_STATE(GL_PACK_ROW_LENGTH), VCT_STATE(GL_PACK_SKIP_PIXELS),
        VCT_STATE(GL_PACK_SKIP_ROWS), VCT_STATE(GL_UNPACK_ALIGNMENT), VCT_STATE(GL_UNPACK_IMAGE_HEIGHT),
        VCT_STATE(GL_UNPACK_ROW_LENGTH), VCT_STATE(GL_UNPACK_SKIP_IMAGES), VCT_STATE(GL_UNPACK_SKIP_PIXELS),
        VCT_STATE(GL_UNPACK_SKIP_ROWS),
        // Rasterization and tests
        VCT_STATE(GL_BLEND_DST_ALPHA), VCT_STATE(GL_BLEND_DST_RGB), VCT_STATE(GL_BLEND_EQUATION_ALPHA),
        VCT_STATE(GL_BLEND_EQUATION_RGB), VCT_STATE(GL_BLEND_SRC_ALPHA), VCT_STATE(GL_BLEND_SRC_RGB),
        VCT_STATE(GL_BLEND_COLOR), VCT_STATE(GL_CLIP_DEPTH_MODE_EXT), VCT_STATE(GL_CLIP_ORIGIN_EXT),
        VCT_STATE(GL_COLOR_CLEAR_VALUE), VCT_STATE(GL_COLOR_WRITEMASK), VCT_STATE(GL_CULL_FACE_MODE),
        VCT_STATE(GL_DEPTH_CLEAR_VALUE), VCT_STATE(GL_DEPTH_FUNC), VCT_STATE(GL_DEPTH_RANGE),
        VCT_STATE(GL_DEPTH_WRITEMASK), VCT_STATE(GL_FRONT_FACE), VCT_STATE(GL_LINE_WIDTH),
        VCT_STATE(GL_MIN_SAMPLE_SHADING_VALUE), VCT_STATE(GL_PATCH_VERTICES),
        VCT_STATE(GL_POLYGON_OFFSET_FACTOR), VCT_STATE(GL_POLYGON_OFFSET_UNITS),
        VCT_STATE(GL_PRIMITIVE_BOUNDING_BOX), VCT_STATE(GL_SAMPLE_COVERAGE_INVERT),
        VCT_STATE(GL_SAMPLE_COVERAGE_VALUE), VCT_STATE(GL_SCISSOR_BOX), VCT_STATE(GL_STENCIL_BACK_FAIL),
        VCT_STATE(GL_STENCIL_BACK_FUNC), VCT_STATE(GL_STENCIL_BACK_PASS_DEPTH_FAIL),
        VCT_STATE(GL_STENCIL_BACK_PASS_DEPTH_PASS), VCT_STATE(GL_STENCIL_BACK_REF),
        VCT_STATE(GL_STENCIL_BACK_VALUE_MASK), VCT_STATE(GL_STENCIL_BACK_WRITEMASK),
        VCT_STATE(GL_STENCIL_CLEAR_VALUE), VCT_STATE(GL_STENCIL_FAIL), VCT_STATE(GL_STENCIL_FUNC),
        VCT_STATE(GL_STENCIL_PASS_DEPTH_FAIL), VCT_STATE(GL_STENCIL_PASS_DEPTH_PASS),
        VCT_STATE(GL_STENCIL_REF), VCT_STATE(GL_STENCIL_VALUE_MASK), VCT_STATE(GL_STENCIL_WRITEMASK),
        VCT_STATE(GL_VIEWPORT),
        // Others
        VCT_STATE(GL_DEBUG_GROUP_STACK_DEPTH), VCT_STATE(GL_DEBUG_OUTPUT_SYNCHRONOUS),
        VCT_STATE(GL_FRAGMENT_SHADER_DERIVATIVE_HINT), VCT_STATE(GL_GENERATE_MIPMAP_HINT)};
    return names;
}
#undef VCT_STATE

// Reads all of it. State that the context does not know is left out.
inline GlState readGlState() {
    GlState state;
    const auto isEnabled = VCT_ENTRY_POINT(IsEnabled);
    const auto getInteger64i = VCT_ENTRY_POINT(GetInteger64i_v);
    const auto getVertexAttrib = VCT_ENTRY_POINT(GetVertexAttribfv);
    const auto limit = [](GLenum name) {
        GLint value = 0;
        gl::GetIntegerv(name, &value);
        return gl::GetError() == GL_NO_ERROR ? static_cast<GLuint>(value) : 0U;
    };
    // Floats cannot store all masks, and integers not all depths, so both are read.
    for (const auto& [name, value] : glScalars()) {
        GLfloat floats[8] = {};
        GLint integers[8] = {};
        gl::GetFloatv(value, floats);
        gl::GetIntegerv(value, integers);
        if (gl::GetError() != GL_NO_ERROR) continue;
        state[name].assign(floats, floats + 8);
        state[name].insert(state[name].end(), integers, integers + 8);
    }
    for (const auto& [name, value] : glSwitches()) {
        const bool on = isEnabled(value) != GL_FALSE;
        if (gl::GetError() == GL_NO_ERROR) state[name] = {on ? 1.0 : 0.0};
    }
    for (const IndexedTarget& target : indexedTargets())
        for (GLuint i = 0; i < limit(target.limit); ++i) {
            GLint buffer = 0;
            GLint64 start = 0, size = 0;
            gl::GetIntegeri_v(target.binding, i, &buffer);
            getInteger64i(target.start, i, &start);
            getInteger64i(target.size, i, &size);
            state[std::string(target.name) + " " + std::to_string(i)] = {
                double(buffer), static_cast<double>(start), static_cast<double>(size)};
        }
    const GLuint active = limit(GL_ACTIVE_TEXTURE);
    for (GLuint unit = 0; unit < limit(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS); ++unit) {
        gl::ActiveTexture(GL_TEXTURE0 + unit);
        std::vector<double>& textures = state["textures and sampler of unit " + std::to_string(unit)];
        for (const TextureTarget& target : textureTargets())
            textures.push_back(limit(target.binding));
        textures.push_back(limit(GL_SAMPLER_BINDING));
    }
    gl::ActiveTexture(active);
    for (GLuint unit = 0; unit < limit(GL_MAX_IMAGE_UNITS); ++unit)
        for (const GLenum name : {GL_IMAGE_BINDING_NAME, GL_IMAGE_BINDING_LEVEL, GL_IMAGE_BINDING_LAYERED,
                                  GL_IMAGE_BINDING_LAYER, GL_IMAGE_BINDING_ACCESS, GL_IMAGE_BINDING_FORMAT}) {
            GLint value = 0;
            gl::GetIntegeri_v(name, unit, &value);
            state["image unit " + std::to_string(unit)].push_back(value);
        }
    for (GLuint attribute = 0; attribute < limit(GL_MAX_VERTEX_ATTRIBS); ++attribute) {
        std::vector<double>& values = state["vertex attribute " + std::to_string(attribute)];
        for (const GLenum name :
             {GL_VERTEX_ATTRIB_ARRAY_ENABLED, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING,
              GL_VERTEX_ATTRIB_ARRAY_SIZE, GL_VERTEX_ATTRIB_ARRAY_STRIDE, GL_VERTEX_ATTRIB_ARRAY_TYPE,
              GL_VERTEX_ATTRIB_ARRAY_DIVISOR, GL_CURRENT_VERTEX_ATTRIB}) {
            GLfloat four[4] = {};
            getVertexAttrib(attribute, name, four);
            values.insert(values.end(), four, four + 4);
        }
    }
    for (GLuint i = 0; i < limit(GL_MAX_SAMPLE_MASK_WORDS); ++i) {
        GLint word = 0;
        gl::GetIntegeri_v(GL_SAMPLE_MASK_VALUE, i, &word);
        state["sample mask " + std::to_string(i)] = {double(word)};
    }
    return state;
}

}  // namespace vct::test
