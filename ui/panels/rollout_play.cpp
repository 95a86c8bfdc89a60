#include "ui/panels/rollout_play.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "ui/icons.h"
#include "ui/keymap.h"

namespace trocar::ui {
namespace {

using workbench::GhostPace;
using workbench::RolloutSettings;

constexpr double kSteps_s = 8.0;   ///< Steps in a second.
constexpr double kShare_s = 0.25;  ///< Of its way, in a second.
/// What was hidden for a while goes on where it was.
constexpr double kLongestFrame_s = 0.1;

/// Steps of the longest rollout that is drawn.
double longest_rollout(const workbench::ModelInsight& insight) {
  std::size_t cells = 2;
  for (const learning::Rollout& rollout : *insight.listed) cells = std::max(cells, rollout.cells.size());
  for (const learning::Rollout& rollout : insight.ghosts) cells = std::max(cells, rollout.cells.size());
  if (insight.selected) cells = std::max(cells, insight.selected->cells.size());
  return static_cast<double>(cells - 1);
}

}  // namespace

std::optional<double> RolloutPlay::next(const Ui& ui, const RolloutSettings& settings, double longest) {
  const double passed_s = std::clamp(ui.now_s() - shown_s_, 0.0, kLongestFrame_s);
  shown_s_ = ui.now_s();
  const bool by_length = settings.pace == GhostPace::kLength;
  const double reach = settings.reach.value_or(0.0) + passed_s * (by_length ? kShare_s : kSteps_s);
  if (reach < (by_length ? 1.0 : longest)) return reach;
  playing_ = false;
  return std::nullopt;
}

bool RolloutPlay::claims(const Ui& ui, const Chord& chord) {
  const std::span<const Chord> keys = ui.keymap().chords("transport.play");
  return !ui.focus().shown() && std::find(keys.begin(), keys.end(), chord) != keys.end();
}

bool RolloutPlay::key_pressed(const Ui& ui) const {
  if (ImGui::GetIO().WantTextInput || ui.focus().shown()) return false;
  if (!ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows)) return false;
  const std::span<const Chord> keys = ui.keymap().chords("transport.play");
  return std::any_of(keys.begin(), keys.end(), [&ui](const Chord& chord) { return pressed(ui.input(), chord); });
}

void RolloutPlay::draw(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const Scope scope(ui, "Play");
  static const std::vector<std::string> kPaces{"By step", "By length"};
  RolloutSettings settings = state.rollouts;
  const double longest = longest_rollout(*state.insight);
  form_label(ui, "Pace");
  int pace = static_cast<int>(settings.pace);
  if (segmented(
          ui, "Pace", pace, kPaces,
          {.help = "All take as many steps; or all have the same share of their way behind them, 0 to 100 %: as a "
                   "model is of one segment, that plays them segment by segment"})) {
    const bool by_length = static_cast<GhostPace>(pace) == GhostPace::kLength;
    if (settings.reach) *settings.reach *= by_length ? 1.0 / longest : longest;
    settings.pace = static_cast<GhostPace>(pace);
  }
  const bool clicked = icon_button(ui, playing_ ? "Pause" : "Play",
                                   {.icon = playing_ ? icon::kPause : icon::kPlay,
                                    .help = "All rollouts from their starts, together",
                                    .shortcut = shown_keys(ui, "transport.play")});
  if (clicked || key_pressed(ui)) {
    playing_ = !playing_;
    shown_s_ = ui.now_s();
    if (playing_ && !settings.reach) settings.reach = 0.0;
  } else if (playing_) {
    settings.reach = next(ui, settings, longest);
  }
  if (playing_) ui.animate();
  ImGui::SameLine(0.0F, ui.px(8));
  const bool by_length = settings.pace == GhostPace::kLength;
  const int most = by_length ? 100 : static_cast<int>(longest);
  const double unit = by_length ? 0.01 : 1.0;
  int at = settings.reach ? std::clamp(static_cast<int>(std::floor(*settings.reach / unit + 1e-6)), 0, most) : most;
  if (slider_int(ui, "Reached", at, 0, most, by_length ? "%d %% of the way" : "step %d",
                 {.help = "How far the rollouts have come", .width = -1.0F})) {
    playing_ = false;
    settings.reach = at == most ? std::nullopt : std::optional(unit * at);
  }
  if (settings != state.rollouts) requests.emplace_back(workbench::Command{workbench::SetRollouts{settings}});
}

}  // namespace trocar::ui
