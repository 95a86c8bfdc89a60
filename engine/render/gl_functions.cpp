#include "engine/render/gl_functions.h"

#include <array>
#include <string>

namespace trocar::render {
namespace {

Result<GLuint> compile(const GlFunctions& gl, GLenum kind, const char* source) {
  const GLuint shader = gl.CreateShader(kind);
  gl.ShaderSource(shader, 1, &source, nullptr);
  gl.CompileShader(shader);
  GLint compiled = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled != 0) return shader;
  std::array<char, 1024> log{};
  gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  gl.DeleteShader(shader);
  return fail(ErrorCode::kUnsupported, "the driver refuses a shader: " + std::string(log.data()));
}

}  // namespace

Result<GlFunctions> GlFunctions::load(GetProc get_proc) {
  GlFunctions gl;
#define TROCAR_GL_LOAD(type, name)                                     \
  gl.name = reinterpret_cast<PFNGL##type##PROC>(get_proc("gl" #name)); \
  if (gl.name == nullptr) return fail(ErrorCode::kUnsupported, "OpenGL here has no gl" #name);
  TROCAR_GL_FUNCTIONS(TROCAR_GL_LOAD)
#undef TROCAR_GL_LOAD
  return gl;
}

Result<GLuint> link_program(const GlFunctions& gl, const char* vertex_source, const char* fragment_source) {
  TROCAR_ASSIGN_OR_RETURN(const GLuint vertex, compile(gl, GL_VERTEX_SHADER, vertex_source));
  Result<GLuint> fragment = compile(gl, GL_FRAGMENT_SHADER, fragment_source);
  if (!fragment) {
    gl.DeleteShader(vertex);
    return fragment;
  }
  const GLuint program = gl.CreateProgram();
  gl.AttachShader(program, vertex);
  gl.AttachShader(program, *fragment);
  gl.LinkProgram(program);
  gl.DeleteShader(vertex);
  gl.DeleteShader(*fragment);
  GLint linked = 0;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked != 0) return program;
  std::array<char, 1024> log{};
  gl.GetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
  gl.DeleteProgram(program);
  return fail(ErrorCode::kUnsupported, "the driver refuses a program: " + std::string(log.data()));
}

}  // namespace trocar::render
