/// Tree nodes through a socket, one after the other, each with its length in front; used by both ends.
#pragma once

#include "engine/core/result.h"
#include "engine/exchange/tree_node.h"

namespace trocar::exchange {

/// Errors: kIo if the other end is gone.
Status send_node(int socket, const TreeNode& node);

/// Tells the other end that nothing more comes.
void end_of_sending(int socket);

/// Nothing at the end. Errors: kCorrupt for what is no node; kIo.
Result<std::optional<TreeNode>> receive_node(int socket);

}  // namespace trocar::exchange
