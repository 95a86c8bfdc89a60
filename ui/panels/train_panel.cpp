#include "ui/panels/train_panel.h"

#include <array>

#include "ui/format.h"
#include "ui/icons.h"
#include "ui/panels/common.h"

namespace trocar::ui {
namespace {

constexpr std::array<learning::Method, 3> kMethods{learning::Method::kEgMaxent, learning::Method::kEgMaxentPlus,
                                                   learning::Method::kExact};

// The agent's segments (paper, Fig. 1).
constexpr std::array<demonstration::Segment, 2> kSegments{demonstration::Segment::kA, demonstration::Segment::kC};

std::string_view method_help(int method) {
  if (method == 0) return "The paper's Algorithm 1: exploration by ε-greedy episodes";
  if (method == 1) return "Algorithm 1 with starts spread around the expert's";
  return "Maximum entropy without sampling: the same result each time";
}

}  // namespace

void TrainPanel::draw_choice(Ui& ui, const WorkbenchState& state) {
  const Scope scope(ui, "Demonstrations");
  heading(ui, "Learn from");
  const demonstration::Segment segment = kSegments[static_cast<std::size_t>(segment_)];
  UniqueNames unique;
  for (const auto& [id, shown] : state.project->demonstrations) {
    bool chosen = !left_out_.contains(id);
    const bool has = shown->segment(segment).has_value();
    if (!has) chosen = false;
    ImGui::PushID(static_cast<int>(id.value));
    const std::string why = has ? "" : std::string("It has no segment ") + demonstration::letter(segment);
    if (checkbox(ui, unique(shown->name), chosen, {.reason = why})) {
      if (chosen) {
        left_out_.erase(id);
      } else {
        left_out_.insert(id);
      }
    }
    ImGui::PopID();
  }
}

void TrainPanel::draw_options(Ui& ui) {
  static const std::vector<std::string> kMethodNames{"eg-maxent", "eg-maxent+", "exact"};
  static const std::vector<std::string> kSegmentNames{"A  approach", "C  transfer"};
  heading(ui, "Method");
  segmented(ui, "Method", method_, kMethodNames, {.help = method_help(method_)});
  wrapped_text(ui, method_help(method_), ui.theme().text_dim);
  form_label(ui, "Segment");
  segmented(ui, "Segment", segment_, kSegmentNames, {.help = "The agent's segments of the transfer"});
  const std::string_view sampled = method_ == 2 ? "The exact method does not sample" : "";
  form_label(ui, "ε");
  slider_float(ui, "Epsilon", epsilon_, 0.0F, 0.5F, "%.2f",
               {.help = "Share of random actions while learning; the paper uses 0 to 0.1", .reason = sampled});
  form_label(ui, "Episodes");
  number_field(ui, "Episodes", episodes_, 1, 1'000'000, {.help = "The paper uses 10,000", .reason = sampled});
  form_label(ui, "Seed");
  number_field(ui, "Seed", seed_, 0, 1'000'000'000, {.help = "The same seed gives the same model"});
  form_label(ui, "Cells a side");
  number_field(ui, "Grid", grid_, 8, 88, {.help = "22 is the paper's lattice of 2.5 mm"});
  form_label(ui, "Name");
  text_field(ui, "Name", name_, "From method and segment");
}

std::string TrainPanel::reason(const WorkbenchState& state) const {
  if (state.project->demonstrations.empty()) return "There is no demonstration to learn from";
  const demonstration::Segment segment = kSegments[static_cast<std::size_t>(segment_)];
  for (const auto& [id, shown] : state.project->demonstrations) {
    if (!left_out_.contains(id) && shown->segment(segment)) return "";
  }
  return "No demonstration is chosen";
}

Requests TrainPanel::draw(Ui& ui, const WorkbenchState& state) {
  Requests requests;
  if (draw_no_project(ui, state, requests)) return requests;
  if (state.project->demonstrations.empty()) {
    const std::string reason = command("demo.record").reason_now(state);
    const std::array<EmptyStateAction, 1> actions{{{"Record…", icon::kRecord, reason, "Record a transfer"}}};
    if (empty_state(ui, icon::kTrain, "Nothing to learn from", "A model is learned from demonstrations", actions) ==
        0) {
      requests.emplace_back(UiAction::kShowRecord);
    }
    return requests;
  }
  draw_options(ui);
  ImGui::Dummy({0.0F, ui.px(2)});
  draw_choice(ui, state);
  ImGui::Dummy({0.0F, ui.px(6)});
  const std::string why = reason(state);
  if (button(ui, "Train",
             {.icon = icon::kTrain,
              .help = "Start the training; it runs beside your work",
              .reason = why,
              .width = -1.0F,
              .style = ButtonStyle::kPrimary})) {
    workbench::TrainModel train;
    train.segment = kSegments[static_cast<std::size_t>(segment_)];
    for (const auto& [id, shown] : state.project->demonstrations) {
      if (!left_out_.contains(id) && shown->segment(train.segment)) train.demonstrations.push_back(id);
    }
    train.options.method = kMethods[static_cast<std::size_t>(method_)];
    train.options.epsilon = static_cast<double>(epsilon_);
    train.options.episodes = static_cast<int>(episodes_);
    train.options.seed = static_cast<std::uint64_t>(seed_);
    train.grid = static_cast<int>(grid_);
    train.name = name_;
    requests.emplace_back(workbench::Command{train});
  }
  return requests;
}

}  // namespace trocar::ui
