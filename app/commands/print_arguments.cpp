#include "app/commands/print_arguments.h"

#include "engine/core/ending.h"

namespace trocar::app {

Status check_dpi(double dpi, const std::filesystem::path& out) {
  if (dpi == 0.0 || ending_of(out) == ".png") return {};
  return tl::unexpected(
      Error(ErrorCode::kInvalidArgument, "--dpi is of a .png; a drawing has no pixels").at(out.string()));
}

void bind_print(CLI::App& verb, PrintArguments& arguments, const std::string& files) {
  verb.add_option("--width", arguments.width, "Of the figure, in pixels")
      ->check(CLI::Range(480, 8000))
      ->capture_default_str();
  verb.add_option("--preset", arguments.preset, kPresetHelp)->excludes("--width");
  verb.add_option("--dpi", arguments.dpi, kDpiHelp)->check(CLI::Range(kLeastDpi, kMostDpi));
  verb.add_flag("--transparent", arguments.transparent, kTransparentHelp);
  verb.add_option("--out", arguments.out, files)->required();
}

Result<std::optional<figure::Print>> print_of(const PrintArguments& arguments) {
  if (arguments.preset.empty()) return std::optional<figure::Print>();
  TROCAR_ASSIGN_OR_RETURN(figure::Print print, figure::print_from(arguments.preset));
  print.dpi = arguments.said_dpi().value_or(print.dpi);
  return std::optional(print);
}

}  // namespace trocar::app
