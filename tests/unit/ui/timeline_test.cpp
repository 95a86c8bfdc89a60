#include <doctest/doctest.h>

#include <algorithm>

#include "tests/support/ui_desk.h"

namespace trocar::ui {
namespace {

using workbench::CommitEdit;
using workbench::CopyRun;
using workbench::EditDemonstration;
using workbench::SetPlayhead;
using workbench::SetSelection;
using workbench::TimeSpan;

/// A desk on which selections and the playhead are what was last asked for, as in the workbench.
struct TimeDesk : Desk {
  TimeDesk() : Desk(testing::made_state()) {
    driver_.emplace(*session, [this]() -> Status {
      window.poll(0.0);
      TROCAR_ASSIGN_OR_RETURN(const ShellResult result, session->frame(state));
      for (const workbench::Command& command : result.commands) {
        commands.push_back(command);
        if (const auto* selected = std::get_if<SetSelection>(&command)) select(selected->span);
        if (const auto* playhead = std::get_if<SetPlayhead>(&command)) state.playhead_s = playhead->t_s;
      }
      return {};
    });
  }
  void select(const std::optional<TimeSpan>& span) {
    state.selection = span ? workbench::kept_within(shown(), *span) : std::nullopt;
  }
  const demonstration::Demonstration& shown() const { return *state.project->demonstrations.at({1}); }
  Driver& hand() { return *driver_; }
  /// The middle of the lanes at a time, for the timeline's first zoom.
  float x_of(double t_s) {
    const Item in = hand().item("Timeline/In gate").value();
    const Item out = hand().item("Timeline/Out gate").value();
    return in.rect.x1 + static_cast<float>(t_s / 7.0) * (out.rect.x0 - in.rect.x1);
  }
  void press_and_move(double from_s, double to_s) {
    const Rect lanes = hand().item("Timeline/Lanes").value().rect;
    InputQueue& input = window.input();
    input.push(MouseMoved{x_of(from_s), lanes.centre_y()});
    CHECK(hand().frames(1));
    input.push(MouseButton{0, true});
    CHECK(hand().frames(1));
    for (int i = 1; i <= 4; ++i) {
      input.push(MouseMoved{x_of(from_s + 0.25 * i * (to_s - from_s)), lanes.centre_y()});
      CHECK(hand().frames(1));
    }
  }
  void drag(double from_s, double to_s) {
    press_and_move(from_s, to_s);
    window.input().push(MouseButton{0, false});
    CHECK(hand().frames(2));
  }
  void hold(Key key, bool down) {
    window.input().push(KeyChanged{key, down});
    CHECK(hand().frames(1));
  }
  const demonstration::Edit& last_edit() const { return std::get<EditDemonstration>(last<CommitEdit>()->edit).edit; }

