#include "engine/exchange/jigsaws.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "engine/exchange/text_lines.h"

namespace trocar::exchange {
namespace {

using demonstration::ArmSample;
using demonstration::Sample;

constexpr std::size_t kColumns = 76;
constexpr std::array<std::size_t, 2> kFirstColumn{38, 57};  ///< Of the left and of the right slave, from 0.
constexpr std::size_t kColumnsOfArm = 19;
constexpr double kRate_hz = 30.0;
/// Further from a rotation than a file's rounding explains.
constexpr double kFarFromJigsawsRotation = 0.05;
constexpr double kRoundedDigits = 1e-5;

using Row = std::array<double, kColumns>;

/// The next word of `text`, which loses it; empty at its end.
std::string_view take_word(std::string_view& text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  std::size_t length = 0;
  while (length < text.size() && !is_blank(text[length])) ++length;
  const std::string_view word = text.substr(0, length);
  text.remove_prefix(length);
  return word;
}

template <typename Number>
bool parse(std::string_view word, Number& value) {
  const auto parsed = std::from_chars(word.data(), word.data() + word.size(), value);
  return parsed.ec == std::errc() && parsed.ptr == word.data() + word.size() && !word.empty();
}

Status read_row(std::string_view line, std::size_t number, Row& row) {
  for (std::size_t i = 0; i < kColumns; ++i) {
    const std::string_view word = take_word(line);
    if (word.empty()) return wrong_line(number, fmt::format("it has {} numbers where JIGSAWS has {}", i, kColumns));
    if (!parse(word, row[i]) || (std::isfinite(row[i]) && std::abs(row[i]) > 1e6)) {
      return wrong_line(number, fmt::format("column {} must be a number, not \"{}\"", i + 1, word.substr(0, 40)));
    }
  }
  if (!take_word(line).empty()) return wrong_line(number, fmt::format("it has more than {} numbers", kColumns));
  return {};
}

/// Turns rows into samples and keeps in mind what it had to put right.
class Kinematics {
 public:
  /// A frame without a number where one is needed is left out; its time stays empty.
  Status add(const Row& row, std::size_t line) {
    Sample sample;
    sample.tick = std::llround(static_cast<double>(frames++) * Tick::kPerSecond / kRate_hz);
    for (const std::size_t first : kFirstColumn) {
      const bool whole = std::all_of(row.begin() + static_cast<std::ptrdiff_t>(first),
                                     row.begin() + static_cast<std::ptrdiff_t>(first + kColumnsOfArm),
                                     [](double number) { return std::isfinite(number); });
      if (whole) continue;
      if (left_out++ == 0) first_left_out = line;
      return {};
    }
    for (std::size_t arm = 0; arm < 2; ++arm) {
      const double* column = row.data() + kFirstColumn[arm];
      TROCAR_ASSIGN_OR_RETURN(const Eigen::Quaterniond q, rotation(column + 3, arm, line));
      const spatial::Pose tip{{column[0], column[1], column[2]}, q};
      ArmSample& into = sample.arms[arm];
      into.set_setpoint(tip, column[18]);
      into.measured = demonstration::CompactPose::from(tip);
      into.jaw_rad = static_cast<float>(column[18]);
    }
    samples.push_back(sample);
    return {};
  }

  std::vector<Sample> samples;
  std::size_t frames = 0;    ///< Those that were left out, too.
  std::size_t left_out = 0;  ///< Of them.
  std::size_t first_left_out = 0;
  double worst_rotation = 0.0;

 private:
  /// By rows; of the two quaternions the one that is nearer to the last.
  Result<Eigen::Quaterniond> rotation(const double* rows, std::size_t arm, std::size_t line) {
    const Eigen::Matrix3d R = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rows);
    const double off = (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
    if (!(off <= kFarFromJigsawsRotation) || R.determinant() <= 0.0) {
      const std::size_t first = kFirstColumn[arm] + 4;
      return wrong_line(line, fmt::format("columns {} to {} are no rotation", first, first + 8));
    }
    worst_rotation = std::max(worst_rotation, off);
    Eigen::Quaterniond q = Eigen::Quaterniond(R).normalized();
    if (q.dot(last_[arm]) < 0.0) q.coeffs() = -q.coeffs();
    last_[arm] = q;
    return q;
  }

