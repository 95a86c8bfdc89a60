/// What every command that writes a figure says of paper.
#pragma once

#include <filesystem>

#include "engine/core/result.h"

namespace trocar::app {

constexpr const char* kPresetHelp =
    "For print: column (88 mm wide) or page (180 mm), with letters of 8 pt; .svg and .pdf in these lengths";
constexpr const char* kDpiHelp =
    "Pixels an inch of a .png: how many it has, with a preset (else 300), and what it says of itself";
constexpr double kLeastDpi = 72.0;
constexpr double kMostDpi = 2400.0;

/// Errors: kInvalidArgument for a resolution (other than 0: none) of what is no picture.
Status check_dpi(double dpi, const std::filesystem::path& out);

}  // namespace trocar::app
