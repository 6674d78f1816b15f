// OpenGL ES entry points, resolved at run time from the platform: the same names serve EGL, OSMesa (whose
// desktop context has all of them) and Android.
#pragma once

#define GL_GLES_PROTOTYPES 0
#include <GLES3/gl32.h>

#include <GLES2/gl2ext.h>  // after the types of gl32.h

namespace vct::gl {

// One list of what is used. Entry points of KHR_debug may be absent and are null then.
#define VCT_GL_FUNCTIONS(X)                             \
    X(ACTIVETEXTURE, ActiveTexture)                     \
    X(ATTACHSHADER, AttachShader)                       \
    X(BEGINQUERY, BeginQuery)                           \
    X(BINDBUFFER, BindBuffer)                           \
    X(BINDBUFFERBASE, BindBufferBase)                   \
    X(BINDBUFFERRANGE, BindBufferRange)                 \
    X(BINDFRAMEBUFFER, BindFramebuffer)                 \
    X(BINDIMAGETEXTURE, BindImageTexture)               \
    X(BINDSAMPLER, BindSampler)                         \
    X(BINDTEXTURE, BindTexture)                         \
    X(BINDVERTEXARRAY, BindVertexArray)                 \
    X(BLENDEQUATION, BlendEquation)                     \
    X(BLENDFUNC, BlendFunc)                             \
    X(BUFFERDATA, BufferData)                           \
    X(BUFFERSUBDATA, BufferSubData)                     \
    X(CHECKFRAMEBUFFERSTATUS, CheckFramebufferStatus)   \
    X(CLEARBUFFERFV, ClearBufferfv)                     \
    X(CLEARBUFFERUIV, ClearBufferuiv)                   \
    X(COLORMASK, ColorMask)                             \
    X(COMPILESHADER, CompileShader)                     \
    X(COPYBUFFERSUBDATA, CopyBufferSubData)             \
    X(CREATEPROGRAM, CreateProgram)                     \
    X(CREATESHADER, CreateShader)                       \
    X(CULLFACE, CullFace)                               \
    X(DELETEBUFFERS, DeleteBuffers)                     \
    X(DELETEFRAMEBUFFERS, DeleteFramebuffers)           \
    X(DELETEPROGRAM, DeleteProgram)                     \
    X(DELETEQUERIES, DeleteQueries)                     \
    X(DELETESAMPLERS, DeleteSamplers)                   \
    X(DELETESHADER, DeleteShader)                       \
    X(DELETETEXTURES, DeleteTextures)                   \
    X(DELETEVERTEXARRAYS, DeleteVertexArrays)           \
    X(DEPTHFUNC, DepthFunc)                             \
    X(DEPTHMASK, DepthMask)                             \
    X(DISABLE, Disable)                                 \
    X(DISPATCHCOMPUTE, DispatchCompute)                 \
    X(DISPATCHCOMPUTEINDIRECT, DispatchComputeIndirect) \
    X(DRAWARRAYS, DrawArrays)                           \
    X(DRAWBUFFERS, DrawBuffers)                         \
    X(DRAWELEMENTS, DrawElements)                       \
    X(DRAWELEMENTSINDIRECT, DrawElementsIndirect)       \
    X(ENABLE, Enable)                                   \
    X(ENABLEVERTEXATTRIBARRAY, EnableVertexAttribArray) \
    X(ENDQUERY, EndQuery)                               \
    X(FINISH, Finish)                                   \
    X(FRAMEBUFFERPARAMETERI, FramebufferParameteri)     \
    X(FRAMEBUFFERTEXTURE2D, FramebufferTexture2D)       \
    X(FRAMEBUFFERTEXTURELAYER, FramebufferTextureLayer) \
    X(FRONTFACE, FrontFace)                             \
    X(GENBUFFERS, GenBuffers)                           \
    X(GENERATEMIPMAP, GenerateMipmap)                   \
    X(GENFRAMEBUFFERS, GenFramebuffers)                 \
    X(GENQUERIES, GenQueries)                           \
    X(GENSAMPLERS, GenSamplers)                         \
    X(GENTEXTURES, GenTextures)                         \
    X(GENVERTEXARRAYS, GenVertexArrays)                 \
    X(GETERROR, GetError)                               \
    X(GETINTEGERV, GetIntegerv)                         \
    X(GETINTEGERI_V, GetIntegeri_v)                     \
    X(GETPROGRAMINFOLOG, GetProgramInfoLog)             \
    X(GETPROGRAMIV, GetProgramiv)                       \
    X(GETQUERYIV, GetQueryiv)                           \
    X(GETQUERYOBJECTUIV, GetQueryObjectuiv)             \
    X(GETSHADERINFOLOG, GetShaderInfoLog)               \
    X(GETSHADERIV, GetShaderiv)                         \
    X(GETSTRING, GetString)                             \
    X(GETSTRINGI, GetStringi)                           \
    X(GETUNIFORMLOCATION, GetUniformLocation)           \
    X(LINKPROGRAM, LinkProgram)                         \
    X(MAPBUFFERRANGE, MapBufferRange)                   \
    X(MEMORYBARRIER, MemoryBarrier)                     \
    X(PIXELSTOREI, PixelStorei)                         \
    X(READBUFFER, ReadBuffer)                           \
    X(READPIXELS, ReadPixels)                           \
    X(SAMPLERPARAMETERI, SamplerParameteri)             \
    X(SCISSOR, Scissor)                                 \
    X(SHADERSOURCE, ShaderSource)                       \
    X(TEXPARAMETERI, TexParameteri)                     \
    X(TEXSTORAGE2D, TexStorage2D)                       \
    X(TEXSTORAGE3D, TexStorage3D)                       \
    X(TEXSUBIMAGE2D, TexSubImage2D)                     \
    X(TEXSUBIMAGE3D, TexSubImage3D)                     \
    X(UNIFORM1UI, Uniform1ui)                           \
    X(UNIFORM4F, Uniform4f)                             \
    X(UNMAPBUFFER, UnmapBuffer)                         \
    X(USEPROGRAM, UseProgram)                           \
    X(VERTEXATTRIBDIVISOR, VertexAttribDivisor)         \
    X(VERTEXATTRIBIPOINTER, VertexAttribIPointer)       \
    X(VERTEXATTRIBPOINTER, VertexAttribPointer)         \
    X(VIEWPORT, Viewport)

#define VCT_GL_OPTIONAL_FUNCTIONS(X)              \
    X(DEBUGMESSAGECALLBACK, DebugMessageCallback) \
    X(DEBUGMESSAGECONTROL, DebugMessageControl)   \
    X(OBJECTLABEL, ObjectLabel)                   \
    X(POPDEBUGGROUP, PopDebugGroup)               \
    X(PUSHDEBUGGROUP, PushDebugGroup)

#define VCT_GL_DECLARE(TYPE, NAME) extern PFNGL##TYPE##PROC NAME;
VCT_GL_FUNCTIONS(VCT_GL_DECLARE)
VCT_GL_OPTIONAL_FUNCTIONS(VCT_GL_DECLARE)
#undef VCT_GL_DECLARE
// Of GL_EXT_disjoint_timer_query; null without it.
extern PFNGLGETQUERYOBJECTUI64VEXTPROC GetQueryObjectui64v;

using Proc = void (*)();

// Resolves every entry point; throws vct::Error naming all required ones that the driver lacks.
// Optional ones are also looked for under their KHR suffix.
void load(Proc (*getProcAddress)(const char* name, const void* user), const void* user);

}  // namespace vct::gl
