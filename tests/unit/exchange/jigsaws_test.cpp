#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cmath>

#include "engine/core/file.h"
#include "engine/demonstration/edits.h"
#include "engine/exchange/exchange.h"
#include "engine/exchange/findings.h"
#include "engine/exchange/jigsaws.h"
#include "tests/support/document_samples.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/sentences.h"

using namespace trocar;
using namespace trocar::exchange;

using trocar::testing::mentions;

namespace {

/// Arm `arm` (0, 1 masters; 2 left, 3 right slave) at frame `i`: turned by 0.1 rad a frame about z.
std::string block(int arm, int i, double scale) {
  const double angle = 0.1 * i;
  const double c = scale * std::cos(angle);
  const double s = scale * std::sin(angle);
  return fmt::format("   {:.9f}   {:.9f}   0.03   {:.9f} {:.9f} 0 {:.9f} {:.9f} 0 0 0 {}   1 2 3 4 5 6   {}", 0.001 * i,
                     0.1 * arm, c, -s, s, c, scale, 0.01 * arm);
}

std::string lines(int count, double scale = 1.0) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    for (int arm = 0; arm < 4; ++arm) text += block(arm, i, scale);
    text += "\r\n";
  }
  return text;
}

std::string refusal(std::string_view kinematics, std::string_view transcription = "") {
  const auto read = from_jigsaws(kinematics, transcription);
  REQUIRE_FALSE(read.has_value());
  return read.error().text();
}

}  // namespace

TEST_CASE("the slave arms of a JIGSAWS file are read at thirty frames a second") {
  const Imported read = from_jigsaws(lines(31), "").value();
  const auto& samples = read.recording.samples;
  REQUIRE(samples.size() == 31);
  CHECK(samples[1].tick == 33);
  CHECK(samples[30].tick == 1000);
  CHECK(samples[5].arms[0].setpoint_p[0] == 0.005);
  CHECK(samples[5].arms[0].setpoint_p[1] == doctest::Approx(0.2));
  CHECK(samples[5].arms[1].setpoint_p[1] == doctest::Approx(0.3));
  CHECK(samples[5].arms[1].setpoint_jaw_rad == 0.03);
  CHECK(spatial::angle_between(samples[5].arms[0].setpoint().q, samples[0].arms[0].setpoint().q) ==
        doctest::Approx(0.5).epsilon(1e-6));
  CHECK(read.recording.provenance.block == demonstration::kUnknownPlace);
  CHECK(mentions(read.lossy, "the master arms"));
}

TEST_CASE("quaternions made of rotation matrices never change sign on the way") {
  const Imported read = from_jigsaws(lines(100), "").value();  // ten radians: more than a whole turn
  for (std::size_t i = 1; i < read.recording.samples.size(); ++i) {
    const auto q = [&](std::size_t at) { return read.recording.samples[at].arms[0].setpoint().q; };
    CHECK(q(i).dot(q(i - 1)) > 0.0);
  }
}

TEST_CASE("gestures become notes") {
  const Imported read = from_jigsaws(lines(31), "1 10 G1 \r\n\n11 31 G5\n").value();
  REQUIRE(read.notes.size() == 2);
  CHECK(read.notes[0].text == "G1");
  CHECK(read.notes[0].from_s == 0.0);
  CHECK(read.notes[1].from_s == doctest::Approx(10.0 / 30.0));
  CHECK(read.notes[1].to_s == doctest::Approx(1.0));
  CHECK(read.notes[1].tag == "gesture");
}

TEST_CASE("rounded rotations are said, other matrices refused") {
  CHECK_FALSE(mentions(from_jigsaws(lines(3), "")->found, "rounded"));
  CHECK(mentions(from_jigsaws(lines(3, 1.001), "")->found, "rotation matrices are rounded"));
  CHECK(refusal(lines(3, 1.5)) == "line 1: columns 42 to 50 are no rotation");
  CHECK(refusal(lines(3, -1.0)) == "line 1: columns 42 to 50 are no rotation");
}

