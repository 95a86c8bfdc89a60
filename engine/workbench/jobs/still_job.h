/// One picture of a demonstration at one moment, for the command line and reports.
#pragma once

#include "engine/core/image.h"
#include "engine/core/result.h"
#include "engine/demonstration/demonstration.h"
#include "engine/scene/scene.h"
#include "engine/workbench/studio.h"

namespace trocar::workbench {

struct StillRequest {
  std::shared_ptr<const demonstration::Demonstration> demonstration;
  double at_s = 0.0;  ///< Kept within the gates.
  scene::CameraPreset camera = scene::CameraPreset::kPaper;
  int width = 1280;
  int height = 720;
  bool path = true;  ///< Draw the tips' paths.
};

/// The view of a demonstration at a moment. Precondition: it has gated samples.
ViewRequest view_of(const demonstration::Demonstration& demonstration, double at_s, const scene::Camera& camera);

/// Threads: that of the studio. Errors: kInvalidArgument for a size outside of 16 … 8192 or an empty demonstration.
Result<Image> render_still(Studio& studio, const StillRequest& request);

}  // namespace trocar::workbench
