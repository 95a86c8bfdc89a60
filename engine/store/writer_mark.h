/// Names a living process in a project, so that a recording in the making is told from one that a crash cut off.
#pragma once

#include <string>
#include <string_view>

namespace trocar::store {

/// This process: its number, the moment it started and the boot it belongs to.
std::string writer_mark();

/// True if the process that the mark names still runs on this machine. An empty or foreign mark names none.
bool writer_lives(std::string_view mark);

}  // namespace trocar::store
