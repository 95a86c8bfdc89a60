/// Where pictures and shadows are drawn: frame buffers that follow the asked size.
#pragma once

#include <vector>

#include "engine/core/image.h"
#include "engine/core/result.h"
#include "engine/render/gl_functions.h"
#include "engine/render/items.h"

namespace trocar::render {

/// A colour and depth frame buffer, multisampled if asked. Threads: that of the context.
class FrameTarget {
 public:
  explicit FrameTarget(const GlFunctions& gl) : gl_(gl) {}
  ~FrameTarget();
  FrameTarget(const FrameTarget&) = delete;
  FrameTarget& operator=(const FrameTarget&) = delete;

  bool is(int width, int height, int samples) const;
  /// Makes it `width` × `height` with that many samples (keeps it and what is on it if it is) and binds it.
  /// Errors: kUnsupported if the driver cannot.
  Status bind(int width, int height, int samples);
  /// The picture, row 0 as the driver's lowest; `drawn` holds what was drawn on since the last call.
  Image read(const std::vector<PixelBox>& drawn) const;
  /// The depth buffer in the same order, 0 near … 1 far. Precondition: the target was drawn on.
  std::vector<float> read_depth() const;

 private:
  struct Buffers {
    GLuint frame = 0;
    GLuint colour = 0;
    GLuint depth = 0;
  };
  Buffers make(int samples) const;
  void release();

  const GlFunctions& gl_;
  Buffers drawn_;
  Buffers resolved_;  ///< Of several samples only.
  int width_ = 0;
  int height_ = 0;
  int samples_ = 0;
};

/// A square depth texture seen from the light.
class ShadowMap {
 public:
  static constexpr int kSize = 1024;

  explicit ShadowMap(const GlFunctions& gl);
  ~ShadowMap();
  ShadowMap(const ShadowMap&) = delete;
  ShadowMap& operator=(const ShadowMap&) = delete;

  void bind_for_drawing() const;
  GLuint texture() const { return texture_; }

 private:
  const GlFunctions& gl_;
  GLuint frame_ = 0;
  GLuint texture_ = 0;
};

}  // namespace trocar::render
