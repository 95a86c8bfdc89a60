/// Decides what the 3-D view shows and how finely, and has the picture thread draw it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/workbench/latest_worker.h"
#include "engine/workbench/studio.h"
#include "engine/workbench/workbench_state.h"

namespace trocar::workbench {

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
    std::optional<TimeSpan> edges;  ///< What it shows.
  };
  /// What a picture was made of, to tell whether a new one is needed.
  struct Shown {
    const void* demonstration = nullptr;
    double playhead_s = -1.0;
    std::optional<TimeSpan> edges;
    const void* insight = nullptr;
    const void* comparison = nullptr;  ///< Null where it is not drawn.
    FieldSettings field;
    RolloutSettings rollouts;
    Eigen::Matrix4d X_WC = Eigen::Matrix4d::Zero();
    std::int64_t live_tick = -1;
    bool light = false;
    int width = 0;
    int height = 0;
    bool operator==(const Shown&) const = default;
  };

  Shown shown_by(const WorkbenchState& state) const;
  ViewRequest request_for(const WorkbenchState& state);
  std::shared_ptr<const std::vector<stage::PathLayer>> paths_for(const WorkbenchState& state);

  int width_ = 960;
  int height_ = 540;
  stage::Pose3d ready_;
  Shown requested_;
  double requested_at_s_ = -1.0;
  bool coarse_ = true;
  const void* paths_demonstration_ = nullptr;
  const void* paths_insight_ = nullptr;
  const void* paths_comparison_ = nullptr;
  bool paths_ghosts_ = false;
  std::shared_ptr<const std::vector<stage::PathLayer>> paths_;
  struct Asked {
    ViewRequest view;
    std::optional<TimeSpan> edges;
  };
  LatestWorker<Asked, Answer> worker_;
};

/// The camera that the state asks for.
scene::Camera camera_of(const WorkbenchState& state);

}  // namespace trocar::workbench
