#include "engine/workbench/live_training.h"

#include <algorithm>
#include <utility>

namespace trocar::workbench {

bool TrainingFeed::take(std::vector<double>& curve) {
  const std::size_t before = curve.size();
  while (const std::optional<Figure> figure = figures_.pop()) {
    const double from = curve.empty() ? figure->mismatch : curve.back();
    const std::size_t missing = figure->epoch - std::min(curve.size(), figure->epoch);
    for (std::size_t i = 1; i <= missing; ++i) {
      curve.push_back(from + (figure->mismatch - from) * static_cast<double>(i) / static_cast<double>(missing + 1));
    }
    curve.push_back(figure->mismatch);
  }
  return curve.size() != before;
}

void LiveTrainings::add(std::shared_ptr<TrainingFeed> feed, JobId job, std::string name, int epochs) {
  trainings_.push_back(
      {std::make_shared<const TrainingView>(TrainingView{job, std::move(name), {}, epochs}), std::move(feed)});
}

bool LiveTrainings::poll(const std::vector<JobView>& jobs) {
  const auto ended = [&jobs](const Training& training) {
    const auto job =
        std::find_if(jobs.begin(), jobs.end(), [&](const JobView& each) { return each.id == training.view->job; });
    return job == jobs.end() || (job->state != JobState::kQueued && job->state != JobState::kRunning);
  };
  bool changed = std::erase_if(trainings_, ended) > 0;
  for (Training& training : trainings_) {
    TrainingView grown = *training.view;
    if (!training.feed->take(grown.curve)) continue;
    training.view = std::make_shared<const TrainingView>(std::move(grown));
    changed = true;
  }
  return changed;
}

std::shared_ptr<const TrainingView> LiveTrainings::running() const {
  const auto found = std::find_if(trainings_.begin(), trainings_.end(),
                                  [](const Training& training) { return !training.view->curve.empty(); });
  return found == trainings_.end() ? nullptr : found->view;
}

}  // namespace trocar::workbench
