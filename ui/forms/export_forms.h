/// Ask where a film or a figure shall be written, and how large.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ui/forms/form.h"

namespace trocar::ui {

class VideoForm final : public Form {
 protected:
  std::string_view title() const override { return "Export video"; }
  float width() const override { return 460.0F; }
  void prepare(const WorkbenchState& state) override;
  Requests draw_content(Ui& ui, const WorkbenchState& state) override;

 private:
  void draw_look(Ui& ui);
  void draw_beside(Ui& ui, const WorkbenchState& state);
  workbench::ExportVideo wanted(const WorkbenchState& state) const;

  std::vector<workbench::DemonstrationId> others_;  ///< That may be beside; the first is none.
  std::string path_;
  int size_ = 0;
  int rate_ = 1;
  int speed_ = 1;
  int camera_ = 0;  ///< As `scene::CameraPreset`.
  int codec_ = 0;   ///< As `media::Codec`.
  bool captions_ = true;
  int beside_ = 0;  ///< 0: alone; else the n-th other demonstration.
};

class FieldForm final : public Form {
 protected:
  std::string_view title() const override { return "Export field"; }
  float width() const override { return 500.0F; }
  void prepare(const WorkbenchState& state) override;
  Requests draw_content(Ui& ui, const WorkbenchState& state) override;

 private:
  /// Where in the list of kinds of file, as the path says; −1: none of them.
  int kind_of_file() const;
  void draw_subject(Ui& ui, const WorkbenchState& state);
  void draw_paper(Ui& ui, int file);
  workbench::ExportField wanted(const WorkbenchState& state) const;

  std::string path_;
  std::string slice_;
  int kind_ = 0;
  int subject_ = 0;  ///< 0: the field; else a contrast of the two models.
  int paper_ = 0;    ///< 0: for a screen; else a preset.
  std::int64_t dpi_ = 300;
};

}  // namespace trocar::ui
