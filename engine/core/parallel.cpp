#include "engine/core/parallel.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace trocar {

int parallel_for(int count, int threads, int block, const std::function<void(int)>& work,
                 const std::function<bool()>& stopped) {
  std::atomic<int> next{0};
  const auto share = [&] {
    while (!stopped()) {
      const int begin = next.fetch_add(block);
      if (begin >= count) return;
      const int end = std::min(begin + block, count);
      for (int i = begin; i < end; ++i) work(i);
    }
  };
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(share);
  share();
  for (std::thread& other : others) other.join();
  return std::min(next.load(), count);
}

}  // namespace trocar
