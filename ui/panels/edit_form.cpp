#include "ui/panels/edit_form.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/demonstration/problems.h"
#include "engine/demonstration/sampling_rate.h"
#include "engine/demonstration/time_warp.h"
#include "engine/review/review.h"
#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using demonstration::Demonstration;
using demonstration::DemonstrationId;
using demonstration::Edit;
using demonstration::EditOption;
using workbench::Command;
using workbench::CommitEdit;

/// Where an edit is most likely wanted: over what is selected, else all between the gates; in the middle at the
/// playhead.
std::string likely(const EditOption& option, const Demonstration& shown, const WorkbenchState& state) {
  const double playhead_s = state.playhead_s;
  if (option.option == "from") return fmt::format("{:.3f}", state.selection ? state.selection->begin_s : shown.begin_s);
  if (option.option == "to") return fmt::format("{:.3f}", state.selection ? state.selection->end_s : shown.end_s);
  if (option.option == "clip-from") return fmt::format("{:.3f}", shown.begin_s);
  if (option.option == "clip-to") return fmt::format("{:.3f}", shown.end_s);
  if (option.option == "at") return fmt::format("{:.3f}", playhead_s);
  if (option.option == "block" && shown.block != demonstration::kUnknownPlace) return std::to_string(shown.block);
  if (option.option == "goal" && shown.goal != demonstration::kUnknownPlace) return std::to_string(shown.goal);
  return option.text;
}

/// Where a bridge is most likely wanted when nothing is selected: over the gap next to the playhead, else half a second
/// about it. Never over all of it.
workbench::TimeSpan likely_bridge(const Demonstration& shown, double playhead_s) {
  constexpr double kHalf_s = 0.25;
  workbench::TimeSpan best{std::max(playhead_s - kHalf_s, shown.begin_s), std::min(playhead_s + kHalf_s, shown.end_s)};
  double nearest_s = 2.0;  // Farther ones are not meant.
  const demonstration::SampleTrack samples = shown.gated();
  for (const demonstration::SampleGap& gap : demonstration::sample_gaps(samples)) {
    const double begin_s = shown.time_of(samples[gap.after - 1]);
    const double end_s = shown.time_of(samples[gap.after]);
    const double away_s = std::max({begin_s - playhead_s, playhead_s - end_s, 0.0});
    if (away_s >= nearest_s) continue;
    nearest_s = away_s;
    best = {begin_s, end_s};
  }
  return best;
}

/// A demonstration is chosen by name; its number behind it tells apart those of one name.
constexpr std::string_view kBeforeNumber = " · ";

std::string choice_of(const Demonstration& demonstration) {
  return fmt::format("{}{}{}", demonstration.name, kBeforeNumber, demonstration.id.value);
}

bool names_demonstration(const EditOption& option) {
  return option.option == "source";
}

/// In place of a bare number; one that the project does not have stays.
void offer_demonstrations(std::vector<EditOption>& options, const workbench::Project& project, DemonstrationId shown) {
  for (EditOption& option : options) {
    if (!names_demonstration(option)) continue;
    if (option.text == "0") option.text = std::to_string(shown.value);
    for (const auto& [id, demonstration] : project.demonstrations) {
      option.choices.push_back(choice_of(*demonstration));
      if (option.text == std::to_string(id.value)) option.text = option.choices.back();
    }
  }
}

bool names_model(const EditOption& option) {
  return option.option == "model";
}

/// Likewise; 0 leaves it to the segment.
void offer_models(std::vector<EditOption>& options, const workbench::Project& project) {
  for (EditOption& option : options) {
    if (!names_model(option)) continue;
    option.choices.push_back(fmt::format("Newest of the segment{}0", kBeforeNumber));
    if (option.text == "0") option.text = option.choices.back();
    for (const auto& [id, entry] : project.models) {
      option.choices.push_back(fmt::format("{}{}{}", entry->name, kBeforeNumber, id.value));
      if (option.text == std::to_string(id.value)) option.text = option.choices.back();
    }
  }
}

bool says(const std::vector<EditOption>& options, std::string_view option, std::string_view text) {
  return std::any_of(options.begin(), options.end(),
                     [&](const EditOption& each) { return each.option == option && each.text == text; });
}

