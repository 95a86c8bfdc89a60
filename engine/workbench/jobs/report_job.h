/// What rollouts of one model, or of two, come to, on one page that needs no other file.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/workbench/project.h"

namespace trocar::workbench {

struct ReportRequest {
  std::vector<std::shared_ptr<const ModelEntry>> models;  ///< One or two, each with its model, of one lattice.
  std::string starts = "around:3";                        ///< As `learning::read_starts`, around the first model's.
  std::filesystem::path path;
};

/// .html: headline, table of outcomes, the figures of arrivals, deviations, boxes and map as drawings, of two models
/// the paired outcomes, and whose they are by hash. The same request writes the same bytes. Threads: any. Errors:
/// kInvalidArgument (another ending, starts, lattices); kCancelled; kIo.
Status write_report(const ReportRequest& request, Progress& progress);

}  // namespace trocar::workbench
