#include "engine/trial/trial_recorder.h"

namespace trocar::trial {

void TrialRecorder::add(const demonstration::Sample& sample) {
  between_.clear();
  samples_.push_back(sample);
}

void TrialRecorder::keep_between() {
  samples_.insert(samples_.end(), between_.begin(), between_.end());
  between_.clear();
}

std::optional<std::string> TrialRecorder::take_initial_world() {
  return std::exchange(initial_world_, std::nullopt);
}

}  // namespace trocar::trial