  std::array<Eigen::Quaterniond, 2> last_{Eigen::Quaterniond::Identity(), Eigen::Quaterniond::Identity()};
};

Result<std::vector<demonstration::AddNote>> read_gestures(std::string_view text, std::size_t frames) {
  std::vector<demonstration::AddNote> notes;
  for (std::size_t number = 1; !text.empty(); ++number) {
    std::string_view line = take_line(text);
    const std::string_view first_word = take_word(line);
    if (first_word.empty()) continue;
    const std::string_view last_word = take_word(line);
    const std::string_view gesture = take_word(line);
    std::size_t first = 0;
    std::size_t last = 0;
    const bool numbers = parse(first_word, first) && parse(last_word, last);
    if (!numbers || gesture.empty() || gesture.size() > 40 || !take_word(line).empty()) {
      return fail(ErrorCode::kCorrupt,
                  fmt::format("the transcription, line {}: it must be FIRST LAST GESTURE", number));
    }
    if (first < 1 || last < first || last > frames) {
      return fail(ErrorCode::kCorrupt,
                  fmt::format("the transcription, line {}: it names frames {} to {}, there are 1 to {}", number, first,
                              last, frames));
    }
    const auto time_of = [](std::size_t frame) { return static_cast<double>(frame - 1) / kRate_hz; };
    notes.push_back({std::string(gesture), time_of(first), time_of(last), "gesture", 0});
  }
  return notes;
}

}  // namespace

Result<Imported> from_jigsaws(std::string_view kinematics, std::string_view transcription) {
  Kinematics read;
  Row row{};
  for (std::size_t number = 1; !kinematics.empty(); ++number) {
    const std::string_view line = take_line(kinematics);
    std::string_view rest = line;
    if (take_word(rest).empty()) continue;
    TROCAR_RETURN_IF_ERROR(read_row(line, number, row));
    TROCAR_RETURN_IF_ERROR(read.add(row, number));
  }
  if (read.samples.size() < 2) {
    return fail(ErrorCode::kCorrupt, "a demonstration needs at least 2 lines of kinematics");
  }
  Imported imported;
  TROCAR_ASSIGN_OR_RETURN(imported.notes, read_gestures(transcription, read.frames));
  TROCAR_RETURN_IF_ERROR(demonstration::check_samples(read.samples));
  if (read.left_out > 0) {
    imported.found.push_back(fmt::format("{} {} left out, the first is line {}: a number is missing", read.left_out,
                                         read.left_out == 1 ? "frame is" : "frames are", read.first_left_out));
  }
  if (read.worst_rotation > kRoundedDigits) {
    imported.found.push_back(fmt::format(
        "rotation matrices are rounded, off by up to {:.2g}; unit quaternions stand in", read.worst_rotation));
  }
  imported.found.emplace_back("times are those of 30 frames a second, in whole milliseconds");
  imported.recording.samples = std::move(read.samples);
  imported.recording.provenance.operator_kind = "imported";
  imported.recording.provenance.block = demonstration::kUnknownPlace;
  imported.recording.provenance.goal = demonstration::kUnknownPlace;
  imported.recording.outcome = demonstration::Outcome::kUnknown;
  imported.lossy = {"the master arms",
                    "the velocities",
                    "joints",
                    "the blocks",
                    "segments (all is labelled A)",
                    "setpoints (what was measured stands in)",
                    "its block, goal and outcome",
                    "a simulated world (it cannot be replayed)"};
  return imported;
}

}  // namespace trocar::exchange
