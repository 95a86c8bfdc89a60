/// OpenGL 3.3 in software with no display: Mesa's off-screen context, loaded only when one is asked for.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "engine/core/image.h"
#include "engine/core/result.h"
#include "engine/render/gl_functions.h"

namespace trocar::render {

/// A current core 3.3 context with its own frame buffer 0 of `width` × `height`.
///
/// Threads: created, used and destroyed in one thread, where no other GL context may be current (OSMesa and GLX share
/// state and crash). Several contexts may live in several threads.
class OsmesaContext {
 public:
  /// Errors: kUnsupported when libOSMesa.so.8 is missing or has no OpenGL 3.3.
  static Result<OsmesaContext> create(int width, int height);
  ~OsmesaContext();
  OsmesaContext(OsmesaContext&&) noexcept;
  OsmesaContext& operator=(OsmesaContext&&) noexcept;

  const GlFunctions& gl() const;
  /// Frame buffer 0 as it is now; straight copy, rows from the top.
  Image read_picture() const;
  /// "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 3.3 (Core Profile) Mesa 22.3.6"
  std::string description() const;

 private:
  struct Impl;
  explicit OsmesaContext(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace trocar::render
