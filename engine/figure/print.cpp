#include "engine/figure/print.h"

#include <fmt/format.h>

namespace trocar::figure {

Result<Print> print_from(std::string_view preset) {
  if (preset == "column") return Print{};
  if (preset == "page") return Print{180.0, 8.0, 300.0};
  return fail(ErrorCode::kInvalidArgument, fmt::format("\"{}\" is no figure preset: use column or page", preset));
}

double pt_per_px(double dpi) {
  return 72.0 / dpi;
}

double px_per_mm(double dpi) {
  return dpi / 25.4;
}

}  // namespace trocar::figure
