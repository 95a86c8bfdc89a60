#include "engine/exchange/exchange.h"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "engine/core/file.h"
#include "engine/demonstration/edits.h"
#include "engine/exchange/columns.h"
#include "engine/exchange/csv.h"
#include "engine/exchange/npy.h"
#include "tests/support/document_samples.h"
#include "tests/support/scratch_folder.h"

using namespace trocar;
using namespace trocar::exchange;
using demonstration::Demonstration;
using demonstration::Sample;
using testing::moving_demonstration;
using testing::moving_recording;

namespace {

/// Samples of which every number uses all its digits.
Demonstration odd_demonstration(int count) {
  demonstration::Recording recording = moving_recording(count);
  for (std::size_t i = 0; i < recording.samples.size(); ++i) {
    Sample& sample = recording.samples[i];
    const double odd = 1.0 / (3.0 + static_cast<double>(i));
    sample.tick += 70000;
    for (demonstration::ArmSample& arm : sample.arms) {
      arm.setpoint_p[0] += 1e-3 * odd;
      arm.setpoint_jaw_rad = -odd;
      arm.measured.p[1] += static_cast<float>(1e-3 * odd);
      arm.joints = {0.1F, -0.2F, static_cast<float>(odd), 1e-30F, -3.1F, 0.0F};
    }
    for (demonstration::CompactPose& block : sample.blocks) block.p = {static_cast<float>(odd), 0.5F, -0.25F};
    sample.flags = static_cast<std::uint32_t>(i % 16);
    sample.authority = static_cast<demonstration::Authority>(i % 4);
  }
  return demonstration::make_demonstration({1}, "Odd",
                                           std::make_shared<const demonstration::Recording>(std::move(recording)))
      .value();
}

/// Equal to the bit, but for the first tick, from which an export counts.
bool same_samples(const Demonstration& document, const std::vector<Sample>& read) {
  std::vector<Sample> expected = document.gated().to_vector();
  for (Sample& sample : expected) sample.tick -= document.first_tick();
  return expected.size() == read.size() &&
         std::memcmp(expected.data(), read.data(), expected.size() * sizeof(Sample)) == 0;
}

std::string minimal_header() {
  std::string header;
  for (const Column& column : columns()) {
    if (column.required) header += fmt::format("{}{}", header.empty() ? "" : ",", column.name);
  }
  return header;
}

/// A row for `minimal_header` at `t_s`: both tools at rest.
std::string minimal_row(const std::string& t_s) {
  return t_s + ",0,0,0.03,1,0,0,0,0.5,0,0.02,0.03,1,0,0,0,0.5";
}

std::string csv_error(const std::string& text) {
  const Result<Imported> read = from_csv(text);
  REQUIRE_FALSE(read);
  CHECK(read.error().code() == ErrorCode::kCorrupt);
  return read.error().text();
}

}  // namespace

TEST_CASE("every sample comes back from CSV and from NPY to the bit") {
  const Demonstration document = odd_demonstration(300);
  CHECK(same_samples(document, from_csv(to_csv(document))->recording.samples));
  CHECK(same_samples(document, from_npy(to_npy(document))->recording.samples));
}

TEST_CASE("an export holds what is between the gates, with the labels as edited") {
  const Demonstration trimmed = demonstration::apply(moving_demonstration(1000), demonstration::Trim{1.0, 2.0}).value();
  const Demonstration labelled =
      demonstration::apply(trimmed, demonstration::LabelSegment{demonstration::Segment::kE, 1.0, 1.5}).value();
  const Imported read = from_csv(to_csv(labelled)).value();
  REQUIRE(read.recording.samples.size() == 201);
  CHECK(read.recording.samples.front().tick == 1000);
  CHECK(read.recording.samples.front().segment == demonstration::Segment::kE);
  CHECK(read.recording.samples.back().segment == demonstration::Segment::kC);
}

TEST_CASE("an import is marked as imported and has no world to replay from") {
  const demonstration::Recording recording = from_csv(to_csv(moving_demonstration(10)))->recording;
  CHECK(recording.provenance.operator_kind == "imported");
  CHECK(recording.initial_world.empty());
}

