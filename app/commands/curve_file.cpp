#include "app/commands/curve_file.h"

#include <optional>

#include "engine/media/picture_file.h"

namespace trocar::app {

Status write_curves(const figure::CurveFigure& made, const std::filesystem::path& out, double dpi) {
  const std::string ending = out.extension().string();
  if (ending == ".csv") return figure::save_curves_csv(made, out);
  if (ending != ".png") return figure::save_curves(made, out);
  std::optional<double> density = made.print ? std::optional(made.print->dpi) : std::nullopt;
  if (dpi > 0.0) density = dpi;
  return media::write_png(out, figure::draw_curves(made), density);
}

}  // namespace trocar::app
