/// The curve of a training while it runs: from its job to the panel that shows it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/spsc_queue.h"
#include "engine/workbench/job_view.h"

namespace trocar::workbench {

/// A training that runs now.
struct TrainingView {
  JobId job;
  std::string name;           ///< Of the model that it will leave.
  std::vector<double> curve;  ///< Mismatch ‖f − D‖₁ / ‖f‖₁ of each epoch so far.
  int epochs = 0;             ///< That it will take; 0: nobody knows, as it ends when it has converged.
};

/// The epochs of one training on their way between two threads. Of more than fit between two looks a straight line is
/// made: each epoch keeps its place, and the curve of the model itself is whole.
class TrainingFeed {
 public:
  /// Threads: the job's.
  void tell(double mismatch) { static_cast<void>(figures_.push({told_++, mismatch})); }
  /// Moves what has arrived to the end of `curve`; true if anything had. Threads: the main one.
  bool take(std::vector<double>& curve);

 private:
  struct Figure {
    std::size_t epoch = 0;
    double mismatch = 0.0;
  };
  std::size_t told_ = 0;  ///< Of the job's thread.
  SpscQueue<Figure> figures_{20'000};
};

/// Those that wait or run, in the order in which they were asked for. Threads: the main one.
class LiveTrainings {
 public:
  /// `feed` is what the job tells; `epochs` as in `TrainingView`.
  void add(std::shared_ptr<TrainingFeed> feed, JobId job, std::string name, int epochs);
  /// Takes in what arrived and forgets what has ended by `jobs`; true if `running()` is another now.
  bool poll(const std::vector<JobView>& jobs);
  /// The one that runs, if it has told anything yet.
  std::shared_ptr<const TrainingView> running() const;

 private:
  struct Training {
    std::shared_ptr<const TrainingView> view;  ///< Replaced when it grows: frames keep what they were given.
    std::shared_ptr<TrainingFeed> feed;
  };
  std::vector<Training> trainings_;
};

}  // namespace trocar::workbench
