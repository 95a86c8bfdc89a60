/// What is said about a file of another program before it is read.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/demonstration/recording.h"
#include "engine/exchange/exchange.h"

namespace trocar::workbench {

struct ImportSettings {
  std::filesystem::path path;
  std::optional<exchange::Format> format;    ///< Nothing: from the file's name.
  std::filesystem::path transcription;       ///< Of JIGSAWS; may be empty.
  std::optional<exchange::ColumnMap> map;    ///< Of a foreign table.
  bool propose = false;                      ///< A map is proposed where one is needed and none is given.
  std::vector<std::string> only;             ///< Of HDF5: demonstrations and filter keys; empty: all.
  double rate_hz = 0.0;                      ///< Of a file that does not tell; 0: none.
  std::array<double, 3> p_WF_m{};            ///< Where the file's origin is on the board.
  std::string name;                          ///< Empty: the file's.
  int block = demonstration::kUnknownPlace;  ///< The block that is carried, if it is known.
  int goal = demonstration::kUnknownPlace;
};

}  // namespace trocar::workbench
