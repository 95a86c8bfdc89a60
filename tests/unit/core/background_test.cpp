#include "engine/core/background.h"

#include <doctest/doctest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <thread>

using namespace trocar;

TEST_CASE("a thread that gives way takes those along that it starts, and nobody else") {
  const auto niceness = [] { return ::getpriority(PRIO_PROCESS, static_cast<id_t>(::gettid())); };
  const int before = niceness();
  int of_its_own = 0;
  int of_its_child = 0;
  std::thread([&] {
    give_way();
    of_its_own = niceness();
    std::thread([&] { of_its_child = niceness(); }).join();
  }).join();
  CHECK(niceness() == before);
  CHECK(of_its_own >= 5);
  CHECK(of_its_own >= before);
  CHECK(of_its_child == of_its_own);
}
