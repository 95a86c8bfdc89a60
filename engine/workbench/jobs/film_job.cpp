#include "engine/workbench/jobs/film_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "engine/film/film_overlay.h"
#include "engine/workbench/jobs/film_pane.h"
#include "engine/workbench/studio.h"

namespace trocar::workbench {
namespace {

using DemonstrationPointer = std::shared_ptr<const demonstration::Demonstration>;

Status check(const FilmJob& job) {
  if (job.demonstrations.empty() || job.demonstrations.size() > 2) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("a film shows one demonstration or two, not {}", job.demonstrations.size()));
  }
  for (const DemonstrationPointer& shown : job.demonstrations) {
    if (shown->gated().empty()) {
      return fail(ErrorCode::kInvalidArgument, fmt::format("\"{}\" has no samples to film", shown->name));
    }
  }
  if (job.demonstrations.size() == 2 && job.width % 4 != 0) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("a film of two needs a width that is a multiple of 4, not {}", job.width));
  }
  if (!(job.speed > 0.0) || job.speed > 100.0) {
    return fail(ErrorCode::kInvalidArgument,
                fmt::format("the speed must be above 0 and at most 100, not {}", job.speed));
  }
  return {};
}

int frame_count(const FilmJob& job) {
  double longest_s = 0.0;
  for (const DemonstrationPointer& shown : job.demonstrations) longest_s = std::max(longest_s, shown->duration_s());
  return static_cast<int>(std::floor(longest_s / job.speed * job.fps)) + 1;
}

std::vector<FilmPane> panes_of(const FilmJob& job) {
  const int count = static_cast<int>(job.demonstrations.size());
  std::vector<FilmPane> panes;
  for (const DemonstrationPointer& shown : job.demonstrations) {
    panes.emplace_back(shown,
                       FilmPane::Look{job.width / count, job.height, job.speed, job.camera, job.captions, count == 1});
  }
  return panes;
}

Result<Image> frame_of(std::vector<FilmPane>& panes, const FilmJob& job, Studio& studio, double elapsed_s) {
  TROCAR_ASSIGN_OR_RETURN(Image left, panes[0].frame(studio, elapsed_s));
  if (panes.size() == 1) return left;
  TROCAR_ASSIGN_OR_RETURN(const Image right, panes[1].frame(studio, elapsed_s));
  return film::side_by_side(left, right, job.demonstrations[0]->name, job.demonstrations[1]->name);
}

}  // namespace

Result<FilmReport> render_film(const FilmJob& job, Progress& progress) {
  const auto begin = std::chrono::steady_clock::now();
  TROCAR_RETURN_IF_ERROR(check(job));
  TROCAR_ASSIGN_OR_RETURN(media::VideoWriter writer,
                          media::VideoWriter::open(job.path, {job.width, job.height, job.fps, job.codec}));
  TROCAR_ASSIGN_OR_RETURN(Studio studio, Studio::create());
  std::vector<FilmPane> panes = panes_of(job);
  FilmReport report;
  report.frames = frame_count(job);
  for (int frame = 0; frame < report.frames; ++frame) {
    if (progress.cancelled()) return fail(ErrorCode::kCancelled, "the film was cancelled");
    TROCAR_ASSIGN_OR_RETURN(Image picture, frame_of(panes, job, studio, frame * job.speed / job.fps));
    TROCAR_RETURN_IF_ERROR(writer.add(std::move(picture)));
    progress.set((frame + 1.0) / report.frames);
  }
  TROCAR_RETURN_IF_ERROR(writer.finish());
  report.codec = writer.codec();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return report;
}

}  // namespace trocar::workbench
