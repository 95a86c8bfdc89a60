#include "engine/workbench/view_director.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "engine/core/same_object.h"
#include "engine/figure/field_figure.h"
#include "engine/figure/outcome_colours.h"
#include "engine/learning/field.h"
#include "engine/workbench/rolling.h"
#include "engine/workbench/whiskers.h"

namespace trocar::workbench {
namespace {

constexpr double kSettle_s = 0.150;
constexpr Rgba kStepsBack{128, 132, 140, 255};  ///< Of what steps back: what was before, what is not brushed.
constexpr double kLivePeriod_s = 1.0 / 15.0;

/// Where a rollout has come to: a knob at the end of its way.
stage::PathLayer head_at(const Eigen::Vector3d& p_W, Rgba colour, double radius_m) {
  const Eigen::Vector3d up(0.0, 0.0, 0.5 * radius_m);
  stage::PathLayer head;
  head.radius_m = radius_m;
  head.colours = {colour};
  head.points = {p_W - up, p_W + up};
  return head;
}

void add_rollout(const learning::Rollout& rollout, const spatial::Grid& grid, const RolloutSettings& how, Rgba colour,
                 double radius_m, std::vector<stage::PathLayer>& paths) {
  stage::PathLayer path;
  path.radius_m = radius_m;
  path.colours = {colour};
  path.points = learning::way_until(rollout, grid, steps_taken(rollout, how));
  if (how.reach) paths.push_back(head_at(path.points.back(), colour, radius_m + 0.0006));
  if (path.points.size() > 1) paths.push_back(std::move(path));
}

void add_ghosts(const PathsRequest& request, std::vector<stage::PathLayer>& paths) {
  const ModelInsight& insight = *request.rollouts;
  const std::vector<learning::Rollout>& ghosts = request.of_second ? insight.second->ghosts : insight.ghosts;
  const auto& selected = request.of_second ? insight.second->selected : insight.selected;
  const spatial::Grid& grid = insight.entry->model->grid;
  const auto colour = [](const learning::Rollout& one) { return figure::outcome_colour(one.end); };
  const auto& clearance_m = insight.clearance_m;
  const std::span<const double> by_cell =
      clearance_m ? std::span<const double>(*clearance_m) : std::span<const double>();
  for (std::size_t i = 0; i < ghosts.size(); ++i) {
    if (ghosts[i].cells.size() < 2) continue;
    // The second model's begin where the first one's do, and it is by the first one's measures that one brushes.
    if (learning::lies_in(insight.ghosts[i], request.how.brushed, grid, by_cell)) {
      add_rollout(ghosts[i], grid, request.how, colour(ghosts[i]), 0.00025, paths);
    } else {
      add_rollout(ghosts[i], grid, request.how, kStepsBack, 0.0001, paths);
    }
  }
  if (!selected || selected->cells.size() < 2) return;
  // What stands out is thick, in the colour of its end as all others.
  add_rollout(*selected, grid, request.how, colour(*selected), 0.001, paths);
}

/// Where the tools went before the edit that is shown.
void add_ghost_of(const demonstration::Demonstration& before, std::vector<stage::PathLayer>& paths) {
  for (const kinematics::ArmSide side : {kinematics::ArmSide::kLeft, kinematics::ArmSide::kRight}) {
    stage::PathLayer ghost = stage::path_of(before, side);
    ghost.colours = {kStepsBack};
    ghost.radius_m *= 0.6;
    paths.push_back(std::move(ghost));
  }
}

/// Where the tools go, and went before an edit or in what they are compared with.
std::shared_ptr<const std::vector<stage::PathLayer>> tool_paths(const PathsRequest& request) {
  auto paths = std::make_shared<std::vector<stage::PathLayer>>();
  if (!request.shown || request.shown->gated().empty()) return paths;
  paths->push_back(stage::path_of(*request.shown, kinematics::ArmSide::kLeft));
  paths->push_back(stage::path_of(*request.shown, kinematics::ArmSide::kRight));
  if (request.comparison && request.comparison->of.after == request.shown) {
    add_ghost_of(*request.comparison->of.before, *paths);
    add_whiskers(*request.comparison->comparison, *paths);
  } else if (request.before) {
    add_ghost_of(*request.before, *paths);
  }
  return paths;
}

/// The comparison that is to be drawn, null if none is; not before it is of what is shown.
std::shared_ptr<const ComparisonView> drawn_comparison(const WorkbenchState& state) {
  if (!state.comparing || !state.comparing->in_view || !state.comparison || !state.comparison->comparison) {
    return nullptr;
  }
  return state.comparison;
}

/// As an edit that is being made would leave it, if one is.
std::shared_ptr<const demonstration::Demonstration> selected(const WorkbenchState& state) {
  if (!state.project) return nullptr;
  if (state.preview && state.preview->after) return state.preview->after;
  const auto found = state.project->demonstrations.find(state.demonstration);
  return found == state.project->demonstrations.end() ? nullptr : found->second;
}

PathsRequest paths_of(const WorkbenchState& state) {
  PathsRequest request;
  if (state.live) return request;
  request.shown = selected(state);
  if (state.preview && state.preview->after) request.before = state.preview->before;
  request.comparison = drawn_comparison(state);
  if (!state.rollouts.ghosts) return request;
  request.rollouts = state.insight;
  request.how.pace = state.rollouts.pace;
  request.how.reach = state.rollouts.reach;
  request.how.brushed = state.rollouts.brushed;
  return request;
}

/// The last sample at or before `t_s`, also outside of the gates. Precondition: there are samples.
demonstration::Sample sample_anywhere(const demonstration::Demonstration& shown, double t_s) {
  const std::size_t after = shown.samples.lower_bound(shown.tick_after(t_s));
  return shown.samples[after == 0 ? 0 : after - 1];
}

/// Two instants of a cut have the halves before two models have.
bool shows_second(const WorkbenchState& state) {
  return state.learning.second_in_view && !state.live && !state.edges && state.insight && state.insight->field &&
         state.insight->second;
}

/// Those that were put beneath the field; none before they are worked out.
void add_layers(const WorkbenchState& state, const ModelInsight& insight, ViewRequest& request) {
  for (std::size_t i = 0; i < std::min(state.field_layers.size(), insight.layers.size()); ++i) {
    const FieldSettings& layer = state.field_layers[i];
    const ShownField of{layer.layer, layer.mask};
    if (!layer.visible || insight.layers_of[i] != of) continue;
    request.fields.push_back(field_layer(insight.layers[i], layer, {insight.entry->model, insight.policy}));
  }
}

void add_fields(const WorkbenchState& state, ViewRequest& request) {
  if (state.live || !state.insight || !state.insight->field) return;
  const ModelInsight& insight = *state.insight;
  if (shows_second(state)) request.beside = {request.pose, {}, {}};
  const bool any = std::any_of(state.field_layers.begin(), state.field_layers.end(),
                               [](const FieldSettings& layer) { return layer.visible; });
  if (!state.field.visible && !any) return;
  request.options.lattice_frame = true;
  add_layers(state, insight, request);
  if (!state.field.visible) {
    if (request.beside) request.beside->fields = request.fields;
    return;
  }
  request.fields.push_back(field_layer(insight.field, state.field, {insight.entry->model, insight.policy}));
  if (!shows_second(state)) {
    if (request.beside) request.beside->fields = request.fields;
    return;
  }
  const SecondModel& second = *insight.second;
  const plot::Colouring shared = shared_colouring(*insight.field, *second.field, state.field);
  request.fields.back().colouring = shared;
  request.beside->fields.push_back(field_layer(second.field, state.field, {second.entry->model, second.policy}));
  request.beside->fields.back().colouring = shared;
}

}  // namespace

scene::Camera camera_of(const WorkbenchState& state) {
  return state.camera_preset ? scene::camera(*state.camera_preset) : state.orbit.camera();
}

ViewDirector::ViewDirector()
    : ready_(ready_stage()), worker_([] {
        auto studio = std::make_shared<Result<Studio>>(Studio::create());
        auto paths = std::make_shared<PathMaker>();
        return [studio, paths](const Asked& asked) -> Answer {
          if (!*studio) return {nullptr, studio->error().text(), {}, {}};
          ViewRequest request = asked.view;
          request.paths = paths->make(asked.paths);
          if (request.beside) request.beside->paths = asked.beside ? paths->make(*asked.beside) : request.paths;
          Result<Image> image = (*studio)->picture(request);
          if (!image) return {nullptr, image.error().text(), {}, {}};
          return {std::make_shared<const Image>(std::move(*image)), {}, asked.edges, asked.models};
        };
      }) {}

void ViewDirector::resize(int width, int height) {
  width_ = std::clamp(width, 16, 4096);
  height_ = std::clamp(height, 16, 4096);
}

bool ViewDirector::poll(WorkbenchState& state, double now_s) {
  const Shown wanted = shown_by(state);
  const bool changed = !(wanted == requested_);
  const bool early = state.live && now_s - requested_at_s_ < kLivePeriod_s;
  const bool settled = coarse_ && now_s - requested_at_s_ >= kSettle_s;
  if (!worker_.pending() && !early && (changed || settled)) {
    ViewRequest request = request_for(state);
    // The first picture and moving ones are coarse; what stands still is worth four samples.
    coarse_ = changed;
    request.render.samples = coarse_ ? 1 : 4;
    request.render.soft_shadows = !coarse_;
    request.coarse = coarse_;
    Asked asked{std::move(request), paths_of(state), wanted.edges, {}, {}};
    if (shows_second(state)) {
      asked.models = {state.insight->entry->name, state.insight->second->entry->name};
      if (asked.paths.rollouts) asked.beside = asked.paths;
      if (asked.beside) asked.beside->of_second = true;
    }
    worker_.request(std::move(asked));
    requested_ = wanted;
    requested_at_s_ = now_s;
  }
  const bool arrived = worker_.update();
  if (arrived) {
    const Answer& answer = worker_.answer();
    if (answer.image) {
      state.picture = answer.image;
      state.picture_edges = answer.edges;
      state.picture_models = answer.models;
      ++state.picture_number;
    }
    state.picture_error = answer.error;
  }
  state.picture_pending = worker_.pending();
  return arrived;
}

bool ViewDirector::busy() const {
  return coarse_ || worker_.pending();
}

ViewDirector::Shown ViewDirector::shown_by(const WorkbenchState& state) const {
  Shown shown;
  shown.demonstration = selected(state).get();
  shown.playhead_s = state.playhead_s;
  if (!state.live && shown.demonstration != nullptr) shown.edges = state.edges;
  shown.insight = state.insight.get();
  shown.comparison = drawn_comparison(state).get();
  shown.second = shows_second(state);
  shown.field = state.field;
  shown.layers = state.field_layers;
  shown.rollouts = state.rollouts;
  shown.X_WC = camera_of(state).X_WC.matrix();
  shown.live_tick = state.live ? state.live->world.tick.count : -1;
  shown.light = state.light_backdrop;
  shown.width = width_;
  shown.height = height_;
  return shown;
}

ViewRequest ViewDirector::request_for(const WorkbenchState& state) const {
  ViewRequest request;
  const auto demonstration = selected(state);
  if (state.live) {
    request.pose = stage::pose_of(state.live->world);
    if (state.take) request.options.highlighted_block = state.take->request.options.block;
  } else if (demonstration && !demonstration->gated().empty()) {
    request.pose = stage::pose_of(state.edges ? sample_anywhere(*demonstration, state.edges->begin_s)
                                              : demonstration->sample_at(state.playhead_s));
    if (state.edges) request.beside = {stage::pose_of(sample_anywhere(*demonstration, state.edges->end_s)), {}, {}};
    request.options.highlighted_block = demonstration->recording->provenance.block;
  } else {
    request.pose = ready_;
  }
  add_fields(state, request);
  request.camera = shows_second(state) ? half_camera(camera_of(state)) : camera_of(state);
  request.options.light_ground = state.light_backdrop;
  request.render.width = width_;
  request.render.height = height_;
  return request;
}

bool PathMaker::Kept::same_tools(const PathsRequest& request) const {
  return same_object(shown, request.shown) && same_object(before, request.before) &&
         same_object(comparison, request.comparison);
}

bool PathMaker::Kept::is_of(const PathsRequest& request) const {
  return same_tools(request) && same_object(rollouts, request.rollouts) && of_second == request.of_second &&
         how == request.how;
}

std::shared_ptr<const std::vector<stage::PathLayer>> PathMaker::make(const PathsRequest& request) {
  Paths tools;
  for (auto kept = kept_.begin(); kept != kept_.end(); ++kept) {
    if (!kept->same_tools(request)) continue;
    if (!kept->is_of(request)) {
      tools = kept->tools;
      continue;
    }
    std::rotate(kept_.begin(), kept, kept + 1);
    return kept_.front().paths;
  }
  if (!tools) tools = tool_paths(request);
  Paths all = tools;
  if (request.rollouts) {
    auto paths = std::make_shared<std::vector<stage::PathLayer>>(*tools);
    add_ghosts(request, *paths);
    all = std::move(paths);
  }
  kept_.push_front({request.shown, request.before, request.comparison, request.rollouts, request.of_second, request.how,
                    std::move(tools), std::move(all)});
  if (kept_.size() > kKeptPaths) kept_.pop_back();
  return kept_.front().paths;
}

}  // namespace trocar::workbench
