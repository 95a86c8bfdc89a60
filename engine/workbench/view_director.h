/// Decides what the 3-D view shows and how finely, and has the picture thread draw it.
#pragma once

#include <array>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/workbench/latest_worker.h"
#include "engine/workbench/studio.h"
#include "engine/workbench/workbench_state.h"

namespace trocar::workbench {

/// What the paths in a view are of.
struct PathsRequest {
  std::shared_ptr<const demonstration::Demonstration> shown;   ///< Null: none is.
  std::shared_ptr<const demonstration::Demonstration> before;  ///< Of the edit that is being made; null without one.
  std::shared_ptr<const ComparisonView> comparison;            ///< That is drawn, if one is.
  std::shared_ptr<const ModelInsight> rollouts;                ///< Whose rollouts are drawn, if any are …
  bool of_second = false;                                      ///< … those of its second model.
  RolloutSettings how;                                         ///< How far they have come.
};

/// So many versions are remembered, for undo and redo.
constexpr std::size_t kKeptPaths = 3;

/// Those of an hour take a while, so that it is left to the picture thread.
/// Threads: one at a time.
class PathMaker {
 public:
  std::shared_ptr<const std::vector<stage::PathLayer>> make(const PathsRequest& request);

 private:
  using Paths = std::shared_ptr<const std::vector<stage::PathLayer>>;
  /// As of `PathsRequest`; a version that nobody shows any more is not to stay in memory for this.
  struct Kept {
    std::weak_ptr<const demonstration::Demonstration> shown;
    std::weak_ptr<const demonstration::Demonstration> before;
    std::weak_ptr<const ComparisonView> comparison;
    std::weak_ptr<const ModelInsight> rollouts;
    bool of_second = false;
    RolloutSettings how;
    Paths tools;  ///< Without the rollouts, which are played over them.
    Paths paths;
    bool same_tools(const PathsRequest& request) const;
    bool is_of(const PathsRequest& request) const;
  };
  std::deque<Kept> kept_;  ///< The newest comes first.
};

/// Keeps the view fluent: coarse pictures while something moves, a fine one once it has stood still for 150 ms, and no
/// more than 15 a second while the simulator needs a core. Threads: the main thread.
class ViewDirector {
 public:
  ViewDirector();

  void resize(int width, int height);
  int width() const { return width_; }
  int height() const { return height_; }

  /// Requests a picture if `state` differs from what was last drawn, and takes in one that is ready. True if it did.
  bool poll(WorkbenchState& state, double now_s);
  /// True while a newer or finer picture is still to come.
  bool busy() const;

 private:
  struct Answer {
    std::shared_ptr<const Image> image;
    std::string error;
    std::optional<TimeSpan> edges;                     ///< What it shows …
    std::optional<std::array<std::string, 2>> models;  ///< … and of which models.
  };
  /// What a picture was made of, to tell whether a new one is needed.
  struct Shown {
    const void* demonstration = nullptr;
    double playhead_s = -1.0;
    std::optional<TimeSpan> edges;
    const void* insight = nullptr;
    const void* comparison = nullptr;  ///< Null where it is not drawn.
    bool second = false;               ///< The second model, too.
    FieldSettings field;
    std::vector<FieldSettings> layers;
    RolloutSettings rollouts;
    Eigen::Matrix4d X_WC = Eigen::Matrix4d::Zero();
    std::int64_t live_tick = -1;
    bool light = false;
    int width = 0;
    int height = 0;
    bool operator==(const Shown&) const = default;
  };

  Shown shown_by(const WorkbenchState& state) const;
  ViewRequest request_for(const WorkbenchState& state) const;

  int width_ = 960;
  int height_ = 540;
  stage::Pose3d ready_;
  Shown requested_;
  double requested_at_s_ = -1.0;
  bool coarse_ = true;
  struct Asked {
    ViewRequest view;  ///< Without paths.
    PathsRequest paths;
    std::optional<TimeSpan> edges;
    std::optional<PathsRequest> beside;  ///< Of the right half, where it has other models.
    std::optional<std::array<std::string, 2>> models;
  };
  LatestWorker<Asked, Answer> worker_;
};

/// The camera that the state asks for.
scene::Camera camera_of(const WorkbenchState& state);

}  // namespace trocar::workbench
