#include "engine/workbench/live_training.h"

#include <algorithm>
#include <utility>

namespace trocar::workbench {

bool TrainingFeed::take(std::vector<double>& curve) {
  const std::size_t before = curve.size();
  while (const std::optional<double> mismatch = figures_.pop()) curve.push_back(*mismatch);
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
