#include "engine/core/progress.h"

#include <doctest/doctest.h>

#include <atomic>
#include <semaphore>
#include <thread>

namespace {

/// A job in a thread of its own that waits while it is paused, once.
struct WaitingJob {
  explicit WaitingJob(trocar::Progress& progress)
      : thread([this, &progress] {
          begun.release();
          progress.wait_while_paused();
          let_go = told.load();
          ended = true;
        }) {
    begun.acquire();
  }
  std::binary_semaphore begun{0};
  std::atomic<bool> told{false};    ///< Somebody said that it may go on.
  std::atomic<bool> let_go{false};  ///< It had been said when the job went on.
  std::atomic<bool> ended{false};
  std::jthread thread;
};

}  // namespace

TEST_CASE("a paused job stands still until it is told to go on") {
  trocar::Progress progress;
  progress.pause(true);
  CHECK(progress.paused());
  WaitingJob job(progress);
  for (int i = 0; i < 1000; ++i) std::this_thread::yield();
  CHECK_FALSE(job.ended);
  job.told = true;
  progress.pause(false);
  job.thread.join();
  CHECK(job.let_go);
  CHECK_FALSE(progress.cancelled());
}

TEST_CASE("a paused job wakes when it is cancelled, and is cancelled then") {
  trocar::Progress progress;
  progress.pause(true);
  WaitingJob job(progress);
  job.told = true;
  progress.cancel();
  job.thread.join();
  CHECK(job.let_go);
  CHECK(progress.cancelled());
  // A cancelled one is never held again.
  progress.pause(true);
  progress.wait_while_paused();
}

TEST_CASE("what is counted is the fraction, too") {
  trocar::Progress progress;
  CHECK(progress.of() == 0);
  progress.count(3, 12);
  CHECK(progress.done() == 3);
  CHECK(progress.of() == 12);
  CHECK(progress.fraction() == 0.25);
}
