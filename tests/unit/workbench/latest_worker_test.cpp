#include "engine/workbench/latest_worker.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <semaphore>
#include <thread>
#include <vector>

using trocar::workbench::LatestWorker;

namespace {

template <typename Worker>
void settle(Worker& worker) {
  while (worker.pending()) {
    worker.update();
    std::this_thread::yield();
  }
}

}  // namespace

TEST_CASE("the newest request is answered, those it replaced need not be") {
  std::binary_semaphore gate{0};
  std::atomic<int> handled{0};
  LatestWorker<int, int> worker([&] {
    return [&](const int& request) {
      gate.acquire();
      ++handled;
      gate.release();
      return 10 * request;
    };
  });
  for (int i = 1; i <= 100; ++i) worker.request(i);
  CHECK(worker.pending());
  gate.release();
  settle(worker);
  CHECK(worker.answer() == 1000);
  CHECK(handled <= 3);
}

TEST_CASE("the handler is made and used in one thread that is not the owner's") {
  std::thread::id made;
  LatestWorker<int, std::thread::id> worker([&made] {
    made = std::this_thread::get_id();
    return [](const int&) { return std::this_thread::get_id(); };
  });
  worker.request(1);
  settle(worker);
  CHECK(worker.answer() == made);
  CHECK(made != std::this_thread::get_id());
}

TEST_CASE("a worker is destroyed while requests wait") {
  LatestWorker<int, int> worker([] { return [](const int& request) { return request; }; });
  worker.request(1);
}

TEST_CASE("of requests and answers only the newest are kept") {
  using Value = std::shared_ptr<const int>;
  LatestWorker<Value, Value> worker([] { return [](const Value& request) { return request; }; });
  std::vector<std::weak_ptr<const int>> given;
  for (int i = 0; i < 20; ++i) {
    auto value = std::make_shared<const int>(i);
    given.push_back(value);
    worker.request(std::move(value));
    if (i % 3 == 0) settle(worker);
  }
  settle(worker);
  const auto alive = std::count_if(given.begin(), given.end(), [](const auto& each) { return !each.expired(); });
  CHECK(alive == 1);
  CHECK(*worker.answer() == 19);
}
