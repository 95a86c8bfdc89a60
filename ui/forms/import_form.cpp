#include "ui/forms/import_form.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "engine/exchange/map_presets.h"
#include "ui/command_table.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using exchange::Format;
using workbench::Command;
using workbench::ImportPart;
using workbench::ImportView;

constexpr std::array<Format, 4> kFormats{Format::kCsv, Format::kNpy, Format::kHdf5, Format::kJigsaws};

/// "a, b" as words.
std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : text + ",") {
    if (c != ',' && c != ' ') {
      word += c;
    } else if (!word.empty()) {
      words.push_back(std::exchange(word, ""));
    }
  }
  return words;
}

/// The numbers in a text; nothing for anything else.
std::vector<double> numbers_of(const std::string& text) {
  std::vector<double> numbers;
  for (const std::string& word : words_of(text)) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size()) return {};
    numbers.push_back(value);
  }
  return numbers;
}

/// What was found, without what is said as a doubt already.
std::vector<std::string> found_beside(std::vector<std::string> found, const std::vector<std::string>& doubts) {
  std::erase_if(
      found, [&](const std::string& words) { return std::find(doubts.begin(), doubts.end(), words) != doubts.end(); });
  return found;
}

}  // namespace

void ImportForm::open_on(std::filesystem::path file) {
  given_ = std::move(file);
  open();
}

void ImportForm::prepare(const WorkbenchState& state) {
  settings_ = {};
  typed_.clear();
  list_.go_to(first_folder(state));
}

Requests ImportForm::start(const std::filesystem::path& file) {
  settings_ = {};
  settings_.path = file;
  settings_.transcription = workbench::transcription_of(file);
  transcription_ = settings_.transcription.string();
  only_.clear();
  rate_.clear();
  origin_mm_ = "0, 0, 0";
  preset_said_.clear();
  presets_ = exchange::map_presets(exchange::map_preset_folder());
  part_ = 0;
  return {Command{workbench::EndImport{}}, Command{workbench::ReadImport{settings_}}};
}

Requests ImportForm::draw_choice(Ui& ui) {
  wrapped_text(ui, "CSV, TSV, NPY, HDF5 of robomimic, or text of JIGSAWS. Nothing is changed until you have seen it.",
               ui.theme().text_dim);
  list_.draw(ui, typed_, "No folder and no file of these kinds in here",
             2.0F * ImGui::GetFrameHeightWithSpacing() + ui.px(6));
  form_label(ui, "File");
  text_field(ui, "File", typed_, "Name or path");
  std::error_code error;
  const bool there = !typed_.empty() && std::filesystem::is_regular_file(list_.chosen(typed_), error);
  const std::string why = typed_.empty() ? "Choose a file" : there ? "" : "There is no such file";
  const bool look =
      button(ui, "Look at it", {.icon = icon::kSearch, .reason = why, .width = -1.0F, .style = ButtonStyle::kPrimary});
  return look ? start(list_.chosen(typed_)) : Requests{};
}

bool ImportForm::draw_source(Ui& ui, Format format) {
  static const std::vector<std::string> kNames{"CSV, TSV", "NPY", "HDF5", "JIGSAWS"};
  const auto found = std::find(kFormats.begin(), kFormats.end(), format);
  int chosen = static_cast<int>(found - kFormats.begin());
  form_label(ui, "Format");
  bool changed = segmented(ui, "Format", chosen, kNames, {.help = "Told from the file's name and contents"});
  if (changed) {
    settings_.format = kFormats[static_cast<std::size_t>(chosen)];
    settings_.map.reset();
  }
  if (format == Format::kJigsaws) {
    form_label(ui, "Transcription");
    changed |= text_field(ui, "Transcription", transcription_, "None", {.help = "Its gestures become notes"});
    settings_.transcription = transcription_;
  } else {
    settings_.transcription.clear();
  }
  if (format == Format::kHdf5) {
    form_label(ui, "Only");
    changed |= text_field(ui, "Only", only_, "All of them", {.help = "Demonstrations (demo_3) or filter keys (train)"});
    form_label(ui, "Rate, Hz");
    changed |= text_field(ui, "Rate, Hz", rate_, "As the file says, else 20",
                          {.help = "Samples a second, where the file does not tell"});
  }
  settings_.only = format == Format::kHdf5 ? words_of(only_) : std::vector<std::string>();
  const std::vector<double> rate = numbers_of(rate_);
  settings_.rate_hz = format == Format::kHdf5 && rate.size() == 1 ? std::clamp(rate[0], 0.0, 1000.0) : 0.0;
  return changed;
}