/// What a parameter depends on: without it, it means nothing.
struct Condition {
  std::string_view edit;
  std::string_view option;
  std::string_view on;
  std::string_view text;
  bool is = true;  ///< The other has that text; or has not.
};
constexpr std::array<Condition, 9> kConditions{{{"retime", "scale", "mode", "scale"},
                                                {"retime", "duration", "mode", "duration"},
                                                {"retime", "speed-mm-s", "mode", "speed"},
                                                {"retime", "knots", "mode", "warp"},
                                                {"bridge", "via-mm", "shape", "policy", false},
                                                {"bridge", "model", "shape", "policy"},
                                                {"splice", "peg", "align", "peg"},
                                                {"revert", "arms", "what", "labels", false},
                                                {"trim-idle", "keep", "keep-samples", "0"}}};

bool is_of_use(std::string_view edit, const std::vector<EditOption>& options, const EditOption& option) {
  return std::all_of(kConditions.begin(), kConditions.end(), [&](const Condition& each) {
    if (each.edit != edit || each.option != option.option) return true;
    // Both modes of a speed need one.
    if (each.text == "speed") return says(options, "mode", "speed-cap") || says(options, "mode", "constant-speed");
    return says(options, each.on, each.text) == each.is;
  });
}

EditOption* option_named(std::vector<EditOption>& options, std::string_view name) {
  const auto found =
      std::find_if(options.begin(), options.end(), [&](const EditOption& each) { return each.option == name; });
  return found == options.end() ? nullptr : &*found;
}

/// Of one act, as on the command line.
constexpr std::int64_t kMostCopies = 1000;

/// Times as they are typed, to the millisecond.
double whole_ms(double t_s) {
  return std::round(1e3 * t_s) / 1e3;
}

/// A check box for each stretch that is idle, and what stays of them in `stay`. True if that has changed.
bool draw_idle(Ui& ui, const std::vector<demonstration::IdleCut>& cuts, std::string& stay) {
  const Scope scope(ui, "Idle");
  bool changed = false;
  small_text(ui, cuts.empty() ? "Nothing is idle for long enough" : "Goes where it is checked", ui.theme().text_dim);
  for (const demonstration::IdleCut& cut : cuts) {
    bool goes = !cut.stays;
    const std::string label =
        fmt::format("{:.2f}–{:.2f} s, {}", cut.begin_s, cut.end_s, cut.at_end ? "an end" : "inside");
    if (!checkbox(ui, label, goes, {.help = fmt::format("{:.2f} s of it", cut.to_s - cut.from_s)})) continue;
    changed = true;
    std::vector<double> times;
    const Result<Edit> now = demonstration::edit_from_words({"trim-idle", "--stay=" + stay});
    if (now) times = std::get<demonstration::TrimIdle>(*now).stay_s;
    std::erase_if(times, [&](double t_s) { return t_s >= cut.begin_s && t_s <= cut.end_s; });
    if (!goes) times.push_back(whole_ms(cut.middle_s()));
    stay = fmt::format("{}", fmt::join(times, ","));
  }
  return changed;
}

Result<Edit> edit_of(std::string_view name, std::vector<EditOption> options) {
  const bool policy = says(options, "shape", "policy");
  for (EditOption& option : options) {
    if (policy && option.option == "via-mm") option.text.clear();
    const std::size_t at = option.text.rfind(kBeforeNumber);
    if ((names_demonstration(option) || names_model(option)) && at != std::string::npos) {
      option.text = option.text.substr(at + kBeforeNumber.size());
    }
  }
  return demonstration::edit_from_options(name, options);
}

/// "2 errors, 5 warnings; before 3, 5".
std::string problems_with(const WorkbenchState& state) {
  using demonstration::Severity;
  const auto& after = state.preview_review;
  if (!after || after->of.document != state.preview->after) return "…";
  const auto counts = [](const workbench::ReviewView& view) {
    const auto& problems = view.review.problems;
    return std::pair{review::count_of(problems, Severity::kError), review::count_of(problems, Severity::kWarning)};
  };
  const auto [errors, warnings] = counts(*after);
  const std::string words = counted(errors, "error") + ", " + counted(warnings, "warning");
  if (!state.review) return words;
  const auto [errors_before, warnings_before] = counts(*state.review);
  return fmt::format("{}; before {}, {}", words, errors_before, warnings_before);
}

}  // namespace

void EditForm::begin(const Edit& edit, const workbench::Project& project, const Demonstration& shown,
                     std::int64_t entry) {
  draft_ = Draft{shown.id, entry,  std::string(demonstration::name_of(edit)), demonstration::options_of(edit), 0,
                 {},       nullptr};
  offer_demonstrations(draft_->options, project, shown.id);
  offer_models(draft_->options, project);
}

