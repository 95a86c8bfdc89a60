#include <doctest/doctest.h>

#include <limits>

#include "engine/film/composition_json.h"
#include "engine/film/composition_words.h"
#include "engine/film/film_overlay.h"
#include "engine/film/frame_layout.h"
#include "engine/film/subtitles.h"

using namespace trocar;
using namespace trocar::film;

namespace {

/// Nothing in it is as it is if nothing is said.
Composition rich() {
  Composition film;
  film.path = "out/fïlm.mp4";
  film.width = 641;
  film.height = 360;
  film.fps = 12.5;
  film.codec = "vp9";
  film.crf = 17;
  film.quality = Quality::kFine;
  film.layout = Layout::kTwoByTwo;
  film.corner = Corner::kTopLeft;
  film.share = 0.25;
  Source first;
  first.of = "SC 1";
  first.title = "Shared";
  first.in_s = 0.5;
  first.out_s = 4.0;
  first.camera = {View::kPoses, 0.1, 0.2, 0.3, -4.0, 1.5, {{0.0, {0.1, 0.2, 0.3}, {0, 0, 0}, Ease::kHold}, {2.0}}};
  first.tracks = {{"orbit.yaw", {{0.0, 1.0, Ease::kSmooth}, {2.0, -1.0}}},
                  {"brightness", {{0.0, 0.0, Ease::kSpline}, {1.0, 1.0}}}};
  first.field = SceneField{"C exact", "margin", "y=4", 0.5};
  first.trail_s = 2.5;
  first.ghost = 0.6;
  first.brightness = 0.9;
  Source second;
  second.kind = SourceKind::kField;
  second.of = "A exact";
  second.layer = "reward";
  second.slice = "x=3";
  second.curve = "jaw";
  second.tracks = {{"slice", {{0.0, 1.0}, {3.0, 20.0}}}};
  Source third;
  third.kind = SourceKind::kRollout;
  third.of = "A exact";
  third.start = {3, 4, 5};
  film.sources = {first, second, third};
  film.share_keys = {{0.0, 0.2, Ease::kSpline}, {4.0, 0.4}};
  film.pace = {2.0, {{0.0, 1.0, Ease::kSmooth}, {1.0, 4.0}}, {{0.5, 1.0}}, 3, Sync::kGrasp};
  film.overlays = {};
  film.overlays.set(Overlay::kGhost);
  film.overlays.set(Overlay::kTally);
  return film;
}

}  // namespace

TEST_CASE("a job reads back as what was written, and what is left out is as it is anyhow") {
  const auto again = composition_from_json(to_json(rich()));
  REQUIRE_MESSAGE(again, (again ? "" : again.error().text()));
  CHECK(*again == rich());
  Composition plain;
  plain.sources = {recording_of("1")};
  CHECK(composition_from_json(R"({"sources": [{"of": "1"}]})").value() == plain);
  CHECK(composition_from_json(to_json(plain)).value() == plain);
}

TEST_CASE("a job with a slip of the pen is refused, and the sentence says where") {
  for (const auto& [text, word] : std::vector<std::pair<std::string, std::string>>{
           {"", "JSON"},
           {"[]", "object"},
           {R"({"sources": [{"of": "1"}], "widht": 3})", "widht"},
           {R"({"sources": [{"of": "1", "camera": {"jaw": 1}}]})", "jaw"},
           {R"({"sources": [{"of": 1}]})", "of"},
           {R"({"sources": [{"of": "1"}], "width": 3.5})", "width"},
           {R"({"sources": [{"of": "1"}], "layout": "4x4"})", "3x3"},
           {R"({"sources": [{"of": "1"}], "overlays": ["colour"]})", "colour-bar"},
           {R"({"sources": [{"of": "1"}], "tracks": [{"property": "hue", "keys": []}]})", "hue"},
           {R"({"sources": [{"of": "1", "tracks": [{"property": "hue", "keys": []}]}]})", "brightness"},
           {R"({"sources": [{"of": "1", "tracks": [{"property": "ghost", "keys": [{"t": 1, "value": 2}]}]}]})",
            "ghost"},
           {R"({"sources": [{"of": "1"}], "tracks": [{"property": "share", "keys": [{"t": 0, "value": 2}]}]})",
            "share"},
           {R"({"sources": [{"of": "1", "brightness": 1.5}]})", "brightness"},
           {R"({"sources": [{"of": "1", "tracks": [{"property": "zoom"}, {"property": "zoom"}]}]})", "two tracks"},
           {R"({"sources": [{"of": "1", "camera": {"zoom": 0}}]})", "zoom"},
           {R"({"sources": [{"of": "1", "field": {"layer": "value"}}]})", "which model"},
           {R"({"sources": [{"of": "1", "kind": "curve", "field": {"of": "2"}}]})", "no scene"},
           {R"({"sources": [{"of": "1", "start": [1, 2, 3]}]})", "no rollout"},
           {R"({"sources": [{"of": "1", "kind": "rollout", "start": [1, 2, 3.5]}]})", "whole"},
           {R"({"sources": [{"of": "1", "kind": "rollout", "start": [1, 2, -3]}]})", "outside"},
           {R"({"sources": [{"of": "1"}], "time": {"speed": 0}})", "speed"},
           {R"({"sources": [{"of": "1", "tracks": [{"property": "slice", "keys": [{"t": 1}, {"t": 1}]}]}]})", "after"},
           {R"({"sources": []})", "shows 1"},
           {R"({"sources": [{"of": "1", "in_s": 3, "out_s": 2}]})", "gates"},
           {R"({"sources": [{"of": "1", "camera": {"view": "poses"}}]})", "poses"},
           {R"({"sources": [{"of": "1"}], "width": 100000})", "pixels"}}) {
    CAPTURE(text);
    const auto job = composition_from_json(text);
    REQUIRE_FALSE(job);
    CHECK_MESSAGE(job.error().text().find(word) != std::string::npos, job.error().text());
  }
  Composition film;
  film.sources = {recording_of("1")};
  film.fps = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(check(film));
}

