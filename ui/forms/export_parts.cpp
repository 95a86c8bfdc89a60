#include "ui/forms/export_parts.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <system_error>
#include <vector>

#include "engine/core/ending.h"

namespace trocar::ui {

std::string beside_project(const WorkbenchState& state, std::string_view ending) {
  std::filesystem::path path = state.path;
  path.replace_extension();
  return path.string() + std::string(ending);
}

int place_of_ending(const std::string& path, std::span<const std::string_view> endings) {
  const auto found = std::find(endings.begin(), endings.end(), ending_of(path));
  return found == endings.end() ? -1 : static_cast<int>(found - endings.begin());
}

std::string PaperChoice::preset() const {
  constexpr std::array<const char*, 3> kPresets{"", "column", "page"};
  return kPresets[static_cast<std::size_t>(paper)];
}

void draw_paper(Ui& ui, PaperChoice& choice, bool drawn, bool picture) {
  static const std::vector<std::string> kPapers{"Screen", "88 mm", "180 mm"};
  const std::string numbers = drawn ? "" : "This file holds numbers";
  form_label(ui, "Width");
  segmented(ui, "Width", choice.paper, kPapers,
            {.help = "One column of a page, or the whole page, with letters of 8 pt", .reason = numbers});
  const std::string no_pixels = !drawn              ? numbers
                                : !picture          ? "A drawing has no pixels"
                                : choice.paper == 0 ? "Choose a width on paper first"
                                                    : "";
  form_label(ui, "Pixels an inch");
  number_field(ui, "Pixels an inch", choice.dpi, 72, 2400, {.help = "From 72 to 2400", .reason = no_pixels});
  form_label(ui, "Ground");
  checkbox(ui, "Transparent", choice.transparent,
           {.help = "Without the white ground, to be laid over another", .reason = numbers});
}

std::string reason_against_path(const std::string& path, const WorkbenchState& state) {
  if (path.empty()) return "Type a file name";
  std::error_code error;
  const std::filesystem::path whole(path);
  if (std::filesystem::is_directory(whole, error)) return "That is a folder";
  const std::filesystem::path folder = whole.parent_path();
  if (!folder.empty() && !std::filesystem::is_directory(folder, error)) return "There is no folder " + folder.string();
  return std::filesystem::equivalent(whole, state.path, error) ? "That is the project itself" : "";
}

bool export_button(Ui& ui, const char* sign, const std::string& path, const std::string& reason) {
  std::error_code error;
  const bool exists = !path.empty() && std::filesystem::exists(path, error);
  if (exists) wrapped_text(ui, "There is such a file already", ui.theme().warning);
  return button(
      ui, exists ? "Replace the file" : "Export",
      {.icon = sign, .reason = reason, .width = -1.0F, .style = exists ? ButtonStyle::kDanger : ButtonStyle::kPrimary});
}

}  // namespace trocar::ui
