/// What every command that writes a figure says of paper.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <optional>
#include <string>

#include "engine/core/result.h"
#include "engine/figure/print.h"

namespace trocar::app {

constexpr const char* kPresetHelp =
    "For print: column (88 mm wide) or page (180 mm), with letters of 8 pt; .svg and .pdf in these lengths";
constexpr const char* kDpiHelp =
    "Pixels an inch of a .png: how many it has, with a preset (else 300), and what it says of itself";
constexpr double kLeastDpi = 72.0;
constexpr double kMostDpi = 2400.0;

constexpr const char* kTransparentHelp = "Without the white ground, to be laid over another";

/// Errors: kInvalidArgument for a resolution (other than 0: none) of what is no picture.
Status check_dpi(double dpi, const std::filesystem::path& out);

/// Width, paper and file of a plot: --width, --preset, --dpi and --out.
struct PrintArguments {
  int width = 1000;
  std::string preset;
  double dpi = 0.0;  ///< 0: not said.
  bool transparent = false;
  std::string out;

  /// What a picture says of itself, if that was asked for.
  std::optional<double> said_dpi() const { return dpi > 0.0 ? std::optional(dpi) : std::nullopt; }
};
/// `files` is the help of --out.
void bind_print(CLI::App& verb, PrintArguments& arguments, const std::string& files);
/// Nothing for a screen. Errors: kInvalidArgument for an unknown preset.
Result<std::optional<figure::Print>> print_of(const PrintArguments& arguments);

}  // namespace trocar::app
