// Draws a scene with Mesa's llvmpipe, off screen by OSMesa, and writes the frame for pineda judge:
//   draw_by_llvmpipe SCENE DIR
//   draw_by_llvmpipe --version     # of OpenGL and Mesa
//
// Positions are given to OpenGL as they are snapped to 1/256 px, which is what llvmpipe snaps to.
#define GL_GLEXT_PROTOTYPES 0
#include <GL/gl.h>
#include <GL/glext.h>
#include <GL/osmesa.h>
#include <fmt/format.h>

#include <cstdio>
#include <stdexcept>
#include <vector>

#include "examples/llvmpipe/clip_space.h"
#include "model/scene/writers.h"
#include "model/spec/clear_depth.h"

namespace {

using namespace pineda;
using llvmpipe::Vertex;

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
  PINEDA_GL(decltype(&glGetString), GetString);
#undef PINEDA_GL
};

/// A context that draws to framebuffer objects alone.
class Context {
 public:
  Context() {
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
  ~Context() { OSMesaDestroyContext(context_); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;

 private:
  OSMesaContext context_ = nullptr;
  std::vector<uint8_t> window_ = std::vector<uint8_t>(4);
};

/// All triangles of a scene in clip space.
std::vector<Vertex> clip_vertices(const scene::Scene& scene) {
  std::vector<Vertex> vertices;
  for (spec::Triangle triangle; scene.source->next(&triangle);) {
    for (const Vertex& v : llvmpipe::clip_vertices(scene, triangle)) vertices.push_back(v);
  }
  return vertices;
}

GLuint shader_of(const Gl& gl, GLenum kind, const std::string& text) {
  const GLuint shader = gl.CreateShader(kind);
  const char* const source = text.c_str();
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  return shader;
}

/// Vertex colours to attachment 0, and 1 for each hit to attachment 1.
void use_program(const Gl& gl, bool flat) {
  const std::string how = flat ? "flat" : "smooth";
  const GLuint program = gl.CreateProgram();
  gl.AttachShader(program,
                  shader_of(gl, GL_VERTEX_SHADER,
                            "#version 330\n"
                            "layout(location = 0) in vec4 position;\n"
                            "layout(location = 1) in vec4 rgba;\n" +
                                how +
                                " out vec4 color;\n"
                                "void main() { gl_Position = position; color = rgba; }\n"));
  gl.AttachShader(program, shader_of(gl, GL_FRAGMENT_SHADER,
                                     "#version 330\n" + how +
                                         " in vec4 color;\n"
                                         "layout(location = 0) out vec4 drawn;\n"
                                         "void main() { drawn = color; }\n"));
  gl.LinkProgram(program);
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE) throw std::runtime_error("OpenGL does not link the shaders");
  gl.UseProgram(program);
}

void bind_frame(const Gl& gl, GLenum color_format, const spec::FrameState& frame) {
  GLuint buffer = 0;
  std::array<GLuint, 2> images{};
  gl.GenFramebuffers(1, &buffer);
  gl.BindFramebuffer(GL_FRAMEBUFFER, buffer);
  gl.GenRenderbuffers(2, images.data());
  const std::array<std::pair<GLenum, GLenum>, 2> parts{
      {{GL_COLOR_ATTACHMENT0, color_format}, {GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24}}};
  for (size_t i = 0; i < parts.size(); ++i) {
    gl.BindRenderbuffer(GL_RENDERBUFFER, images[i]);
    gl.RenderbufferStorage(GL_RENDERBUFFER, parts[i].second, frame.width, frame.height);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, parts[i].first, GL_RENDERBUFFER, images[i]);
  }
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw std::runtime_error("OpenGL has no such framebuffer");
  }
}

void set_state(const Gl& gl, const spec::FrameState& frame) {
  gl.ClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  gl.Viewport(0, 0, frame.width, frame.height);
  gl.ProvokingVertex(GL_FIRST_VERTEX_CONVENTION);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.Enable(GL_SCISSOR_TEST);
  gl.FrontFace(GL_CW);  // since rows run down
  if (frame.cull != spec::Cull::kNone) {
    gl.Enable(GL_CULL_FACE);
    gl.CullFace(frame.cull == spec::Cull::kBack ? GL_BACK : GL_FRONT);
  }
  if (frame.has_bias()) {
    gl.Enable(GL_POLYGON_OFFSET_FILL);
    // A unit is r, which an implementation chooses; Mesa's is two codes, the scene's constant counts codes.
    gl.PolygonOffset(static_cast<float>(frame.bias_slope) / 256,
                     static_cast<float>(frame.bias_constant) / 2);
  }
}

