/// A script of `trocar` commands: one a line, comments with #, titles of the next line with ##, variables as ${name}.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/result.h"

namespace trocar::app {

using Variables = std::map<std::string, std::string>;

struct ScriptStep {
  int line = 0;
  std::string title;                   ///< From the `##` line above, else the command itself.
  std::vector<std::string> arguments;  ///< Words of the command, variables replaced.
};

/// Splits `text` into steps. A line `default NAME VALUE` gives a variable a value unless `variables` has one; a word in
/// "double quotes" may hold spaces; a leading `trocar` is skipped.
/// Errors: kCorrupt naming the line: an open quote, an unknown variable. kInvalidArgument naming one of `given` that
/// the script neither uses nor gives a default.
Result<std::vector<ScriptStep>> parse_script(std::string_view text, Variables variables,
                                             const std::set<std::string>& given = {});

}  // namespace trocar::app
