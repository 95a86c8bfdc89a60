#include "engine/render/frame_target.h"

namespace trocar::render {

FrameTarget::~FrameTarget() {
  release();
}

void FrameTarget::release() {
  for (Buffers* buffers : {&drawn_, &resolved_}) {
    if (buffers->frame == 0) continue;
    gl_.DeleteFramebuffers(1, &buffers->frame);
    gl_.DeleteRenderbuffers(1, &buffers->colour);
    gl_.DeleteRenderbuffers(1, &buffers->depth);
    *buffers = {};
  }
  width_ = height_ = samples_ = 0;
}

FrameTarget::Buffers FrameTarget::make(int samples) const {
  const auto storage = [&](GLuint& name, GLenum format, GLenum attachment) {
    gl_.GenRenderbuffers(1, &name);
    gl_.BindRenderbuffer(GL_RENDERBUFFER, name);
    if (samples > 1) {
      gl_.RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width_, height_);
    } else {
      gl_.RenderbufferStorage(GL_RENDERBUFFER, format, width_, height_);
    }
    gl_.FramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, name);
  };
  Buffers buffers;
  gl_.GenFramebuffers(1, &buffers.frame);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, buffers.frame);
  storage(buffers.colour, GL_RGBA8, GL_COLOR_ATTACHMENT0);
  storage(buffers.depth, GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
  return buffers;
}

bool FrameTarget::is(int width, int height, int samples) const {
  return width == width_ && height == height_ && samples == samples_;
}

Status FrameTarget::bind(int width, int height, int samples) {
  if (!is(width, height, samples)) {
    release();
    width_ = width;
    height_ = height;
    samples_ = samples;
    if (samples > 1) resolved_ = make(1);
    drawn_ = make(samples);
    if (gl_.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      release();
      return fail(ErrorCode::kUnsupported, "OpenGL here cannot draw a picture of that size and number of samples");
    }
  }
  gl_.BindFramebuffer(GL_FRAMEBUFFER, drawn_.frame);
  gl_.Viewport(0, 0, width_, height_);
  return {};
}

Image FrameTarget::read(const std::vector<PixelBox>& drawn) const {
  GLuint frame = drawn_.frame;
  if (samples_ > 1) {
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.frame);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.frame);
    for (const PixelBox& box : drawn) {
      gl_.BlitFramebuffer(box.left, box.top, box.right, box.bottom, box.left, box.top, box.right, box.bottom,
                          GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
    frame = resolved_.frame;
  }
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, frame);
  Image image;
  image.width = width_;
  image.height = height_;
  image.rgba.resize(std::size_t{4} * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_.ReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  return image;
}

std::vector<float> FrameTarget::read_depth() const {
  GLuint frame = drawn_.frame;
  if (samples_ > 1) {
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, drawn_.frame);
    gl_.BindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.frame);
    gl_.BlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    frame = resolved_.frame;
  }
  gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, frame);
  std::vector<float> depth(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  gl_.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_.ReadPixels(0, 0, width_, height_, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
  return depth;
}

ShadowMap::ShadowMap(const GlFunctions& gl) : gl_(gl) {
  gl_.GenTextures(1, &texture_);
  gl_.BindTexture(GL_TEXTURE_2D, texture_);
  gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, kSize, kSize, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  // Beyond the map is light: its outermost texels are only ever cleared. (A border colour costs more at every look.)
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  gl_.GenFramebuffers(1, &frame_);
  gl_.BindFramebuffer(GL_FRAMEBUFFER, frame_);
  gl_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, texture_, 0);
  gl_.DrawBuffer(GL_NONE);
  gl_.ReadBuffer(GL_NONE);
}

ShadowMap::~ShadowMap() {
  gl_.DeleteFramebuffers(1, &frame_);
  gl_.DeleteTextures(1, &texture_);
}

void ShadowMap::bind_for_drawing() const {
  gl_.BindFramebuffer(GL_FRAMEBUFFER, frame_);
  gl_.Viewport(0, 0, kSize, kSize);
}

}  // namespace trocar::render
