#include "examples/llvmpipe/gl.h"

#include <array>
#include <utility>

namespace pineda::llvmpipe {
namespace {

GLuint shader_of(const Gl& gl, GLenum kind, const std::string& text) {
  const GLuint shader = gl.CreateShader(kind);
  const char* const source = text.c_str();
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  return shader;
}

}  // namespace

Context::Context() {
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            4,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            5,
                            0};
  context_ = OSMesaCreateContextAttribs(attributes, nullptr);
  if (context_ == nullptr ||
      OSMesaMakeCurrent(context_, window_.data(), GL_UNSIGNED_BYTE, 1, 1) == GL_FALSE) {
    throw std::runtime_error("OSMesa makes no context of OpenGL 4.5");
  }
}

Context::~Context() { OSMesaDestroyContext(context_); }

void use_program(const Gl& gl, const std::string& interpolation) {
  const GLuint program = gl.CreateProgram();
  gl.AttachShader(program,
                  shader_of(gl, GL_VERTEX_SHADER,
                            "#version 330\n"
                            "layout(location = 0) in vec4 position;\n"
                            "layout(location = 1) in vec4 rgba;\n" +
                                interpolation +
                                " out vec4 color;\n"
                                "void main() { gl_Position = position; color = rgba; }\n"));
  gl.AttachShader(program, shader_of(gl, GL_FRAGMENT_SHADER,
                                     "#version 330\n" + interpolation +
                                         " in vec4 color;\n"
                                         "layout(location = 0) out vec4 drawn;\n"
                                         "void main() { drawn = color; }\n"));
  gl.LinkProgram(program);
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE) throw std::runtime_error("OpenGL does not link the shaders");
  gl.UseProgram(program);
}

void bind_frame(const Gl& gl, GLenum color_format, int width, int height) {
  GLuint buffer = 0;
  std::array<GLuint, 2> images{};
  gl.GenFramebuffers(1, &buffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, buffer);
  gl.GenRenderbuffers(2, images.data());
  const std::array<std::pair<GLenum, GLenum>, 2> parts{
      {{GL_COLOR_ATTACHMENT0, color_format}, {GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24}}};
  for (size_t i = 0; i < parts.size(); ++i) {
    gl.BindRenderbuffer(GL_RENDERBUFFER, images[i]);
    gl.RenderbufferStorage(GL_RENDERBUFFER, parts[i].second, width, height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, parts[i].first, GL_RENDERBUFFER, images[i]);
  }
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("OpenGL has no such framebuffer");
  }
}

GLuint bind_vertices(const Gl& gl, int components, const void* vertices, size_t count) {
  const size_t position_bytes = static_cast<size_t>(components) * sizeof(float);
  const size_t vertex_bytes = position_bytes + 4;
  GLuint array = 0, buffer = 0;
  gl.GenVertexArrays(1, &array);
  gl.BindVertexArray(array);
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(count * vertex_bytes), vertices,
                GL_STATIC_DRAW);
  gl.EnableVertexAttribArray(0);
  gl.VertexAttribPointer(0, components, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(vertex_bytes),
                         nullptr);
  gl.EnableVertexAttribArray(1);
  gl.VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, static_cast<GLsizei>(vertex_bytes),
                         reinterpret_cast<void*>(position_bytes));
  return buffer;
}

}  // namespace pineda::llvmpipe
