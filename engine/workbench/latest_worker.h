/// A thread that works on the newest request and forgets older ones: the picture thread and its kin.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <semaphore>
#include <thread>
#include <utility>

#include "engine/core/triple_buffer.h"

namespace trocar::workbench {

/// Threads: one owner calls everything here; the handler is made, used and destroyed in the worker's thread, so that it
/// may own what belongs to one thread (an OpenGL context).
template <typename Request, typename Answer>
class LatestWorker {
 public:
  using Handler = std::function<Answer(const Request&)>;

  explicit LatestWorker(std::function<Handler()> make_handler)
      : thread_([this, make = std::move(make_handler)](const std::stop_token& stop) { run(stop, make); }) {}
  LatestWorker(const LatestWorker&) = delete;
  LatestWorker& operator=(const LatestWorker&) = delete;
  ~LatestWorker() {
    thread_.request_stop();
    wake_.release();
  }

  /// Replaces a request that is still waiting. Never blocks.
  void request(Request request) {
    requests_.back() = {++requested_, std::move(request)};
    requests_.publish();
    // What was replaced unseen may hold documents that nobody needs any more.
    requests_.back() = {};
    wake_.release();
  }
  /// True if an answer arrived since the last call; it is then in `answer()`.
  bool update() {
    if (!answers_.replace()) return false;
    answered_ = answers_.front().number;
    return true;
  }
  const Answer& answer() const { return answers_.front().value; }
  /// True while the newest request has no answer yet, as far as `update()` has seen.
  bool pending() const { return answered_ != requested_; }

 private:
  template <typename T>
  struct Numbered {
    std::uint64_t number = 0;
    T value{};
  };

  void run(const std::stop_token& stop, const std::function<Handler()>& make_handler) {
    const Handler handler = make_handler();
    for (;;) {
      wake_.acquire();
      if (stop.stop_requested()) return;
      if (!requests_.replace()) continue;
      const Numbered<Request>& newest = requests_.front();
      answers_.back() = {newest.number, handler(newest.value)};
      answers_.publish();
      answers_.back() = {};
    }
  }

  TripleBuffer<Numbered<Request>> requests_;
  TripleBuffer<Numbered<Answer>> answers_;
  std::counting_semaphore<> wake_{0};
  std::uint64_t requested_ = 0;
  std::uint64_t answered_ = 0;
  std::jthread thread_;
};

}  // namespace trocar::workbench
