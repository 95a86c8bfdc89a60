#include "engine/workbench/jobs/still_job.h"

#include <fmt/format.h>

namespace trocar::workbench {

ViewRequest view_of(const demonstration::Demonstration& demonstration, double at_s, const scene::Camera& camera) {
  ViewRequest view;
  view.pose = stage::pose_of(demonstration.sample_at(at_s));
  view.options.highlighted_block = demonstration.recording->provenance.block;
  view.camera = camera;
  return view;
}

Result<Image> render_still(Studio& studio, const StillRequest& request) {
  constexpr int kLeast = 16;
  constexpr int kMost = 8192;
  if (request.width < kLeast || request.height < kLeast || request.width > kMost || request.height > kMost) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("a picture must have {} to {} pixels a side, not {}×{}",
                                                         kLeast, kMost, request.width, request.height));
  }
  const demonstration::Demonstration& shown = *request.demonstration;
  if (shown.gated().empty()) {
    return fail(ErrorCode::kInvalidArgument, fmt::format("\"{}\" has no samples to show", shown.name));
  }
  ViewRequest view = view_of(shown, request.at_s, scene::camera(request.camera));
  if (request.path) {
    view.paths = std::make_shared<const std::vector<stage::PathLayer>>(std::vector<stage::PathLayer>{
        stage::path_of(shown, kinematics::ArmSide::kLeft), stage::path_of(shown, kinematics::ArmSide::kRight)});
  }
  view.render = {request.width, request.height, 4, true, true};
  return studio.picture(view);
}

}  // namespace trocar::workbench
