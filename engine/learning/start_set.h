/// Where rollouts start, in one line of text: the same in the window, on the command line and in files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"
#include "engine/learning/model.h"

namespace trocar::learning {

/// | text | the starts |
/// | `all` | every cell |
/// | `around:K` | within ± K cells (Chebyshev) of the model's start |
/// | `box:X0-X1,Y0-Y1,Z0-Z1` | those coordinates, both ends included |
/// | `face:x0`, `face:x1` … `face:z1` | the cells of one side of the lattice, the low or the high one |
/// | `sphere:X,Y,Z,R` | centres within R cells of the cell's centre |
/// | `gaussian:SIGMA_MM,N,SEED` | N draws around the centre of the model's start; what falls outside is drawn anew |
/// | `latin:N,SEED` | N draws over the lattice, evenly along each axis (a Latin hypercube) |
/// | `latin:N,SEED,K` | the same within ± K cells of the model's start, as far as the lattice goes |
/// | `cells:A,B-C,…` | these cells by their flat numbers: a painted region |
///
/// Each cell once, by CellIndex; of `gaussian` and `latin`, all N draws in their order. Errors: kInvalidArgument, one
/// sentence.
Result<std::vector<spatial::CellIndex>> starts_from(std::string_view text, const Model& model);
/// The forms above, and `file:` of `read_starts`, for help.
std::string_view start_set_help();

/// "cells:…" for these cells, in runs.
std::string start_text(const std::vector<spatial::CellIndex>& cells);

/// As many draws as `gaussian` and `latin` may ask for.
constexpr int kMostDraws = 1'000'000;

}  // namespace trocar::learning
