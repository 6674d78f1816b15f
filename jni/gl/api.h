// OpenGL ES entry points, resolved at run time. The same table serves EGL, Android, and OSMesa, whose desktop
// context has all of them.
#pragma once

#include <GLES3/gl32.h>

#include <GLES2/gl2ext.h>  // after the types of gl32.h

#include <string>
#include <vector>

namespace vct::gl {

// The entry points that are used. Their types come from the prototypes in gl32.h, which nothing links to. The
// optional ones belong to KHR_debug and are null without it.
// clang-format off
#define VCT_GL_FUNCTIONS(X)                                                                                \
    X(ActiveTexture) X(AttachShader) X(BeginQuery) X(BindBuffer) X(BindBufferBase) X(BindBufferRange)      \
    X(BindFramebuffer) X(BindImageTexture) X(BindRenderbuffer) X(BindSampler) X(BindTexture) X(BindVertexArray)                \
    X(BlendEquation) X(BlendEquationSeparate) X(BlendFunc) X(BlendFuncSeparate) X(BufferData) X(BufferSubData) X(CheckFramebufferStatus) \
    X(ClearBufferfv) X(ClearBufferuiv) X(ClientWaitSync) X(ColorMask) X(CompileShader) X(CopyBufferSubData) X(CreateProgram) \
    X(CreateShader) X(CullFace) X(DeleteBuffers) X(DeleteFramebuffers) X(DeleteProgram) X(DeleteQueries) X(DeleteRenderbuffers) \
    X(DeleteSamplers) X(DeleteShader) X(DeleteSync) X(DeleteTextures) X(DeleteVertexArrays) X(DepthFunc) X(DepthMask)    \
    X(DepthRangef) X(GetBufferParameteriv) X(GetFloatv) X(GetTexLevelParameteriv)                                                  \
    X(Disable) X(DispatchCompute) X(DispatchComputeIndirect) X(DrawArrays) X(DrawBuffers) X(DrawElements)  \
    X(DrawElementsInstanced) X(Enable) X(EnableVertexAttribArray) X(EndQuery) X(Finish)                    \
    X(FenceSync) X(FramebufferParameteri) X(FramebufferRenderbuffer) X(FramebufferTexture2D) X(FramebufferTextureLayer) X(FrontFace) X(GenBuffers) \
    X(GenerateMipmap) X(GenFramebuffers) X(GenQueries) X(GenRenderbuffers) X(GenSamplers) X(GenTextures) X(GenVertexArrays)    \
    X(GetError) X(GetInteger64i_v) X(GetIntegerv) X(GetIntegeri_v) X(GetProgramBinary) X(GetProgramInfoLog) X(GetProgramiv) X(GetQueryiv)         \
    X(GetQueryObjectuiv) X(GetShaderInfoLog) X(GetShaderiv) X(GetString) X(GetStringi)                     \
    X(GetUniformLocation) X(InvalidateFramebuffer) X(IsBuffer) X(IsTexture) X(LinkProgram) X(MapBufferRange) X(MemoryBarrier)       \
    X(PixelStorei) X(ProgramBinary) X(ProgramParameteri) X(ReadBuffer) X(ReadPixels) X(ReleaseShaderCompiler) X(RenderbufferStorageMultisample) X(SamplerParameteri) X(Scissor) X(ShaderSource)             \
    X(TexParameteri) X(TexStorage2D) X(TexStorage3D) X(TexSubImage2D) X(TexSubImage3D) X(Uniform1ui) X(Uniform2ui) X(Uniform3fv) \
    X(Uniform4f) X(UnmapBuffer) X(UseProgram) X(VertexAttribDivisor) X(VertexAttribIPointer)               \
    X(VertexAttribPointer) X(Viewport)

#define VCT_GL_OPTIONAL_FUNCTIONS(X) \
    X(DebugMessageCallback) X(DebugMessageControl) X(ObjectLabel) X(PopDebugGroup) X(PushDebugGroup)
// clang-format on

#define VCT_GL_DECLARE(NAME) extern decltype(&::gl##NAME) NAME;
VCT_GL_FUNCTIONS(VCT_GL_DECLARE)
VCT_GL_OPTIONAL_FUNCTIONS(VCT_GL_DECLARE)
#undef VCT_GL_DECLARE
// Belongs to GL_EXT_disjoint_timer_query; null without it.
extern PFNGLGETQUERYOBJECTUI64VEXTPROC GetQueryObjectui64v;
// Belongs to desktop OpenGL 4.5 and to GL_EXT_clip_control; null without it.
extern PFNGLCLIPCONTROLEXTPROC ClipControl;

using Proc = void (*)();

// Resolves every entry point. Throws vct::Error that names all required entry points that the driver lacks,
// or if no context is current. Optional ones are also looked up with the suffix KHR.
void load(Proc (*getProcAddress)(const char* name, const void* user), const void* user);

// A string of the current context, such as GL_RENDERER; "unknown" if the driver has none.
std::string glString(GLenum name);
// GL_EXTENSIONS of the current context.
std::vector<std::string> extensionNames();

}  // namespace vct::gl