TEST_CASE("time and setpoints are enough, and what is missing is listed") {
  const std::string text = minimal_header() + "\r\n" + minimal_row("0") + "\r\n" + minimal_row("0.02") + "\r\n\r\n";
  const Imported read = from_csv(text).value();
  REQUIRE(read.recording.samples.size() == 2);
  CHECK(read.recording.samples[1].tick == 20);
  CHECK(read.recording.samples[1].arms[1].measured.p[1] == 0.02F);
  CHECK(read.recording.samples[1].arms[1].jaw_rad == 0.5F);
  CHECK(std::find(read.lossy.begin(), read.lossy.end(), "the blocks") != read.lossy.end());
}

TEST_CASE("an import claims no block, goal or outcome that its file does not tell") {
  const std::string text = minimal_header() + "\n" + minimal_row("0") + "\n" + minimal_row("0.02") + "\n";
  const Imported read = from_csv(text).value();
  CHECK(read.recording.provenance.block == demonstration::kUnknownPlace);
  CHECK(read.recording.provenance.goal == demonstration::kUnknownPlace);
  CHECK(read.recording.outcome == demonstration::Outcome::kUnknown);
  CHECK(std::find(read.lossy.begin(), read.lossy.end(), "its block, goal and outcome") != read.lossy.end());
  const std::vector<std::string> left_out = lost_by_export(odd_demonstration(3));
  CHECK(std::find(left_out.begin(), left_out.end(), "its block, goal and outcome") != left_out.end());
}

TEST_CASE("columns may come in any order") {
  const Demonstration document = odd_demonstration(3);
  std::string header;
  std::vector<std::string> rows(3);
  for (auto column = columns().rbegin(); column != columns().rend(); ++column) {
    header += fmt::format("{}{}", header.empty() ? "" : ", ", column->name);
    const std::vector<Sample> samples = table_samples(document);
    for (std::size_t i = 0; i < 3; ++i) {
      rows[i] += fmt::format("{}{:.17g}", rows[i].empty() ? "" : ",", column->read(samples[i]));
    }
  }
  const std::string text = header + "\n" + rows[0] + "\n" + rows[1] + "\n" + rows[2];
  CHECK(same_samples(document, from_csv(text)->recording.samples));
}

TEST_CASE("a wrong CSV gives one error with the line at fault") {
  const std::string header = minimal_header() + "\n";
  const std::string first = minimal_row("0") + "\n";
  CHECK(csv_error("") == "the file is empty");
  CHECK(csv_error("t_s,speed\n") == "line 1: no column is named \"speed\"");
  CHECK(csv_error("t_s,t_s\n") == "line 1: the column t_s is there twice");
  CHECK(csv_error("t_s\n0\n") == "line 1: the column left_setpoint_x_m is missing");
  CHECK(csv_error(header) == "a demonstration needs at least 2 rows of samples");
  CHECK(csv_error(header + first) == "a demonstration needs at least 2 rows of samples");
  CHECK(csv_error(header + first + "0.1,2\n") == "line 3: it must have 17 values, as many as the first line");
  CHECK(csv_error(header + first + minimal_row("0.1") + ",7\n") ==
        "line 3: it must have 17 values, as many as the first line");
  CHECK(csv_error(header + first + minimal_row("abc") + "\n") == "line 3: t_s must be a number, not \"abc\"");
  CHECK(csv_error(header + first + minimal_row("nan") + "\n") == "line 3: t_s is not a finite number");
  CHECK(csv_error(header + first + minimal_row("-1") + "\n") == "line 3: t_s must be from 0 to 2700000 s");
  CHECK(csv_error(header + first + "\n\n" + minimal_row("0.0001")) ==
        "line 5: t_s must be at least a millisecond after that of the row before");
  CHECK(csv_error(header + "0,0,0,0,0,0,0,0,0,0,0,0,1,0,0,0,0\n") == "line 2: left_setpoint_q is no rotation");
}

TEST_CASE("a label that is no whole number in its range is refused") {
  const std::string header = minimal_header() + ",segment\n";
  CHECK(csv_error(header + minimal_row("0") + ",5\n") == "line 2: segment must be a whole number from 0 to 4");
  CHECK(csv_error(header + minimal_row("0") + ",1.5\n") == "line 2: segment must be a whole number from 0 to 4");
}

