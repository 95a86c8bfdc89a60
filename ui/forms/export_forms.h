/// Ask where a film or a figure shall be written, and how large.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ui/forms/export_parts.h"
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
  bool all_overlays_ = false;
  int sync_ = 0;    ///< As `film::Sync`.
  int two_ = 0;     ///< How two lie.
  int beside_ = 0;  ///< 0: alone; else the n-th other demonstration.
};

class FieldForm final : public Form {
 public:
  /// On the slice that a panel shows, "z=11"; "": none is shown.
  void open_on(std::string slice) {
    shown_slice_ = std::move(slice);
    open();
  }

 protected:
  std::string_view title() const override { return "Export field"; }
  float width() const override { return 500.0F; }
  void prepare(const WorkbenchState& state) override;
  Requests draw_content(Ui& ui, const WorkbenchState& state) override;

 private:
  /// Where in the list of kinds of file, as the path says; −1: none of them.
  int kind_of_file() const;
  void draw_subject(Ui& ui, const WorkbenchState& state);
  std::string reason(const WorkbenchState& state) const;
  workbench::ExportField wanted(const WorkbenchState& state) const;

  std::string path_;
  std::string slice_;
  std::string shown_slice_;
  int kind_ = 0;
  int subject_ = 0;  ///< 0: the field; else a contrast of the two models.
  PaperChoice paper_;
};

}  // namespace trocar::ui
