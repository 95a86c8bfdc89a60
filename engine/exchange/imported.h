/// What an import found in a file of another program.
#pragma once

#include <string>
#include <vector>

#include "engine/demonstration/edit.h"
#include "engine/demonstration/recording.h"

namespace trocar::exchange {

struct Imported {
  demonstration::Recording recording;         ///< Provenance "imported", block, goal and outcome unknown, no initial
                                              ///< world, unless Trocar wrote them; at least 2 samples, checked.
  std::string name;                           ///< In the file; may be empty.
  bool name_is_own = false;                   ///< The name that it had in Trocar, not its place in the file.
  std::vector<std::string> lossy;             ///< What the file does not have.
  std::vector<std::string> found;             ///< What had to be taken in another way than it stands there.
  std::vector<demonstration::AddNote> notes;  ///< To be written on the demonstration; times from its first sample.
};

}  // namespace trocar::exchange
