/// One thread that works through jobs in order, with progress and cancel; results are taken in by the main thread.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <semaphore>
#include <string>
#include <thread>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/result.h"
#include "engine/core/spsc_queue.h"
#include "engine/workbench/job_view.h"

namespace trocar::workbench {

/// What a finished job hands to the main thread.
struct JobResult {
  std::string message;            ///< What it found, for the list of jobs.
  std::function<Status()> apply;  ///< Called once by `poll()`, in the main thread: commits what was made. May be empty.
};

/// Threads: everything here in the main thread; `work` runs in the job thread and sees only what it captured.
class JobRunner {
 public:
  using Work = std::function<Result<JobResult>(Progress&)>;

  JobRunner();
  JobRunner(const JobRunner&) = delete;
  JobRunner& operator=(const JobRunner&) = delete;
  ~JobRunner();

  /// Queues a job. `hidden` ones are not listed unless they fail.
  JobId start(std::string title, Work work, bool hidden = false);
  /// A queued job never starts; a running one stops at its next look at the progress.
  void cancel(JobId id);
  void cancel_all();
  /// Applies finished jobs and updates the fractions. Returns the jobs that ended since the last call.
  std::vector<JobView> poll();
  bool busy() const { return !waiting_.empty() || running_ != nullptr; }
  /// Newest first; ended jobs stay listed, at most 50.
  const std::vector<JobView>& jobs() const { return views_; }

 private:
  struct Job;
  struct Done;

  void run(const std::stop_token& stop);
  void start_next();
  JobView* view(JobId id);
  JobView conclude(const Done& done);

  std::int64_t last_id_ = 0;
  std::deque<std::shared_ptr<Job>> waiting_;
  std::shared_ptr<Job> running_;
  std::vector<JobView> views_;
  SpscQueue<std::shared_ptr<Job>> to_thread_{4};
  SpscQueue<std::shared_ptr<Done>> from_thread_{4};
  std::counting_semaphore<> wake_{0};
  std::jthread thread_;
};

}  // namespace trocar::workbench