void clear_and_draw(const Gl& gl, const spec::FrameState& frame, size_t vertices) {
  gl.Scissor(0, 0, frame.width, frame.height);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  const int x = std::max(frame.clip_x0(), 0), y = std::max(frame.clip_y0(), 0);
  gl.Scissor(x, y, std::max(frame.clip_x1() - x, 0), std::max(frame.clip_y1() - y, 0));
  gl.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(vertices));
}

scene::Frame drawn(const scene::Scene& scene) {
  const Context context;
  const Gl gl;
  const spec::FrameState& state = scene.frame;
  const auto vertices = clip_vertices(scene);
  GLuint array = 0, buffer = 0;
  gl.GenVertexArrays(1, &array);
  gl.BindVertexArray(array);
  gl.GenBuffers(1, &buffer);
  gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(Vertex)),
                vertices.data(), GL_STATIC_DRAW);
  gl.EnableVertexAttribArray(0);
  gl.VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
  gl.EnableVertexAttribArray(1);
  gl.VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Vertex),
                         reinterpret_cast<void*>(offsetof(Vertex, rgba)));

  const size_t samples = static_cast<size_t>(state.width) * static_cast<size_t>(state.height);
  scene::Frame frame;
  frame.width = state.width;
  frame.height = state.height;
  set_state(gl, state);

  // Depth and colour
  use_program(gl, state.shade == spec::Shade::kFlat);
  bind_frame(gl, GL_RGBA8, state);
  static constexpr GLenum kFunctions[] = {GL_LESS,    GL_LEQUAL,   GL_ALWAYS, GL_NEVER, GL_EQUAL,
                                          GL_GREATER, GL_NOTEQUAL, GL_GEQUAL, GL_ALWAYS};
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(kFunctions[static_cast<size_t>(state.depth)]);
  gl.ClearDepth(state.clear_depth);
  gl.ClearColor(0, 0, 0, 0);
  gl.DepthMask(GL_TRUE);
  gl.Clear(GL_DEPTH_BUFFER_BIT);
  gl.Scissor(0, 0, state.width, state.height);
  gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  gl.DepthMask(state.depth_write && state.depth != spec::DepthFunc::kOff ? GL_TRUE : GL_FALSE);
  clear_and_draw(gl, state, vertices.size());
  std::vector<uint8_t> rgba(4 * samples);
  gl.ReadPixels(0, 0, state.width, state.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  frame.color.assign(rgba.begin(), rgba.end());
  frame.depth.resize(samples);
  gl.ReadPixels(0, 0, state.width, state.height, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT,
                frame.depth.data());
  for (uint32_t& code : frame.depth) code >>= 8;
  frame.clear_depth = spec::depth_code(state.clear_depth, 24);

  // Hits: 1 is added for each triangle, without a depth test.
  use_program(gl, true);
  bind_frame(gl, GL_R32F, state);
  gl.Disable(GL_DEPTH_TEST);
  gl.Enable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ONE);
  std::vector<Vertex> ones = vertices;
  for (Vertex& vertex : ones) vertex.rgba[0] = 255;
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(ones.size() * sizeof(Vertex)), ones.data(),
                GL_STATIC_DRAW);
  clear_and_draw(gl, state, ones.size());
  std::vector<float> hits(samples);
  gl.ReadPixels(0, 0, state.width, state.height, GL_RED, GL_FLOAT, hits.data());
  for (const float count : hits) {
    frame.hits.push_back(static_cast<uint16_t>(std::min(count, 65535.f)));
  }
  if (gl.GetError() != GL_NO_ERROR) throw std::runtime_error("OpenGL has an error");
  return frame;
}

}  // namespace

int main(int argc, char** argv) {
  const bool asks_version = argc == 2 && std::string(argv[1]) == "--version";
  if (argc != 3 && !asks_version) {
    std::fputs("usage: draw_by_llvmpipe SCENE DIR, or draw_by_llvmpipe --version\n", stderr);
    return 2;
  }
  try {
    if (asks_version) {
      const Context context;
      fmt::print("{}\n", reinterpret_cast<const char*>(Gl().GetString(GL_VERSION)));
      return 0;
    }
    const auto contract = spec::contract(*spec::find_design("persp"));
    scene::write_dump(argv[2], drawn(scene::open_scene(contract, argv[1], {})));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "draw_by_llvmpipe: %s\n", error.what());
    return 2;
  }
  return 0;
}
