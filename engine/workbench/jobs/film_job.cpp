#include "engine/workbench/jobs/film_job.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "engine/workbench/jobs/still_job.h"
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

}  // namespace

Result<FilmReport> render_film(const FilmJob& job, Progress& progress) {
  const auto begin = std::chrono::steady_clock::now();
  TROCAR_RETURN_IF_ERROR(check(job));
  TROCAR_ASSIGN_OR_RETURN(media::VideoWriter writer,
                          media::VideoWriter::open(job.path, {job.width, job.height, job.fps, job.codec}));
  TROCAR_ASSIGN_OR_RETURN(Studio studio, Studio::create());
  const int frames = frame_count(job);
  for (int frame = 0; frame < frames; ++frame) {
    if (progress.cancelled()) return fail(ErrorCode::kCancelled, "the film was cancelled");
    const demonstration::Demonstration& shown = *job.demonstrations.front();
    const double at_s = std::min(shown.begin_s + frame * job.speed / job.fps, shown.end_s);
    ViewRequest view = view_of(shown, at_s, scene::camera(job.camera));
    view.render = {job.width, job.height, 1, true, true};
    TROCAR_ASSIGN_OR_RETURN(Image picture, studio.picture(view));
    TROCAR_RETURN_IF_ERROR(writer.add(std::move(picture)));
    progress.set((frame + 1.0) / frames);
  }
  TROCAR_RETURN_IF_ERROR(writer.finish());
  FilmReport report;
  report.frames = frames;
  report.codec = writer.codec();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return report;
}

}  // namespace trocar::workbench