void EditForm::begin(const BeginEdit& asked, const WorkbenchState& state) {
  const auto shown = selected_demonstration(state);
  if (shown == nullptr) return;
  begin(asked.edit, *state.project, *shown, 0);
  draft_->copies = asked.copies;
  for (EditOption& option : draft_->options) option.text = likely(option, *shown, state);
  if (draft_->name != demonstration::Bridge::kName || state.selection) return;
  const workbench::TimeSpan span = likely_bridge(*shown, state.playhead_s);
  for (EditOption& option : draft_->options) {
    if (option.option == "from") option.text = fmt::format("{:.3f}", span.begin_s);
    if (option.option == "to") option.text = fmt::format("{:.3f}", span.end_s);
  }
}

void EditForm::request_preview(Requests& requests) {
  const Result<Edit> edit = edit_of(draft_->name, draft_->options);
  draft_->problem = edit ? "" : edit.error().text();
  if (edit) requests.emplace_back(Command{workbench::PreviewEdit{*edit, draft_->entry}});
}

void EditForm::end(Requests& requests) {
  draft_.reset();
  requests.emplace_back(Command{workbench::EndPreview{}});
}

void EditForm::commit(Requests& requests) {
  const Result<Edit> edit = edit_of(draft_->name, draft_->options);
  if (!edit) return;
  const auto id = draft_->demonstration;
  if (draft_->copies > 0) {
    workbench::CopyDemonstrations copies;
    auto noise = std::get<demonstration::Perturb>(*edit);
    for (std::int64_t nth = 0; nth < draft_->copies; ++nth, ++noise.seed) {
      copies.copies.push_back({id, "", {noise}});
    }
    requests.emplace_back(Command{CommitEdit{std::move(copies)}});
  } else if (draft_->entry == 0) {
    requests.emplace_back(Command{CommitEdit{workbench::EditDemonstration{id, *edit}}});
  } else {
    requests.emplace_back(Command{CommitEdit{workbench::ReplaceStackEntry{id, draft_->entry, *edit}}});
  }
  end(requests);
}

bool EditForm::draw_warp(Ui& ui) {
  EditOption& option = *option_named(draft_->options, "knots");
  const Result<Edit> now = edit_of(draft_->name, draft_->options);
  if (!now) return false;
  const auto& edit = std::get<demonstration::Retime>(*now);
  if (!(edit.from_s < edit.to_s)) return false;
  std::vector<Eigen::Vector2d> wanted = edit.knots_s;
  // A curve of one knot in the middle, for a beginning.
  const double middle_s = whole_ms(0.5 * (edit.from_s + edit.to_s));
  const bool none = wanted.empty();
  if (none) wanted.emplace_back(middle_s, middle_s);
  auto knots = demonstration::warp_knots(wanted, edit.from_s, edit.to_s);
  if (!knots) return false;
  knots->erase(knots->begin());
  if (!warp_.draw(ui, "Curve", edit.from_s, edit.to_s, *knots) && !none) return false;
  option.text.clear();
  for (const Eigen::Vector2d& knot : *knots) {
    option.text += fmt::format("{}{}:{}", option.text.empty() ? "" : ",", whole_ms(knot.x()), whole_ms(knot.y()));
  }
  return true;
}

bool EditForm::draw_option(Ui& ui, const WorkbenchState& state, EditOption& option) {
  if (draft_->name == demonstration::TrimIdle::kName && option.option == "stay") {
    return state.preview && draw_idle(ui, state.preview->idle, option.text);
  }
  const std::string label = option.unit.empty() ? option.label : fmt::format("{}, {}", option.label, option.unit);
  if (option.flag) {
    bool on = option.text == "yes";
    const bool changed = checkbox(ui, option.label, on, {.help = option.help});
    option.text = on ? "yes" : "no";
    return changed;
  }
  form_label(ui, label);
  if (option.choices.empty()) return text_field(ui, option.label, option.text, "", {.help = option.help});
  int chosen =
      static_cast<int>(std::find(option.choices.begin(), option.choices.end(), option.text) - option.choices.begin());
  if (!combo(ui, option.label, chosen, option.choices, {.help = option.help})) return false;
  option.text = option.choices[static_cast<std::size_t>(chosen)];
  return true;
}

