#include "ui/panels/model_state.h"

#include <fmt/format.h>

#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

using workbench::Command;

void draw_following(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const workbench::ModelInsight& insight = *state.insight;
  const workbench::Following& following = *insight.following;
  if (!following.error.empty()) {
    badge(ui, icon::kWarning, "does not follow: " + following.error, ui.theme().warning);
    return;
  }
  const std::string words =
      following.cells_changed == 0
          ? std::string("follows the edit: no cell of the demonstration changed")
          : fmt::format(
                "follows the edit: learned anew in {}, {} cells of the demonstration and {} of the policy changed",
                elapsed(following.seconds), count(following.cells_changed), count(following.policy_changed));
  badge(
      ui, icon::kRefresh, words, ui.theme().accent,
      "The model of the method exact is solved again while its demonstration is edited; the stored one stays as it is");
  const std::string reason = state.preview ? "Apply the edit first" : std::string(being_recorded(state));
  if (following.cells_changed > 0 &&
      button(ui, "Keep as a model",
             {.icon = icon::kTrain, .help = "Train with the same settings on what is there now", .reason = reason})) {
    workbench::TrainModel train;
    train.segment = insight.entry->segment;
    train.demonstrations = insight.entry->demonstrations;
    train.options = insight.entry->model->options;
    train.grid = insight.entry->model->grid.n;
    requests.emplace_back(Command{train});
  }
}

}  // namespace

void draw_model_state(Ui& ui, const WorkbenchState& state, Requests& requests) {
  const Scope scope(ui, "Model state");
  const workbench::ModelInsight& insight = *state.insight;
  if (insight.epoch < insight.epochs) {
    badge(ui, icon::kClock, fmt::format("as it was after epoch {} of {}", insight.epoch, insight.epochs),
          ui.theme().accent);
    if (button(ui, "Show the end",
               {.icon = icon::kVerify, .help = "Show the model as it was when the training ended"})) {
      workbench::LearningSettings settings = state.learning;
      settings.epoch = -1;
      requests.emplace_back(Command{workbench::SetLearning{settings}});
    }
    return;
  }
  if (insight.following) {
    draw_following(ui, state, requests);
  } else if (insight.stale) {
    badge(ui, icon::kWarning, "stale: a demonstration was edited since training", ui.theme().warning);
  }
}

}  // namespace trocar::ui
