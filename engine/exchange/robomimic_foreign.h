/// Demonstrations that other programs wrote in robomimic's layout: poses from `obs`, as robosuite and its like name
/// them. Private to the module.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "engine/exchange/imported.h"
#include "engine/exchange/tree_node.h"

namespace trocar::exchange {

/// False for an observation that `read_foreign` would make nothing of.
bool is_known_observation(std::string_view name);

/// Of `group` ("data/demo_3"). robot0 becomes the left arm, robot1 the right one; an arm that is not there stands at
/// its ready pose. Measured poses stand in for setpoints. Says in `found` and `lossy` what was taken how, and what was
/// not. Precondition: `rate_hz` is from 0.1 to 1000. Errors: kCorrupt for arrays that do not fit each other or hold no
/// pose; kUnsupported if there is no tool position.
Result<Imported> read_foreign(const std::map<std::string, TreeNode>& nodes, const std::string& group, double rate_hz);

}  // namespace trocar::exchange
