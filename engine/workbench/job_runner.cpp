#include "engine/workbench/job_runner.h"

#include <algorithm>
#include <utility>

#include "engine/core/background.h"

namespace trocar::workbench {

struct JobRunner::Job {
  JobId id;
  Work work;
  Progress progress;
};

struct JobRunner::Done {
  JobId id;
  Result<JobResult> result;
};

JobRunner::JobRunner() : thread_([this](const std::stop_token& stop) { run(stop); }) {}

JobRunner::~JobRunner() {
  waiting_.clear();
  if (running_) running_->progress.cancel();
  thread_.request_stop();
  wake_.release();
}

JobId JobRunner::start(std::string title, Work work, bool hidden, std::filesystem::path film) {
  auto job = std::make_shared<Job>();
  job->id = JobId{++last_id_};
  job->work = std::move(work);
  JobView shown;
  shown.id = job->id;
  shown.title = std::move(title);
  shown.hidden = hidden;
  shown.film = std::move(film);
  views_.insert(views_.begin(), std::move(shown));
  waiting_.push_back(job);
  start_next();
  return job->id;
}

void JobRunner::cancel(JobId id) {
  if (running_ && running_->id == id) running_->progress.cancel();
  const auto found = std::find_if(waiting_.begin(), waiting_.end(), [id](const auto& job) { return job->id == id; });
  if (found == waiting_.end()) return;
  waiting_.erase(found);
  if (JobView* shown = view(id)) {
    shown->state = JobState::kCancelled;
    shown->message = "cancelled before it began";
  }
}

void JobRunner::cancel_all() {
  std::vector<JobId> ids;
  for (const auto& job : waiting_) ids.push_back(job->id);
  if (running_) ids.push_back(running_->id);
  for (const JobId id : ids) cancel(id);
}

void JobRunner::pause(JobId id, bool paused) {
  if (!running_ || running_->id != id) return;
  running_->progress.pause(paused);
  if (JobView* shown = view(id)) shown->paused = paused;
}

bool JobRunner::paused() const {
  return running_ && running_->progress.paused();
}

std::vector<JobView> JobRunner::poll(double now_s) {
  std::vector<JobView> ended;
  while (auto done = from_thread_.pop()) {
    running_.reset();
    ended.push_back(conclude(**done));
    start_next();
  }
  if (running_) {
    const Progress& progress = running_->progress;
    left_.look(now_s, progress.fraction(), progress.paused());
    if (JobView* shown = view(running_->id)) {
      shown->fraction = progress.fraction();
      shown->done = progress.done();
      shown->of = progress.of();
      shown->left_s = left_.left_s();
    }
  }
  constexpr std::size_t kKept = 50;
  if (views_.size() > kKept && !busy()) views_.resize(kKept);
  return ended;
}

JobView JobRunner::conclude(const Done& done) {
  const Status applied = done.result && done.result->apply ? done.result->apply() : Status();
  // Only now: what was applied may have started a job, which moves the list.
  JobView* shown = view(done.id);
  if (shown == nullptr) return {};
  shown->paused = false;
  shown->left_s.reset();
  if (done.result && applied) {
    shown->state = JobState::kDone;
    shown->fraction = 1.0;
    shown->done = shown->of;
    shown->message = done.result->message;
  } else {
    const Error& error = done.result ? applied.error() : done.result.error();
    shown->state = error.code() == ErrorCode::kCancelled ? JobState::kCancelled : JobState::kFailed;
    shown->message = error.text();
    shown->hidden = false;
  }
  JobView copy = *shown;
  if (shown->hidden) views_.erase(views_.begin() + (shown - views_.data()));
  return copy;
}

void JobRunner::start_next() {
  if (running_ || waiting_.empty()) return;
  running_ = waiting_.front();
  waiting_.pop_front();
  left_ = {};
  if (JobView* shown = view(running_->id)) shown->state = JobState::kRunning;
  auto copy = running_;
  if (to_thread_.push(std::move(copy))) wake_.release();
}

JobView* JobRunner::view(JobId id) {
  const auto found = std::find_if(views_.begin(), views_.end(), [id](const JobView& shown) { return shown.id == id; });
  return found == views_.end() ? nullptr : &*found;
}

void JobRunner::run(const std::stop_token& stop) {
  give_way();
  for (;;) {
    wake_.acquire();
    if (stop.stop_requested()) return;
    auto job = to_thread_.pop();
    if (!job) continue;
    auto done = std::make_shared<Done>(Done{(*job)->id, (*job)->work((*job)->progress)});
    // One job runs at a time, so the queue has room.
    static_cast<void>(from_thread_.push(std::move(done)));
  }
}

}  // namespace trocar::workbench
