#include "engine/render/osmesa_context.h"

#include <GL/osmesa.h>
#include <dlfcn.h>

#include <algorithm>
#include <vector>

#include "engine/core/check.h"

namespace trocar::render {
namespace {

struct Osmesa {
  decltype(&OSMesaCreateContextAttribs) create_context = nullptr;
  decltype(&OSMesaDestroyContext) destroy_context = nullptr;
  decltype(&OSMesaMakeCurrent) make_current = nullptr;
  decltype(&OSMesaGetProcAddress) get_proc = nullptr;
};

template <typename Function>
bool find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  return function != nullptr;
}

Result<Osmesa> load_library() {
  // Never closed: LLVM's and Mesa's threads may outlive the last context.
  void* library = dlopen("libOSMesa.so.8", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    return fail(ErrorCode::kUnsupported, "pictures need the library libOSMesa.so.8 (Debian package libosmesa6)");
  }
  Osmesa osmesa;
  if (find(library, "OSMesaCreateContextAttribs", osmesa.create_context) &&
      find(library, "OSMesaDestroyContext", osmesa.destroy_context) &&
      find(library, "OSMesaMakeCurrent", osmesa.make_current) &&
      find(library, "OSMesaGetProcAddress", osmesa.get_proc)) {
    return osmesa;
  }
  return fail(ErrorCode::kUnsupported, "libOSMesa.so.8 is too old to give a core profile");
}

const Result<Osmesa>& library() {
  static const Result<Osmesa> kLibrary = load_library();
  return kLibrary;
}

GlProc get_proc(const char* name) {
  return library()->get_proc(name);
}

}  // namespace

struct OsmesaContext::Impl {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> buffer;
  OSMesaContext context = nullptr;
  GlFunctions gl;

  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    if (context == nullptr) return;
    library()->make_current(nullptr, nullptr, 0, 0, 0);
    library()->destroy_context(context);
  }
};

Result<OsmesaContext> OsmesaContext::create(int width, int height) {
  TROCAR_CHECK(width > 0 && height > 0);
  if (!library()) return tl::unexpected<Error>(library().error());
  auto impl = std::make_unique<Impl>();
  impl->width = width;
  impl->height = height;
  impl->buffer.resize(std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            24,
                            OSMESA_STENCIL_BITS,
                            8,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            3,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            3,
                            0,
                            0};
  impl->context = library()->create_context(attributes, nullptr);
  if (impl->context == nullptr) return fail(ErrorCode::kUnsupported, "OSMesa here has no OpenGL 3.3 core profile");
  if (library()->make_current(impl->context, impl->buffer.data(), GL_UNSIGNED_BYTE, width, height) == GL_FALSE) {
    return fail(ErrorCode::kUnsupported, "OSMesa could not make its context current");
  }
  TROCAR_ASSIGN_OR_RETURN(impl->gl, GlFunctions::load(get_proc));
  return OsmesaContext(std::move(impl));
}

OsmesaContext::OsmesaContext(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
OsmesaContext::~OsmesaContext() = default;
OsmesaContext::OsmesaContext(OsmesaContext&&) noexcept = default;
OsmesaContext& OsmesaContext::operator=(OsmesaContext&&) noexcept = default;

const GlFunctions& OsmesaContext::gl() const {
  return impl_->gl;
}

Image OsmesaContext::read_picture() const {
  Image image(impl_->width, impl_->height);
  const GlFunctions& gl = impl_->gl;
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, impl_->width, impl_->height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  const auto row = std::size_t{4} * static_cast<std::size_t>(impl_->width);
  for (int top = 0, bottom = impl_->height - 1; top < bottom; ++top, --bottom) {
    const auto a = image.rgba.begin() + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(top));
    const auto b = image.rgba.begin() + static_cast<std::ptrdiff_t>(row * static_cast<std::size_t>(bottom));
    std::swap_ranges(a, a + static_cast<std::ptrdiff_t>(row), b);
  }
  return image;
}

std::string OsmesaContext::description() const {
  const auto text = [this](GLenum name) {
    const GLubyte* found = impl_->gl.GetString(name);
    return std::string(found == nullptr ? "unknown" : reinterpret_cast<const char*>(found));
  };
  return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

}  // namespace trocar::render
