/// What a program says of itself when it dies: without it, a crash on somebody's computer leaves nothing to look at.
#pragma once

namespace trocar::app {

/// From here on SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT print the calls that led there to standard error and then
/// end the program as they would have, core file and all. `program` is printed first; it must live for ever. Sanitizers
/// keep their own reports. Threads: call it once, before others begin.
void report_crashes(const char* program);

}  // namespace trocar::app
