/// How the last export of demonstrations ended.
#pragma once

#include <filesystem>
#include <string>

#include "engine/exchange/exchange.h"

namespace trocar::workbench {

struct ExportView {
  std::filesystem::path path;
  bool running = false;
  exchange::ExportReport report;  ///< Once it is done; `reread` says what was compared.
  std::string error;              ///< Why nothing was written.
};

}  // namespace trocar::workbench
