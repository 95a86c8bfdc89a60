#include "engine/trial/key_script.h"

#include <doctest/doctest.h>

#include <string>

using namespace trocar;
using namespace trocar::trial;

TEST_CASE("a key script is read in the order of its times") {
  const auto strokes =
      parse_key_script("# a take\n0 hold Shift+d 0.5\n 0.25 tap C # shut\n1.5 pause 2\n2 end\n").value();
  REQUIRE(strokes.size() == 8);
  CHECK(strokes[0].key == kShiftKey);
  CHECK(strokes[1].key == 'D');
  CHECK(strokes[2].at == Tick{250});
  CHECK(strokes[3].act == KeyAct::kUp);
  CHECK(strokes[4].key == 'D');
  CHECK(strokes[5].key == kShiftKey);
  CHECK(strokes[6].act == KeyAct::kPause);
  CHECK(strokes[6].duration == Tick{2000});
  CHECK(strokes[7].act == KeyAct::kEnd);
  CHECK(strokes[7].at == Tick{2000});
}

TEST_CASE("a key script without an end goes on for a second") {
  CHECK(parse_key_script("0.5 tap Enter\n").value().back().at == Tick{1500});
  for (const char* empty : {"", "\n\n", "# nothing yet\n"}) {
    CHECK(parse_key_script(empty).error().text() == "the script presses no key and does not end");
  }
}

TEST_CASE("a broken line of a key script is named with what is wrong with it") {
  const auto why = [](const std::string& text) { return parse_key_script(text).error().text(); };
  CHECK(why("0 press D\n") == "line 1: \"press\" is none of down, up, tap, hold, pause and end");
  CHECK(why("\n0 tap F5\n") == "line 2: no key of the operator is named \"F5\"");
  CHECK(why("1 tap D\n0.5 tap D\n") == "line 2: it is earlier than the line above");
  CHECK(why("-1 tap D\n") == "line 1: \"-1\" is no time from 0 to 3600 s");
  CHECK(why("nan tap D\n") == "line 1: \"nan\" is no time from 0 to 3600 s");
  CHECK(why("0 tap\n") == "line 1: \"tap\" takes one word after it");
  CHECK(why("0 end\n1 tap D\n") == "line 2: nothing follows the end");
  CHECK(why("0\n") == "line 1: a line is a time, an act and its key");
}

TEST_CASE("a key that repeats steps again but does not open and shut the jaws") {
  KeyboardHands keyboard({HandMode::kStep});
  CHECK(keyboard.key('D', true).size() == 1);
  CHECK(keyboard.key('D', true).size() == 1);
  CHECK(keyboard.key('C', true).size() == 1);
  CHECK(keyboard.key('C', true).empty());
  CHECK(keyboard.key('R', true).empty());
}

TEST_CASE("two keys held drive the tool no faster than one, and Shift makes it slow") {
  KeyboardHands keyboard;
  const auto speed = [](const std::vector<HandEvent>& events) { return std::get<DriveTool>(events.at(0)).v_WT.norm(); };
  CHECK(speed(keyboard.key('D', true)) == doctest::Approx(0.040));
  CHECK(speed(keyboard.key('W', true)) == doctest::Approx(0.040));
  CHECK(speed(keyboard.key(kShiftKey, true)) == doctest::Approx(0.008));
  CHECK(speed(keyboard.release_all()) < 0.041);
  CHECK(keyboard.key('D', true).size() == 1);
}