bool ImportForm::draw_presets(Ui& ui) {
  bool changed = false;
  std::vector<std::string> names{"As proposed"};
  names.insert(names.end(), presets_.begin(), presets_.end());
  int chosen = 0;
  form_label(ui, "Kept map");
  if (combo(ui, "Kept map", chosen, names, {.help = "Use a map that was kept under a name"})) {
    changed = true;
    settings_.map.reset();
    preset_said_.clear();
    if (chosen > 0) {
      auto map = exchange::load_map_preset(exchange::map_preset_folder(), names[static_cast<std::size_t>(chosen)]);
      if (map) settings_.map = *map;
      if (!map) preset_said_ = map.error().text();
    }
  }
  return changed;
}

bool ImportForm::draw_map(Ui& ui, const ImportView& view) {
  const bool text = view.layout.format != Format::kNpy;
  heading(ui, "Columns");
  bool changed = draw_presets(ui);
  exchange::ColumnMap map = settings_.map ? *settings_.map : view.layout.columns->map;
  if (editor_.draw(ui, map, view.columns, text)) {
    settings_.map = map;
    changed = true;
  }
  heading(ui, "Keep this map");
  form_label(ui, "Map name");
  text_field(ui, "Map name", preset_name_, "For the next file of its kind");
  const std::string why = exchange::reason_against_preset(preset_name_);
  if (button(ui, "Keep the map", {.icon = icon::kDownload, .help = "Under this name", .reason = why})) {
    const std::filesystem::path folder = exchange::map_preset_folder();
    const Status saved = exchange::save_map_preset(folder, preset_name_, map);
    preset_said_ = saved ? fmt::format("Kept as \"{}\"", preset_name_) : saved.error().text();
    presets_ = exchange::map_presets(folder);
  }
  if (!preset_said_.empty()) wrapped_text(ui, preset_said_, ui.theme().text_dim);
  return changed;
}

bool ImportForm::draw_transfer(Ui& ui) {
  static const std::vector<std::string> kPlaces{"Unknown", "0", "1", "2", "3", "4", "5"};
  heading(ui, "What it shows");
  form_label(ui, "Name");
  bool changed = text_field(ui, "Name", settings_.name, "The file's");
  int block = settings_.block == demonstration::kUnknownPlace ? 0 : settings_.block + 1;
  int goal = settings_.goal == demonstration::kUnknownPlace ? 0 : settings_.goal + 1;
  form_label(ui, "Block");
  changed |= combo(ui, "Block", block, kPlaces, {.help = "Which block is carried, if you know it"});
  form_label(ui, "Goal peg");
  changed |= combo(ui, "Goal peg", goal, kPlaces, {.help = "Where it goes, if you know it"});
  settings_.block = block == 0 ? demonstration::kUnknownPlace : block - 1;
  settings_.goal = goal == 0 ? demonstration::kUnknownPlace : goal - 1;
  form_label(ui, "Origin, mm");
  changed |=
      text_field(ui, "Origin, mm", origin_mm_, "0, 0, 0", {.help = "Where the file's origin is on the board: x, y, z"});
  const std::vector<double> origin = numbers_of(origin_mm_);
  for (std::size_t i = 0; i < 3; ++i) settings_.p_WF_m[i] = origin.size() == 3 ? 1e-3 * origin[i] : 0.0;
  return changed;
}

bool ImportForm::draw_settings(Ui& ui, const ImportView* view) {
  const std::string file = shown_path(settings_.path);
  fact(ui, "File", file);
  if (view == nullptr) return false;
  bool changed = draw_source(ui, view->layout.format);
  changed |= draw_transfer(ui);
  if (view->layout.columns) changed |= draw_map(ui, *view);
  return changed;
}

