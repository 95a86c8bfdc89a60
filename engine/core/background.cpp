#include "engine/core/background.h"

#include <sys/resource.h>
#include <unistd.h>

namespace trocar {

void give_way() {
  constexpr int kNice = 10;
  // Linux has a niceness of each thread, which the threads that it starts take over.
  static_cast<void>(::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice));
}

}  // namespace trocar
