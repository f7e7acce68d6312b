// What is used of OpenGL, off screen by OSMesa.
#pragma once

#define GL_GLEXT_PROTOTYPES 0
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>
#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace pineda::llvmpipe {

/// What of OpenGL is used.
struct Gl {
  template <class Function>
  static Function get(const char* name) {
    const auto function = reinterpret_cast<Function>(OSMesaGetProcAddress(name));
    if (function == nullptr) throw std::runtime_error(fmt::format("OpenGL has no {}", name));
    return function;
  }
#define PINEDA_GL(type, name) type name = get<type>("gl" #name)
  PINEDA_GL(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers);
  PINEDA_GL(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer);
  PINEDA_GL(PFNGLGENRENDERBUFFERSPROC, GenRenderbuffers);
  PINEDA_GL(PFNGLBINDRENDERBUFFERPROC, BindRenderbuffer);
  PINEDA_GL(PFNGLRENDERBUFFERSTORAGEPROC, RenderbufferStorage);
  PINEDA_GL(PFNGLFRAMEBUFFERRENDERBUFFERPROC, FramebufferRenderbuffer);
  PINEDA_GL(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus);
  PINEDA_GL(PFNGLCREATESHADERPROC, CreateShader);
  PINEDA_GL(PFNGLSHADERSOURCEPROC, ShaderSource);
  PINEDA_GL(PFNGLCOMPILESHADERPROC, CompileShader);
  PINEDA_GL(PFNGLCREATEPROGRAMPROC, CreateProgram);
  PINEDA_GL(PFNGLATTACHSHADERPROC, AttachShader);
  PINEDA_GL(PFNGLLINKPROGRAMPROC, LinkProgram);
  PINEDA_GL(PFNGLGETPROGRAMIVPROC, GetProgramiv);
  PINEDA_GL(PFNGLUSEPROGRAMPROC, UseProgram);
  PINEDA_GL(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays);
  PINEDA_GL(PFNGLBINDVERTEXARRAYPROC, BindVertexArray);
  PINEDA_GL(PFNGLGENBUFFERSPROC, GenBuffers);
  PINEDA_GL(PFNGLBINDBUFFERPROC, BindBuffer);
  PINEDA_GL(PFNGLBUFFERDATAPROC, BufferData);
  PINEDA_GL(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray);
  PINEDA_GL(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer);
  PINEDA_GL(PFNGLDELETEBUFFERSPROC, DeleteBuffers);
  PINEDA_GL(PFNGLGENQUERIESPROC, GenQueries);
  PINEDA_GL(PFNGLBEGINQUERYPROC, BeginQuery);
  PINEDA_GL(PFNGLENDQUERYPROC, EndQuery);
  PINEDA_GL(PFNGLGETQUERYOBJECTUI64VPROC, GetQueryObjectui64v);
  PINEDA_GL(PFNGLPROVOKINGVERTEXPROC, ProvokingVertex);
  PINEDA_GL(PFNGLCLIPCONTROLPROC, ClipControl);
  PINEDA_GL(PFNGLDRAWARRAYSEXTPROC, DrawArrays);
  PINEDA_GL(decltype(&glClear), Clear);
  PINEDA_GL(decltype(&glClearColor), ClearColor);
  PINEDA_GL(decltype(&glClearDepth), ClearDepth);
  PINEDA_GL(decltype(&glEnable), Enable);
  PINEDA_GL(decltype(&glDisable), Disable);
  PINEDA_GL(decltype(&glBlendFunc), BlendFunc);
  PINEDA_GL(decltype(&glCullFace), CullFace);
  PINEDA_GL(decltype(&glFrontFace), FrontFace);
  PINEDA_GL(decltype(&glDepthFunc), DepthFunc);
  PINEDA_GL(decltype(&glDepthMask), DepthMask);
  PINEDA_GL(decltype(&glPolygonOffset), PolygonOffset);
  PINEDA_GL(decltype(&glScissor), Scissor);
  PINEDA_GL(decltype(&glViewport), Viewport);
  PINEDA_GL(decltype(&glPixelStorei), PixelStorei);
  PINEDA_GL(decltype(&glReadPixels), ReadPixels);
  PINEDA_GL(decltype(&glGetError), GetError);
  PINEDA_GL(decltype(&glFinish), Finish);
  PINEDA_GL(decltype(&glGetString), GetString);
#undef PINEDA_GL
};

/// A context that draws to framebuffer objects alone.
class Context {
 public:
  Context();
  ~Context();
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

 private:
  OSMesaContext context_ = nullptr;
  std::vector<uint8_t> window_ = std::vector<uint8_t>(4);
};

/// Draws with the vertices' colours, interpolated as GLSL says it: flat, smooth or noperspective.
void use_program(const Gl& gl, const std::string& interpolation);

/// Draws to new images: a colour in this format, a depth of 24 bits.
void bind_frame(const Gl& gl, GLenum color_format, int width, int height);

/// Copies vertices to a new buffer and draws from there: `components` floats each of the position in
/// clip space, w = 1 where there are three, then four bytes of the colour. Returns the buffer.
GLuint bind_vertices(const Gl& gl, int components, const void* vertices, size_t count);

}  // namespace pineda::llvmpipe
