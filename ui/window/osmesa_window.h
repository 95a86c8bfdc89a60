/// A window without a screen whose frames are real pixels: screenshots, golden pictures, benchmarks.
#pragma once

#include <memory>

#include "engine/render/osmesa_context.h"
#include "ui/gui_renderer.h"
#include "ui/window/null_window.h"

namespace trocar::ui {

/// Threads: created, used and destroyed in one thread, where no other GL context may be current.
class OsmesaWindow final : public NullWindow {
 public:
  /// Errors: kUnsupported when OSMesa is missing; kInvalidArgument for a size outside of 64 … 8192.
  static Result<std::unique_ptr<OsmesaWindow>> create(WindowSize size);

  Status upload_fonts(ImFontAtlas& atlas) override;
  Status present(const ImDrawData& data, Rgba ground) override;
  Result<Image> capture() override;
  TextureStore& textures() override { return *renderer_; }
  /// Each `present` draws and waits for the pixels, even if nothing changed: for the benchmark.
  void always_draw(bool on) { always_ = on; }

 private:
  OsmesaWindow(WindowSize size, render::OsmesaContext context) : NullWindow(size), context_(std::move(context)) {}
  render::OsmesaContext context_;
  std::unique_ptr<GuiRenderer> renderer_;
  bool always_ = false;
};

}  // namespace trocar::ui