TEST_CASE("every preset is a film once it has its sources") {
  for (const std::string_view name : preset_names()) {
    CAPTURE(name);
    Composition film = preset_from(name).value();
    film.sources.resize(room_of(film.layout).most, recording_of("1"));
    CHECK(check(film));
  }
  CHECK(preset_from("mt-vs-sc").value().pace.sync == Sync::kSegment);
  CHECK_FALSE(preset_from("cinema"));
}

TEST_CASE("the cells of a grid are the frame, and a picture in the picture is within it") {
  Composition film;
  for (const Layout layout : {Layout::kSideBySide, Layout::kTopBottom, Layout::kTwoByTwo, Layout::kThreeByThree}) {
    film.layout = layout;
    film.sources.assign(room_of(layout).most, recording_of("1"));
    int area = 0;
    for (const Cell& cell : cells_of(film, 1282, 722)) {
      CHECK(cell.width > 0);
      area += cell.width * cell.height;
    }
    CHECK(area == 1282 * 722);
  }
  film.layout = Layout::kPictureInPicture;
  film.sources.assign(2, recording_of("1"));
  for (const Corner corner : {Corner::kTopLeft, Corner::kTopRight, Corner::kBottomLeft, Corner::kBottomRight}) {
    film.corner = corner;
    const Cell inset = cells_of(film, 1280, 720)[1];
    CHECK(inset.width == 384);
    CHECK(inset.height == 216);
    CHECK(inset.x >= 36);
    CHECK(inset.x + inset.width <= 1280 - 36);
    CHECK(inset.y + inset.height <= 720 - band_height_of(Band::kOneRow, 1280, 720));
  }
}

TEST_CASE("pictures are put where their cells are") {
  const std::vector<Cell> cells{{0, 0, 60, 80}, {60, 0, 60, 80}};
  const Image both = composed({Image(60, 80, {200, 0, 0, 255}), Image(60, 80, {0, 0, 200, 255})}, cells, 120, 80);
  CHECK(both.at(30, 40) == Rgba{200, 0, 0, 255});
  CHECK(both.at(90, 40) == Rgba{0, 0, 200, 255});
  CHECK_FALSE(both.at(60, 40) == Rgba{0, 0, 200, 255});
  CHECK(composed({Image(60, 80, {200, 0, 0, 255})}, {{0, 0, 60, 80}}, 120, 80).at(100, 40) == Rgba{0, 0, 0, 255});
}

TEST_CASE("subtitles are runs of equal words, numbered and in order") {
  const auto cues = cues_of({"", "a", "a", "b", "", "", "b\n\nc"}, 10.0);
  REQUIRE(cues.size() == 3);
  CHECK(cues[0].begin_s == doctest::Approx(0.1));
  CHECK(cues[0].end_s == doctest::Approx(0.3));
  CHECK(srt_of(cues) ==
        "1\n00:00:00,100 --> 00:00:00,300\na\n\n2\n00:00:00,300 --> 00:00:00,400\nb\n\n"
        "3\n00:00:00,600 --> 00:00:00,700\nb\nc\n\n");
  CHECK(srt_of({{3661.0015, 3662.0, "x"}}).find("01:01:01,00") != std::string::npos);
  CHECK(srt_of({}).empty());
}

TEST_CASE("for a page they are WebVTT, in which what could be a tag or an arrow is written out") {
  const auto cues = cues_of({"", "a", "a", "b\n\nc"}, 10.0);
  CHECK(vtt_of(cues) == "WEBVTT\n\n00:00:00.100 --> 00:00:00.300\na\n\n00:00:00.300 --> 00:00:00.400\nb\nc\n\n");
  CHECK(vtt_of({{3661.0, 3662.0, "<b> --> R&D"}}) ==
        "WEBVTT\n\n01:01:01.000 --> 01:01:02.000\n&lt;b&gt; --&gt; R&amp;D\n\n");
  CHECK(vtt_of({}) == "WEBVTT\n\n");
}
