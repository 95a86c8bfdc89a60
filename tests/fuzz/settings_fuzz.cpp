// Settings of the window from any bytes: what is accepted is whole, and reads back the same without a complaint.
#include <cstddef>
#include <cstdint>
#include <set>
#include <string_view>

#include "ui/settings.h"

namespace {

void check_layout(const trocar::ui::Tile& layout, const trocar::ui::Tile& again) {
  using namespace trocar::ui;
  const auto panels = panels_of(layout);
  if (panels.empty() || std::set<PanelId>(panels.begin(), panels.end()).size() != panels.size()) __builtin_trap();
  if (panels_of(again) != panels) __builtin_trap();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace trocar;
  Diagnostics odd;
  const auto settings = ui::settings_from_json({reinterpret_cast<const char*>(data), size}, odd);
  if (!settings) return 0;
  Diagnostics none;
  const auto again = ui::settings_from_json(ui::to_json(*settings), none);
  if (!again || !none.warnings().empty() || again->keys != settings->keys) __builtin_trap();
  for (std::size_t i = 0; i < ui::kWorkspaceCount; ++i) {
    check_layout(settings->layouts[i], again->layouts[i]);
    if (settings->named[i].size() != again->named[i].size()) __builtin_trap();
  }
  return 0;
}