TEST_CASE("an array of another kind is refused with its reason") {
  const std::string good = to_npy(moving_demonstration(10));
  const auto error_after = [&](std::string_view from, std::string_view to) {
    std::string bytes = good;
    bytes.replace(bytes.find(from), from.size(), to);
    return from_npy(bytes).error().text();
  };
  CHECK(error_after("<f8", "<f4") == "the array must be of little-endian float64 ('<f8')");
  CHECK(error_after("False", "True ") == "the array must be in C order");
  CHECK(error_after("(10, ", "(11, ").find("do not fit") != std::string::npos);
  CHECK(from_npy("hello").error().text() == "the file is not a NumPy array");
  CHECK(error_after("(10, ", "(10, 1").find("columns where a demonstration has") != std::string::npos);
}

TEST_CASE("an array cut off at any byte is refused, and a NaN is named by its row") {
  std::string bytes = to_npy(moving_demonstration(3));
  for (std::size_t size = 0; size < bytes.size(); size += 7) CHECK_FALSE(from_npy(bytes.substr(0, size)));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::memcpy(bytes.data() + bytes.size() - sizeof nan, &nan, sizeof nan);
  CHECK(from_npy(bytes).error().text() == "row 3: segment is not a finite number");
}

TEST_CASE("the data of an array file begins at a multiple of 64 bytes") {
  const std::string bytes = to_npy(moving_demonstration(10));
  CHECK((bytes.size() - 10 * columns().size() * sizeof(double)) % 64 == 0);
}

TEST_CASE("files are written whole, read back, and named in errors") {
  const testing::ScratchFolder folder;
  const Demonstration document = moving_demonstration(20);
  const auto lossy = export_demonstration(document, folder / "d.csv", Format::kCsv);
  REQUIRE(lossy);
  CHECK(lossy->size() == 7);
  CHECK(guess_format("d.csv").value() == Format::kCsv);
  CHECK(guess_format("d.npy").value() == Format::kNpy);
  CHECK_FALSE(guess_format("d.bag"));
  CHECK_FALSE(format_from("bag"));
  const Imported read = import_demonstration(folder / "d.csv", Format::kCsv).value();
  CHECK(read.recording.provenance.device == "d.csv");
  CHECK(same_samples(document, read.recording.samples));
  REQUIRE(write_file(folder / "bad.csv", "t_s\n"));
  const auto bad = import_demonstration(folder / "bad.csv", Format::kCsv);
  CHECK(bad.error().text().ends_with("bad.csv"));
  CHECK(import_demonstration(folder / "none.csv", Format::kCsv).error().code() == ErrorCode::kIo);
  CHECK(export_demonstration(document, folder / "no/d.csv", Format::kCsv).error().code() == ErrorCode::kIo);
}

TEST_CASE("a file of several pieces reads as its bytes do at once, and names the row that is wrong in a later piece") {
  const testing::ScratchFolder folder;
  const Demonstration document = odd_demonstration(11000);
  const std::string csv = to_csv(document);
  const std::string npy = to_npy(document);
  REQUIRE(csv.size() > std::size_t{1} << 23U);
  REQUIRE(npy.size() > std::size_t{1} << 22U);
  REQUIRE(write_file(folder / "a.csv", csv));
  REQUIRE(write_file(folder / "a.npy", npy));
  CHECK(same_samples(document, read_csv(folder / "a.csv")->recording.samples));
  CHECK(same_samples(document, read_npy(folder / "a.npy")->recording.samples));
  // Without the end of its last line, and with the ends of another system.
  std::string other = csv.substr(0, csv.size() - 1);
  for (std::size_t at = other.find('\n'); at != std::string::npos; at = other.find('\n', at + 2))
    other.insert(at, "\r");
  REQUIRE(write_file(folder / "b.csv", other));
  CHECK(same_samples(document, read_csv(folder / "b.csv")->recording.samples));
  std::string wrong = csv;
  wrong[csv.rfind('\n', csv.size() - 2) + 1] = 'x';
  REQUIRE(write_file(folder / "c.csv", wrong));
  CHECK(read_csv(folder / "c.csv").error().text().starts_with("line 11001: t_s must be a number"));
  REQUIRE(write_file(folder / "c.npy", npy.substr(0, npy.size() - 8)));
  CHECK(read_npy(folder / "c.npy").error().text().find("do not fit") != std::string::npos);
}
