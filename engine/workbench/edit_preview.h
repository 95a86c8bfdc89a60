/// What an edit would do to a demonstration, worked out beside the window while its parameters change.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/demonstration/diff.h"
#include "engine/demonstration/edit_effect.h"
#include "engine/demonstration/edits.h"
#include "engine/demonstration/idle_cuts.h"
#include "engine/demonstration/snap_figures.h"

namespace trocar::workbench {

struct PreviewRequest {
  std::shared_ptr<const demonstration::Demonstration> before;  ///< Null: nothing is to be shown.
  demonstration::Edit edit;
  std::int64_t entry = 0;  ///< Of the stack, to be replaced; 0: the edit is a new one.
  std::string problem;     ///< Why it cannot be made at all; empty: nobody knows yet.
};

struct EditPreview {
  demonstration::Edit edit;
  std::int64_t entry = 0;
  std::shared_ptr<const demonstration::Demonstration> before;
  std::shared_ptr<const demonstration::Demonstration> after;  ///< Null if the edit cannot be made.
  demonstration::Difference difference;
  std::vector<demonstration::SnapFigures> snap;  ///< Of an edit that snaps to the lattice.
  demonstration::EditEffect effect;
  /// Of an edit that trims what is idle: what it finds; also where it cannot be made because all of it stays.
  std::vector<demonstration::IdleCut> idle;
  std::string error;  ///< Why it cannot.
};

/// Nothing for a request without a demonstration. Threads: any.
std::shared_ptr<const EditPreview> preview_of(const PreviewRequest& request);

}  // namespace trocar::workbench
