/// Errors are ours to tell, in one sentence: the libraries of films write theirs to standard error. Part of the plugin.
#pragma once

namespace trocar::media::plugin {

/// Of FFmpeg, and of OpenCV, whose threads are left out too. Threads: any; the first call does it, for good.
void silence();

/// While one lives, what any code prints through `stderr` is lost: SVT-AV1 greets with its settings as it opens. glibc
/// lets `stderr` be set like any variable; the descriptor, which other programs have too, stays.
class Hush {
 public:
  Hush();
  ~Hush();
  Hush(const Hush&) = delete;
  Hush& operator=(const Hush&) = delete;
};

}  // namespace trocar::media::plugin