  std::optional<Driver> driver_;
};

}  // namespace

TEST_CASE("a drag over the lanes selects, from event to event, and commits nothing") {
  TimeDesk desk;
  desk.drag(2.02, 3.98);
  REQUIRE(desk.state.selection);
  CHECK(desk.state.selection->begin_s == doctest::Approx(2.0));
  CHECK(desk.state.selection->end_s == doctest::Approx(4.0));
  CHECK(desk.last<CommitEdit>() == nullptr);
  CHECK(text_of(desk.hand().expect_value("Timeline/Selection begin", "2.000")) == "");
  CHECK(text_of(desk.hand().expect_value("Timeline/Selection/To", "4.000")) == "");
  CHECK(text_of(desk.hand().expect_value("Timeline/Selection/Length", "2.00 s")) == "");
}

TEST_CASE("Ctrl lets a drag stop beside an event, and without snapping it goes to one") {
  TimeDesk desk;
  desk.hold(Key::kLeftControl, true);
  desk.drag(2.02, 3.48);
  desk.hold(Key::kLeftControl, false);
  REQUIRE(desk.state.selection);
  CHECK(desk.state.selection->begin_s != 2.0);
  CHECK(desk.state.selection->begin_s == doctest::Approx(2.02).epsilon(0.01));
  desk.state.snapping = false;
  desk.drag(5.02, 5.5);
  CHECK(desk.state.selection->begin_s != 5.0);
}

TEST_CASE("Shift extends a selection, and a click without it selects nothing and sets the playhead") {
  TimeDesk desk;
  desk.drag(2.0, 3.0);
  desk.hold(Key::kLeftShift, true);
  desk.drag(4.5, 5.0);
  desk.hold(Key::kLeftShift, false);
  CHECK(*desk.state.selection == TimeSpan{2.0, 5.0});
  desk.drag(4.0, 4.0);
  CHECK_FALSE(desk.state.selection);
  CHECK(desk.state.playhead_s == doctest::Approx(4.0));
}

TEST_CASE("an end of the selection can be dragged, the other stays") {
  TimeDesk desk;
  desk.drag(2.0, 3.0);
  desk.drag(3.0, 5.0);
  CHECK(*desk.state.selection == TimeSpan{2.0, 5.0});
}

TEST_CASE("Escape during a drag brings the selection back that was there; at rest it selects nothing") {
  TimeDesk desk;
  desk.drag(2.0, 3.0);
  desk.press_and_move(4.2, 5.0);
  CHECK(desk.state.selection->end_s == doctest::Approx(5.0));
  CHECK(desk.hand().key("Escape"));
  CHECK(*desk.state.selection == TimeSpan{2.0, 3.0});
  desk.window.input().push(MouseButton{0, false});
  CHECK(desk.hand().frames(2));
  CHECK(*desk.state.selection == TimeSpan{2.0, 3.0});
  CHECK(desk.hand().key("Escape"));
  CHECK_FALSE(desk.state.selection);
}

TEST_CASE("time is selected by keys alone") {
  TimeDesk desk;
  Driver& hand = desk.hand();
  CHECK(hand.key("Alt+I"));
  CHECK(*desk.state.selection == TimeSpan{2.0, 7.0});
  desk.state.playhead_s = 4.0;
  CHECK(hand.key("Alt+O"));
  CHECK(*desk.state.selection == TimeSpan{2.0, 4.0});
  CHECK(hand.key("Alt+Right"));
  CHECK(desk.state.selection->end_s == doctest::Approx(4.005));
  CHECK(hand.key("Shift+Alt+Left"));
  CHECK(desk.state.selection->end_s == doctest::Approx(3.955));
  CHECK(hand.key("Ctrl+Alt+Left"));
  CHECK(desk.state.selection->end_s == doctest::Approx(3.0));
  CHECK(desk.state.playhead_s == doctest::Approx(3.0));
  CHECK(hand.key("Ctrl+A"));
  CHECK(*desk.state.selection == TimeSpan{0.0, 7.0});
  CHECK(hand.key("Alt+S"));
  CHECK(*desk.state.selection == TimeSpan{3.0, 4.0});
}

TEST_CASE("a typed number is an end of the selection, and nonsense changes nothing") {
  TimeDesk desk;
  CHECK(text_of(desk.hand().type("Timeline/Selection/From", "1.5")) == "");
  CHECK(*desk.state.selection == TimeSpan{1.5, 7.0});
  CHECK(text_of(desk.hand().type("Timeline/Selection/To", "2.25 s")) == "");
  CHECK(*desk.state.selection == TimeSpan{1.5, 2.25});
  CHECK(text_of(desk.hand().type("Timeline/Selection/To", "soon")) == "");
  CHECK(desk.hand().frames(2));
  CHECK(*desk.state.selection == TimeSpan{1.5, 2.25});
  CHECK(text_of(desk.hand().expect_value("Timeline/Selection/From", "1.500")) == "");
  CHECK(text_of(desk.hand().expect_value("Timeline/Selection/To", "2.250")) == "");
}

TEST_CASE("cut copies and takes out, delete closes the gap, lift leaves it, each with one edit") {
  TimeDesk desk;
  desk.select(TimeSpan{2.0, 3.0});
  CHECK(desk.hand().key("Ctrl+X"));
  REQUIRE(desk.last<CopyRun>() != nullptr);
  CHECK(desk.last<CopyRun>()->span == TimeSpan{2.0, 3.0});
  CHECK(std::get<demonstration::DeleteSpan>(desk.last_edit()).ripple);
  CHECK(desk.hand().key("Ctrl+Shift+C"));
  CHECK(desk.window.clipboard() == "trocar demo edit /data/pegs.trocar 1 delete --from 2 --to 3 --ripple=yes");
  desk.select(TimeSpan{2.0, 3.0});
  CHECK(desk.hand().key("Delete"));
  CHECK_FALSE(std::get<demonstration::DeleteSpan>(desk.last_edit()).ripple);
  const auto edits = std::count_if(desk.commands.begin(), desk.commands.end(), [](const workbench::Command& command) {
    return std::holds_alternative<CommitEdit>(command);
  });
  CHECK(edits == 2);
}

TEST_CASE("a paste names source, span and point of the history, at the playhead or in place of the selection") {
  TimeDesk desk;
  CHECK(desk.hand().item("Timeline/Paste").value().reason == "Nothing was copied");
  desk.state.clipboard = workbench::Clipboard{{2}, "Novice 2", 1.0, 1.995, 2};
  desk.state.playhead_s = 4.0;
  CHECK(desk.hand().frames(1));
  CHECK(text_of(desk.hand().click("Timeline/Paste")) == "");
  auto splice = std::get<demonstration::Splice>(desk.last_edit());
  CHECK(splice.source == 2);
  CHECK(splice.as_of == 2);
  CHECK(splice.at_s == 4.0);
  CHECK(splice.until_s == 0.0);
  CHECK(splice.align == demonstration::Align::kAsRecorded);
  desk.select(TimeSpan{5.0, 6.0});
  CHECK(desk.hand().key("Ctrl+Shift+V"));
  splice = std::get<demonstration::Splice>(desk.last_edit());
  CHECK(splice.at_s == 5.0);
  CHECK(splice.until_s == 6.0);
  CHECK(splice.align == demonstration::Align::kMeet);
  CHECK(desk.hand().key("Ctrl+Shift+C"));
  CHECK(desk.window.clipboard().find("splice") != std::string::npos);
  CHECK(desk.window.clipboard().find("--as-of 2") != std::string::npos);
}

TEST_CASE("what cannot be cut says why") {
  TimeDesk desk;
  CHECK(desk.hand().item("Timeline/Cut").value().reason.starts_with("No time is selected"));
  desk.select(TimeSpan{0.0, 7.0});
  CHECK(desk.hand().frames(1));
  CHECK(desk.hand().item("Timeline/Cut").value().reason == "Nothing would stay");
  CHECK(desk.hand().item("Timeline/Copy").value().enabled);
}

TEST_CASE("J, K and L shuttle, comma and full stop step by a frame") {
  TimeDesk desk;
  CHECK(desk.hand().key("L"));
  CHECK(desk.last<workbench::Play>()->speed == 1.0);
  desk.state.play_speed = 1.0;
  CHECK(desk.hand().key("L"));
  CHECK(desk.last<workbench::Play>()->speed == 2.0);
  CHECK(desk.hand().key("J"));
  CHECK(desk.last<workbench::Play>()->speed == -1.0);
  CHECK(desk.hand().key("K"));
  CHECK(desk.last<workbench::Play>()->speed == 0.0);
  CHECK(desk.hand().key("."));
  CHECK(desk.state.playhead_s == doctest::Approx(2.0 + 1.0 / 30.0));
  CHECK(desk.hand().key(","));
  CHECK(desk.state.playhead_s == doctest::Approx(2.0));
}

TEST_CASE("lanes are chosen in a menu, and what was last done stays in the status line") {
  TimeDesk desk;
  CHECK(text_of(desk.hand().expect_present("Timeline/Segment A", true)) == "");
  CHECK(text_of(desk.hand().click("Timeline/Lanes shown…")) == "");
  CHECK(text_of(desk.hand().click("Lanes shown/Segments")) == "");
  CHECK(text_of(desk.hand().expect_present("Timeline/Segment A", false)) == "");
  CHECK(desk.hand().key("Escape"));
  desk.state.done = "Delete 1.00–2.00 s of Expert 1";
  CHECK(desk.hand().frames(2));
  CHECK(text_of(desk.hand().expect_value("Status/Hint", "Delete 1.00–2.00 s of Expert 1")) == "");
}

TEST_CASE("the middle button zooms to what is dragged over") {
  TimeDesk desk;
  const Item before = desk.hand().item("Timeline/Segment B").value();
  CHECK(text_of(desk.hand().drag("Timeline/Lanes", 80.0F, 0.0F, 2)) == "");
  CHECK(text_of(desk.hand().expect_present("Timeline/Out gate", false)) == "");
  CHECK(desk.hand().item("Timeline/Segment B").value().rect.width() != before.rect.width());
  CHECK_FALSE(desk.state.selection);
}

}  // namespace trocar::ui
