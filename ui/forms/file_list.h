/// The folders of one folder and those of its files that are of use, as a list to choose from.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ui/panel.h"

namespace trocar::ui {

class FileList {
 public:
  /// Only files with one of these endings, in lower case with their dot, are shown.
  explicit FileList(std::vector<std::string> endings) : endings_(std::move(endings)) {}

  void go_to(const std::filesystem::path& folder);
  const std::filesystem::path& folder() const { return folder_; }
  /// `typed` is the chosen file's name, and may be a whole path. `none` says that there is nothing. Leaves room of
  /// `below` pixels. Returns true when a file was clicked.
  bool draw(Ui& ui, std::string& typed, std::string_view none, float below);
  std::filesystem::path chosen(const std::string& typed) const { return folder_ / typed; }

 private:
  struct Entry {
    std::string name;
    bool folder = false;
  };
  bool draw_rows(Ui& ui, std::string& typed, std::filesystem::path& next);

  std::vector<std::string> endings_;
  std::filesystem::path folder_;
  std::vector<Entry> entries_;
  std::string read_error_;
};

/// Where a file is first looked for: beside the project, else where the program runs.
std::filesystem::path first_folder(const WorkbenchState& state);

}  // namespace trocar::ui
