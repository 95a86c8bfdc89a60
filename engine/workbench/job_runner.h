/// One thread that works through jobs in order, with progress, pause and cancel; results are taken in by the main
/// thread.
#pragma once

#include <deque>
#include <filesystem>
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
#include "engine/workbench/time_left.h"

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

  /// Queues a job. `hidden` ones are not listed unless they fail. `film`: where the film goes that it makes, if any.
  JobId start(std::string title, Work work, bool hidden = false, std::filesystem::path film = {});
  /// A queued job never starts; a running one stops at its next look at the progress, paused or not.
  void cancel(JobId id);
  void cancel_all();
  /// Of the running job, if it is that one and ever looks; those that are queued wait behind it.
  void pause(JobId id, bool paused);
  /// Applies finished jobs and updates the fractions. Returns the jobs that ended since the last call. `now_s`, of any
  /// clock, is for the time that is left.
  std::vector<JobView> poll(double now_s = 0.0);
  bool busy() const { return !waiting_.empty() || running_ != nullptr; }
  /// The running job was told to stand still.
  bool paused() const;
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
  TimeLeft left_;  ///< Of the running one.
  std::vector<JobView> views_;
  SpscQueue<std::shared_ptr<Job>> to_thread_{4};
  SpscQueue<std::shared_ptr<Done>> from_thread_{4};
  std::counting_semaphore<> wake_{0};
  std::jthread thread_;
};

}  // namespace trocar::workbench
