/// One piece of work after another on several threads, for results that must not depend on how many there are.
#pragma once

#include <functional>

namespace trocar {

/// Calls `work(i)` for i = 0 … count − 1 on `threads` threads, this one among them. Blocks of `block` are handed out in
/// order; `stopped` is asked before each. Returns how many are done, all of them from the front: `count`, or fewer if
/// it was stopped. Preconditions: threads ≥ 1, block ≥ 1; different i write to different places; `work` does not throw.
int parallel_for(int count, int threads, int block, const std::function<void(int)>& work,
                 const std::function<bool()>& stopped);

}  // namespace trocar
