#include "engine/workbench/job_runner.h"

#include <doctest/doctest.h>

#include <atomic>
#include <semaphore>
#include <thread>
#include <vector>

using namespace trocar;
using namespace trocar::workbench;

namespace {

/// Polls until nothing is queued or running; returns every job that ended, in order.
std::vector<JobView> finish_all(JobRunner& runner) {
  std::vector<JobView> ended;
  while (runner.busy()) {
    for (JobView& job : runner.poll()) ended.push_back(std::move(job));
    std::this_thread::yield();
  }
  return ended;
}

}  // namespace

TEST_CASE("jobs run one after another in the order they were started, each applied in the main thread") {
  JobRunner runner;
  std::vector<int> applied;
  const std::thread::id main_thread = std::this_thread::get_id();
  for (int i = 0; i < 5; ++i) {
    runner.start("job", [&applied, main_thread, i](Progress&) -> Result<JobResult> {
      CHECK(std::this_thread::get_id() != main_thread);
      return JobResult{"done", [&applied, main_thread, i]() -> Status {
                         CHECK(std::this_thread::get_id() == main_thread);
                         applied.push_back(i);
                         return {};
                       }};
    });
  }
  CHECK(finish_all(runner).size() == 5);
  CHECK(applied == std::vector<int>{0, 1, 2, 3, 4});
}

TEST_CASE("a cancelled running job ends as cancelled, a cancelled queued one never runs") {
  JobRunner runner;
  std::binary_semaphore running{0};
  std::atomic<bool> second_ran{false};
  const JobId first = runner.start("first", [&running](Progress& progress) -> Result<JobResult> {
    running.release();
    while (!progress.cancelled()) std::this_thread::yield();
    return fail(ErrorCode::kCancelled, "stopped");
  });
  const JobId second = runner.start("second", [&second_ran](Progress&) -> Result<JobResult> {
    second_ran = true;
    return JobResult{};
  });
  running.acquire();
  runner.cancel(second);
  runner.cancel(first);
  finish_all(runner);
  CHECK_FALSE(second_ran);
  REQUIRE(runner.jobs().size() == 2);
  for (const JobView& job : runner.jobs()) CHECK(job.state == JobState::kCancelled);
}

TEST_CASE("an error in the work or in applying it makes the job fail with that message") {
  JobRunner runner;
  runner.start("work", [](Progress&) -> Result<JobResult> { return fail(ErrorCode::kIo, "no disk"); });
  runner.start("apply", [](Progress&) -> Result<JobResult> {
    return JobResult{"", []() -> Status { return fail(ErrorCode::kIo, "no room"); }};
  });
  const std::vector<JobView> ended = finish_all(runner);
  REQUIRE(ended.size() == 2);
  CHECK(ended[0].state == JobState::kFailed);
  CHECK(ended[0].message == "no disk");
  CHECK(ended[1].message == "no room");
}

TEST_CASE("a hidden job is listed only if it failed") {
  JobRunner runner;
  runner.start(
      "quiet", [](Progress&) -> Result<JobResult> { return JobResult{}; }, true);
  runner.start(
      "loud", [](Progress&) -> Result<JobResult> { return fail(ErrorCode::kIo, "broken"); }, true);
  finish_all(runner);
  REQUIRE(runner.jobs().size() == 1);
  CHECK(runner.jobs()[0].title == "loud");
  CHECK_FALSE(runner.jobs()[0].hidden);
}

TEST_CASE("a runner that is destroyed cancels the running job and forgets the rest") {
  std::atomic<bool> second_ran{false};
  {
    JobRunner runner;
    runner.start("first", [](Progress& progress) -> Result<JobResult> {
      while (!progress.cancelled()) std::this_thread::yield();
      return fail(ErrorCode::kCancelled, "stopped");
    });
    runner.start("second", [&second_ran](Progress&) -> Result<JobResult> {
      second_ran = true;
      return JobResult{};
    });
  }
  CHECK_FALSE(second_ran);
}

TEST_CASE("a running job is paused, and goes on or is cancelled from there; one that waits cannot be") {
  for (const bool cancelled : {false, true}) {
    JobRunner runner;
    std::binary_semaphore running{0};
    std::binary_semaphore paused{0};
    std::atomic<bool> released{false};
    std::atomic<bool> held{false};
    const JobId first = runner.start(
        "Film a.mp4",
        [&](Progress& progress) -> Result<JobResult> {
          progress.count(1, 4);
          running.release();
          paused.acquire();
          progress.wait_while_paused();
          held = released.load();
          if (progress.cancelled()) return fail(ErrorCode::kCancelled, "given up");
          progress.count(4, 4);
          return JobResult{"done", {}};
        },
        false, "a.mp4");
    const JobId second = runner.start("Film b.mp4", [](Progress&) -> Result<JobResult> { return JobResult{}; });
    running.acquire();
    runner.pause(second, true);
    runner.pause(first, true);
    paused.release();
    runner.poll();
    CHECK(runner.paused());
    CHECK(runner.busy());
    CHECK(runner.jobs()[1].paused);
    CHECK_FALSE(runner.jobs()[0].paused);
    CHECK(runner.jobs()[1].done == 1);
    CHECK(runner.jobs()[1].of == 4);
    CHECK(runner.jobs()[1].film == "a.mp4");
    released = true;
    if (cancelled) {
      runner.cancel(first);
    } else {
      runner.pause(first, false);
    }
    CHECK(finish_all(runner).size() == 2);
    CHECK(held);
    CHECK(runner.jobs()[1].state == (cancelled ? JobState::kCancelled : JobState::kDone));
    CHECK_FALSE(runner.jobs()[1].paused);
    CHECK(runner.jobs()[0].state == JobState::kDone);
  }
}

TEST_CASE("how long a job still takes is told by its looks, as the clock of who polls has them") {
  JobRunner runner;
  std::counting_semaphore<> step{0};
  std::counting_semaphore<> stepped{0};
  runner.start("Film", [&](Progress& progress) -> Result<JobResult> {
    for (int i = 1; i <= 2; ++i) {
      step.acquire();
      progress.count(i, 10);
      stepped.release();
    }
    step.acquire();
    return JobResult{};
  });
  runner.poll(0.0);
  CHECK_FALSE(runner.jobs()[0].left_s);
  step.release();
  stepped.acquire();
  runner.poll(1.0);
  CHECK_FALSE(runner.jobs()[0].left_s);
  step.release();
  stepped.acquire();
  runner.poll(3.0);
  CHECK(runner.jobs()[0].left_s.value() == doctest::Approx(16.0));
  step.release();
  finish_all(runner);
  CHECK_FALSE(runner.jobs()[0].left_s);
}