TEST_CASE("a wrong JIGSAWS file gives one sentence with the line at fault") {
  CHECK(refusal("") == "a demonstration needs at least 2 lines of kinematics");
  CHECK(refusal(lines(1)) == "a demonstration needs at least 2 lines of kinematics");
  CHECK(refusal(lines(2) + "1 2 3\n") == "line 3: it has 3 numbers where JIGSAWS has 76");
  CHECK(refusal("none " + lines(2)) == "line 1: column 1 must be a number, not \"none\"");
  CHECK(refusal("0 " + lines(2)).find("line 1:") == 0);
  CHECK(refusal(lines(3), "1 2\n") == "the transcription, line 1: it must be FIRST LAST GESTURE");
  CHECK(refusal(lines(3), "1 9 G1\n") == "the transcription, line 1: it names frames 1 to 9, there are 1 to 3");
  CHECK(refusal(lines(3), "3 2 G1\n") == "the transcription, line 1: it names frames 3 to 2, there are 1 to 3");
}

TEST_CASE("a frame without a number is left out and told, and the others keep their times") {
  std::string text = lines(31);
  // A word of the third line that is the left slave's.
  std::size_t at = text.find('\n', text.find('\n') + 1) + 1;
  for (int word = 0; word < 40; ++word) at = text.find_first_not_of(' ', text.find(' ', at));
  text.replace(at, text.find(' ', at) - at, "nan");
  const Imported read = from_jigsaws(text, "1 31 G1\n").value();
  REQUIRE(read.recording.samples.size() == 30);
  CHECK(read.recording.samples[2].tick == 100);
  CHECK(mentions(read.found, "1 frame is left out, the first is line 3: a number is missing"));
  CHECK(read.notes[0].to_s == doctest::Approx(1.0));
}

TEST_CASE("an import is moved to where its frame is on the board, and says what is odd about it") {
  const testing::ScratchFolder folder;
  REQUIRE(write_file(folder / "k.txt", lines(31)));
  REQUIRE(write_file(folder / "t.txt", "1 3 G2\n"));
  ImportOptions options;
  options.transcription = folder / "t.txt";
  options.X_WF.p = {0.0, -0.2, 0.0};
  CHECK(guess_format(folder / "k.txt").value() == Format::kJigsaws);
  const Imported read = import_demonstration(folder / "k.txt", Format::kJigsaws, options).value();
  CHECK(read.notes.size() == 1);
  CHECK(read.recording.samples[0].arms[0].setpoint_p[1] == doctest::Approx(0.0));
  CHECK(read.recording.samples[0].arms[0].measured.p[1] == doctest::Approx(0.0F));
  CHECK_FALSE(import_demonstration(folder / "k.txt", Format::kCsv, options));
  CHECK_FALSE(export_demonstration(testing::moving_demonstration(10), folder / "out.txt", Format::kJigsaws));
}

TEST_CASE("findings tell the rate, gaps, sign changes, idleness and what is off the lattice") {
  demonstration::Recording recording = testing::moving_recording(400);
  for (std::size_t i = 200; i < 400; ++i) recording.samples[i].tick += 595;
  for (std::size_t i = 100; i < 400; ++i) {
    for (double& part : recording.samples[i].arms[1].setpoint_q_wxyz) part = -part;
  }
  for (std::size_t i = 300; i < 400; ++i) recording.samples[i].arms[1].setpoint_p[2] += 0.04;
  for (demonstration::Sample& sample : recording.samples) sample.arms[0].measured.p[0] += 5.0F;
  const auto document =
      demonstration::make_demonstration({1}, "odd", std::make_shared<const demonstration::Recording>(recording))
          .value();
  const std::vector<std::string> found = findings(document, spatial::Grid{});
  CHECK(found.front() == "200 samples a second");
  CHECK(mentions(found, "1 gap, the longest 0.60 s at"));
  CHECK(mentions(found, "the right tool's quaternion changes sign 1 time"));
  CHECK(mentions(found, "100 % of the left tool's samples are outside of the learning lattice"));
  CHECK_FALSE(mentions(found, "the left tool's quaternion"));
  CHECK(mentions(found, "the right tool jumps 1 time, by 40 mm at 2.09 s at the farthest"));
  CHECK_FALSE(mentions(found, "the left tool jumps"));
}
