/// The wizard that takes in a file of another program: choose it, look at what it would become, correct how it is read,
/// import it as one step that can be undone.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/workbench/importing.h"
#include "ui/forms/column_map_editor.h"
#include "ui/forms/file_list.h"
#include "ui/forms/form.h"
#include "ui/forms/path_preview.h"

namespace trocar::ui {

class ImportForm final : public Form {
 public:
  /// Opens it on a file, as one that was dropped on the window; empty: on the list of files.
  void open_on(std::filesystem::path file);

 protected:
  std::string_view title() const override { return "Import"; }
  float width() const override { return reading() ? 940.0F : 560.0F; }
  float height() const override { return reading() ? 640.0F : 470.0F; }
  void prepare(const WorkbenchState& state) override;
  Requests draw_content(Ui& ui, const WorkbenchState& state) override;

 private:
  bool reading() const { return !settings_.path.empty(); }
  Requests start(const std::filesystem::path& file);
  Requests draw_choice(Ui& ui);
  bool draw_settings(Ui& ui, const workbench::ImportView* view);
  bool draw_source(Ui& ui, exchange::Format format);
  bool draw_map(Ui& ui, const workbench::ImportView& view);
  bool draw_presets(Ui& ui);
  bool draw_transfer(Ui& ui);
  void draw_outcome(Ui& ui, const WorkbenchState& state, const workbench::ImportView* view, float height);
  /// `doubts` are said already.
  void draw_part(Ui& ui, const workbench::ImportView& view, const std::vector<std::string>& doubts, float height);
  Requests draw_acts(Ui& ui, const WorkbenchState& state, const workbench::ImportView* view);

  std::filesystem::path given_;  ///< To open on.
  FileList list_{{".csv", ".tsv", ".npy", ".hdf5", ".h5", ".txt"}};
  std::string typed_;
  workbench::ImportSettings settings_;
  std::string transcription_;
  std::string only_;
  std::string rate_;
  std::string origin_mm_ = "0, 0, 0";
  std::string preset_name_;
  std::string preset_said_;           ///< How keeping a map went.
  std::vector<std::string> presets_;  ///< Names of maps that were kept.
  int part_ = 0;                      ///< Which of several demonstrations is looked at.
  ColumnMapEditor editor_;
  PathPreview preview_;
};

}  // namespace trocar::ui
