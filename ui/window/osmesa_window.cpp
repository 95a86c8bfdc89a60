#include "ui/window/osmesa_window.h"

namespace trocar::ui {

Result<std::unique_ptr<OsmesaWindow>> OsmesaWindow::create(WindowSize size) {
  if (size.width < 64 || size.height < 64 || size.width > 8192 || size.height > 8192) {
    return fail(ErrorCode::kInvalidArgument, "a window is 64 to 8192 pixels wide and high");
  }
  TROCAR_ASSIGN_OR_RETURN(render::OsmesaContext context, render::OsmesaContext::create(size.width, size.height));
  std::unique_ptr<OsmesaWindow> window(new OsmesaWindow(size, std::move(context)));
  TROCAR_ASSIGN_OR_RETURN(window->renderer_, GuiRenderer::create(window->context_.gl()));
  return window;
}

Status OsmesaWindow::upload_fonts(ImFontAtlas& atlas) {
  renderer_->upload_fonts(atlas);
  return {};
}

Status OsmesaWindow::present(const ImDrawData& data, Rgba ground) {
  renderer_->draw(data, ground, always_);
  if (always_) context_.gl().Finish();
  return {};
}

Result<Image> OsmesaWindow::capture() {
  return context_.read_picture();
}

}  // namespace trocar::ui
