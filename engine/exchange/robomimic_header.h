/// What an HDF5 file of ours says of a demonstration beside its samples, as JSON. Private to the module.
#pragma once

#include <string>
#include <string_view>

#include "engine/demonstration/demonstration.h"
#include "engine/exchange/imported.h"

namespace trocar::exchange {

/// `samples` are those that are written. With nothing edited or gated off, what a replay needs goes along.
std::string robomimic_header(const demonstration::Demonstration& document,
                             const std::vector<demonstration::Sample>& samples);

/// True if `samples`, as `table_samples` gives them, are all that was recorded, as it was recorded.
bool is_as_recorded(const demonstration::Demonstration& document, const std::vector<demonstration::Sample>& samples);

/// Makes of `imported`, which has the samples, what the header says: provenance, outcome, times, notes. If the samples
/// are no longer those that were written, it stays an import, and `found` says so. `world` is the initial world.
/// Errors: kCorrupt.
Status apply_robomimic_header(std::string_view text, std::string world, Imported& imported);

}  // namespace trocar::exchange
