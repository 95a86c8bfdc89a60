#include "ui/window/null_window.h"

namespace trocar::ui {

void NullWindow::poll(double) {
  ++frame_;
}

Status NullWindow::upload_fonts(ImFontAtlas& atlas) {
  atlas.SetTexID(reinterpret_cast<ImTextureID>(std::uintptr_t{1}));
  return {};
}

Status NullWindow::present(const ImDrawData&, Rgba) {
  return {};
}

Result<Image> NullWindow::capture() {
  return fail(ErrorCode::kUnsupported, "a window without pixels has no screenshot");
}

}  // namespace trocar::ui
