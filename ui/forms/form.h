/// A small floating window with a question: record, open, export. Never modal; Esc or the cross closes it.
#pragma once

#include <string_view>

#include "ui/panel.h"

namespace trocar::ui {

class Form {
 public:
  virtual ~Form() = default;
  void open() {
    opened_ = open_ = true;
    frames_ = 0;
  }
  void close() { open_ = false; }
  bool is_open() const { return open_; }
  /// Draws nothing while closed.
  Requests draw(Ui& ui, const WorkbenchState& state);

 protected:
  virtual std::string_view title() const = 0;
  virtual float width() const { return 400.0F; }  ///< Pixels at 100 %.
  virtual float height() const { return 0.0F; }   ///< 0: as needed.
  virtual void prepare(const WorkbenchState&) {}  ///< When it opens.
  /// Esc is for something in the form, which stays open.
  virtual bool keeps_escape() const { return false; }
  virtual Requests draw_content(Ui& ui, const WorkbenchState& state) = 0;
  /// What stays in sight below the content, which is scrolled where there is no room for all of it; of one button's
  /// height.
  virtual bool has_footer() const { return false; }
  virtual Requests draw_footer(Ui&, const WorkbenchState&) { return {}; }

 private:
  bool open_ = false;
  bool opened_ = false;
  void place(Ui& ui);
  Requests draw_all(Ui& ui, const WorkbenchState& state);

  int frames_ = 0;               ///< Drawn since it opened.
  float last_height_ = 0.0F;     ///< As drawn, pixels.
  float last_y_ = 0.0F;          ///< Its top, pixels.
  float content_height_ = 0.0F;  ///< What the content above a footer needs, pixels; 0: not known yet.
};

}  // namespace trocar::ui