void EditForm::draw_outcome(Ui& ui, const WorkbenchState& state) {
  if (!draft_->problem.empty()) return wrapped_text(ui, draft_->problem, ui.theme().danger);
  if (!state.preview) return dim_text(ui, "Working it out…");
  if (!state.preview->error.empty()) return wrapped_text(ui, state.preview->error, ui.theme().danger);
  const demonstration::Difference& difference = state.preview->difference;
  fact(ui, "Longer by", fmt::format("{:+.2f} s", difference.duration_change_s));
  fact(ui, "Moved", count(difference.moved) + " samples");
  fact(ui, "Furthest", fmt::format("{:.2f} mm", 1e3 * difference.max_deviation_m));
  fact(ui, "Deviation, RMS", fmt::format("{:.3f} mm", 1e3 * difference.rms_deviation_m));
  const demonstration::EditEffect& effect = state.preview->effect;
  fact(ui, "Peak speed",
       fmt::format("{:.0f} → {:.0f} of {:.0f} mm/s", 1e3 * effect.before.fastest_m_s(),
                   1e3 * effect.after.fastest_m_s(), 1e3 * demonstration::MotionBounds{}.speed_m_s));
  if (draft_->name == demonstration::Smooth::kName) {
    for (std::size_t arm = 0; arm < 2; ++arm) {
      fact(ui, arm == 0 ? "Raw jerk, left" : "Raw jerk, right",
           fmt::format("{:.3g} → {:.3g} m/s³", effect.before.mean_jerk_m_s3[arm], effect.after.mean_jerk_m_s3[arm]));
    }
  }
  fact(ui, "Problems", problems_with(state));
  for (const demonstration::SnapFigures& figures : state.preview->snap) {
    const char* tool = figures.arm == 0 ? "left" : "right";
    fact(ui, fmt::format("Actions, {}", tool), count(figures.actions));
    fact(ui, fmt::format("Error, {}", tool),
         fmt::format("max {:.2f}, mean {:.2f} mm", 1e3 * figures.max_error_m, 1e3 * figures.mean_error_m));
    fact(ui, fmt::format("Cells, {}", tool),
         fmt::format("{} skipped, {} repeated", figures.skipped_cells, figures.repeated_cells));
  }
  sentences(ui, icon::kWarning, effect.remarks, ui.theme().warning);
}

void EditForm::draw(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const Scope scope(ui, "Draft");
  {
    // Some edits are called as one of their fields.
    const Scope kind(ui, "Kind");
    heading(ui, draft_->copies > 0 ? std::string("Perturbed copies") : demonstration::title_of(draft_->name));
  }
  // Also when the demonstration has changed meanwhile, as by undo.
  const auto shown = selected_demonstration(state);
  bool changed = draft_->previewed != shown;
  draft_->previewed = shown;
  for (EditOption& option : draft_->options) {
    if (is_of_use(draft_->name, draft_->options, option)) changed |= draw_option(ui, state, option);
  }
  if (draft_->copies > 0) {
    form_label(ui, "Copies");
    number_field(ui, "Copies", draft_->copies, 1, kMostCopies,
                 {.help = "Each with noise of its own seed, counted up; the demonstration itself stays as it is"});
  }
  if (says(draft_->options, "mode", "warp")) changed |= draw_warp(ui);
  if (changed) request_preview(requests);
  ImGui::Dummy({0.0F, ui.px(2)});
  draw_outcome(ui, state);
  ImGui::Dummy({0.0F, ui.px(2)});
  std::string_view why = being_recorded(state);
  const bool impossible = !draft_->problem.empty() || (state.preview && !state.preview->error.empty());
  if (why.empty() && impossible) why = "The edit cannot be made as it is";
  const bool apply = button(ui,
                            draft_->entry != 0   ? "Change"
                            : draft_->copies > 0 ? "Make copies"
                                                 : "Apply",
                            {.icon = icon::kVerify,
                             .help = "Commit the edit; it can be undone, changed and switched off",
                             .shortcut = "Enter",
                             .reason = why,
                             .style = ButtonStyle::kPrimary});
  ImGui::SameLine();
  const bool cancel =
      button(ui, "Cancel", {.help = "Leave everything as it is", .shortcut = "Esc", .style = ButtonStyle::kQuiet});
  if (cancel || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape), false)) return end(requests);
  // Where no field is typed in and no widget is pressed by it.
  const bool entered =
      ui.input().pressed(Key::kEnter) && !ImGui::GetIO().WantTextInput && !ui.focus().shown() && why.empty();
  if (apply || entered) commit(requests);
}

}  // namespace trocar::ui
