/// Which keys mean what: every command with its keys, to be changed by pressing others.
#pragma once

#include <optional>
#include <string>

#include "ui/forms/form.h"
#include "ui/settings.h"

namespace trocar::ui {

struct CommandRow;

class KeysForm final : public Form {
 public:
  /// `settings` outlives this.
  explicit KeysForm(const Settings& settings) : settings_(settings) {}
  /// The next key that is pressed is for the form alone.
  bool capturing() const { return is_open() && !capture_.empty(); }

 protected:
  std::string_view title() const override { return "Keys"; }
  float width() const override { return 820.0F; }
  float height() const override { return 620.0F; }
  bool keeps_escape() const override { return capturing() || clash_.has_value(); }
  void prepare(const WorkbenchState& state) override;
  Requests draw_content(Ui& ui, const WorkbenchState& state) override;

 private:
  /// A chord that was pressed and means something else already.
  struct Clash {
    std::string id;
    Chord chord;
  };
  void draw_head(Ui& ui, Requests& requests);
  void draw_banner(Ui& ui, Requests& requests);
  void draw_clash(Ui& ui, Requests& requests);
  void draw_menu(Ui& ui, std::string_view menu, Requests& requests);
  void draw_row(Ui& ui, const CommandRow& row, Requests& requests);
  void take(Ui& ui, Requests& requests);
  void give(Ui& ui, const std::string& id, const Chord& chord, bool take_from_others, Requests& requests);
  bool matches(Ui& ui, const CommandRow& row) const;

  const Settings& settings_;
  std::string find_;
  std::string capture_;  ///< The command that the next chord is for; "": none.
  std::string refusal_;  ///< Why the last chord was not taken.
  std::optional<Clash> clash_;
};

}  // namespace trocar::ui
