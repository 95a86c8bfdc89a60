#include "app/commands/print_arguments.h"

namespace trocar::app {

Status check_dpi(double dpi, const std::filesystem::path& out) {
  if (dpi == 0.0 || out.extension() == ".png") return {};
  return tl::unexpected(
      Error(ErrorCode::kInvalidArgument, "--dpi is of a .png; a drawing has no pixels").at(out.string()));
}

}  // namespace trocar::app