void ImportForm::draw_part(Ui& ui, const ImportView& view, const std::vector<std::string>& doubts, float height) {
  part_ = std::clamp(part_, 0, static_cast<int>(view.parts.size()) - 1);
  if (view.parts.size() > 1) {
    UniqueNames unique;
    std::vector<std::string> names;
    for (const ImportPart& part : view.parts) names.push_back(unique(part.name));
    form_label(ui, "Looked at");
    combo(ui, "Looked at", part_, names, {.help = "All of them are imported"});
  }
  const ImportPart& part = view.parts[static_cast<std::size_t>(part_)];
  heading(ui, "Found, and left as it is");
  sentences(ui, icon::kInfo, part.found, ui.theme().accent);
  if (const std::vector<std::string> changed = found_beside(part.changed, doubts); !changed.empty()) {
    heading(ui, "Changed, left out or assumed");
    sentences(ui, icon::kWarning, changed, ui.theme().warning);
  }
  if (!part.lossy.empty()) {
    heading(ui, "Not in the file");
    sentences(ui, icon::kWarning, part.lossy, ui.theme().warning);
  }
  ImGui::Dummy({0.0F, ui.px(4)});
  preview_.draw(ui, part.document, {ImGui::GetContentRegionAvail().x, height});
  fact(ui, "Demonstrations", count(static_cast<std::int64_t>(view.parts.size())));
  fact(ui, "Duration", seconds(part.document->duration_s()));
  fact(ui, "Samples", count(static_cast<std::int64_t>(part.document->gated().size())));
  fact(ui, "Notes", count(static_cast<std::int64_t>(part.notes.size())));
  fact(ui, "Problems", counted(part.errors, "error") + ", " + counted(part.warnings, "warning"));
}

void ImportForm::draw_outcome(Ui& ui, const WorkbenchState& state, const ImportView* view, float height) {
  const Scope scope(ui, "Outcome");
  if (state.import_pending) {
    dim_text(ui, view == nullptr ? "Reading the file…" : "Reading it again…");
    progress_bar(ui, "Reading", state.import_fraction, ImGui::GetContentRegionAvail().x);
    ui.animate();
  }
  if (view == nullptr) return;
  if (!view->error.empty()) {
    sentences(ui, icon::kWarning, std::array{view->error}, ui.theme().danger);
    wrapped_text(ui, "Nothing was changed. Correct how the file is read, or choose another one.", ui.theme().text_dim);
  }
  std::vector<std::string> doubts;
  if (view->layout.columns && !settings_.map) doubts = view->layout.columns->doubts;
  if (!doubts.empty()) {
    heading(ui, "Not certain");
    sentences(ui, icon::kHelp, doubts, ui.theme().warning);
  }
  if (!view->parts.empty()) draw_part(ui, *view, doubts, height);
}

Requests ImportForm::draw_acts(Ui& ui, const WorkbenchState& state, const ImportView* view) {
  const float half = std::floor(0.5F * (ImGui::GetContentRegionAvail().x - ui.px(8)));
  const bool back = button(
      ui, state.import_pending ? "Stop reading" : "Other file",
      {.icon = state.import_pending ? icon::kStop : icon::kFolder, .help = "Back to the list of files", .width = half});
  ImGui::SameLine(0.0F, ui.px(8));
  std::string why = command("file.import").reason_now(state);
  if (state.import_pending || view == nullptr) why = "The file is still being read";
  if (why.empty() && view->parts.empty()) why = "The file cannot be read in this way";
  const std::size_t found = view == nullptr ? 1 : view->parts.size();
  const std::string words = found > 1 ? fmt::format("Import {} demonstrations", found) : "Import it";
  if (button(ui, words, {.icon = icon::kVerify, .reason = why, .width = half, .style = ButtonStyle::kPrimary})) {
    close();
    return {Command{workbench::MakeImport{}}};
  }
  if (!back) return {};
  settings_.path.clear();
  return {Command{workbench::EndImport{}}};
}

Requests ImportForm::draw_content(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (!given_.empty()) {
    requests = start(std::exchange(given_, {}));
    return requests;
  }
  if (!reading()) return draw_choice(ui);
  const ImportView* view = state.import && state.import->settings.path == settings_.path ? state.import.get() : nullptr;
  const float below = ImGui::GetFrameHeightWithSpacing() + ui.px(4);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const bool beside = room.x >= ui.px(700);
  const float left = beside ? std::floor(0.46F * room.x) : 0.0F;
  const float high = std::max(room.y - below, ui.px(120));
  ImGui::BeginChild("settings", {left, beside ? high : std::floor(0.5F * high)});
  bool changed = draw_settings(ui, view);
  ImGui::EndChild();
  if (beside) ImGui::SameLine(0.0F, ui.px(14));
  ImGui::BeginChild("outcome", {0.0F, beside ? high : std::floor(0.5F * high) - ui.px(4)});
  draw_outcome(ui, state, view, ui.px(170));
  ImGui::EndChild();
  if (changed) requests.emplace_back(Command{workbench::ReadImport{settings_}});
  for (Request& request : draw_acts(ui, state, view)) requests.push_back(std::move(request));
  return requests;
}

}  // namespace trocar::ui
