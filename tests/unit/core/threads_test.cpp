#include <doctest/doctest.h>

#include <thread>

#include "engine/core/spsc_queue.h"
#include "engine/core/triple_buffer.h"

TEST_CASE("a queue keeps the order and says when it is full") {
  trocar::SpscQueue<int> queue(2);
  CHECK(queue.push(1));
  CHECK(queue.push(2));
  CHECK_FALSE(queue.push(3));
  CHECK(queue.pop() == 1);
  CHECK(queue.push(4));
  CHECK(queue.pop() == 2);
  CHECK(queue.pop() == 4);
  CHECK_FALSE(queue.pop());
}

TEST_CASE("two threads pass every value through a queue in order") {
  trocar::SpscQueue<int> queue(16);
  constexpr int kValues = 20000;
  std::jthread writer([&] {
    for (int i = 0; i < kValues; ++i) {
      while (!queue.push(int{i})) std::this_thread::yield();
    }
  });
  int expected = 0;
  while (expected < kValues) {
    if (const auto value = queue.pop()) {
      REQUIRE(*value == expected);
      ++expected;
    }
  }
  CHECK_FALSE(queue.pop());
}

TEST_CASE("a triple buffer gives whole values that never go back") {
  struct Pair {
    int first = 0;
    int second = 0;
  };
  trocar::TripleBuffer<Pair> buffer;
  CHECK_FALSE(buffer.update());
  constexpr int kValues = 20000;
  std::jthread writer([&] {
    for (int i = 1; i <= kValues; ++i) {
      buffer.back() = {i, -i};
      buffer.publish();
    }
  });
  int last = 0;
  while (last < kValues) {
    if (!buffer.update()) continue;
    REQUIRE(buffer.front().first == -buffer.front().second);
    REQUIRE(buffer.front().first > last);
    last = buffer.front().first;
  }
}
