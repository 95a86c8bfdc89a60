#include "engine/workbench/library_columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/core/hash.h"

namespace trocar::workbench {
namespace {

using Kind = LibraryCell::Kind;

LibraryCell number(double value) {
  return {Kind::kNumber, value, {}};
}

LibraryCell text(std::string words) {
  return words.empty() ? LibraryCell{} : LibraryCell{Kind::kText, 0.0, std::move(words)};
}

template <typename Text>
LibraryCell joined(const Text& words) {
  std::string all;
  for (const std::string& word : words) all += all.empty() ? word : ", " + word;
  return text(std::move(all));
}

/// A column of what is measured: `Value` makes a cell of measures.
template <LibraryCell (*value)(const Measures&)>
LibraryCell measured(const LibraryRow& row) {
  return row.measures ? value(*row.measures) : LibraryCell{Kind::kPending, 0.0, {}};
}

LibraryCell arms(const Measures& measures) {
  const auto& [left, right] = measures.moves;
  return text(left && right ? "both" : left ? "left" : right ? "right" : "none");
}

LibraryCell path(const Measures& measures) {
  return number(1e3 * (measures.path_length_m[0] + measures.path_length_m[1]));
}

LibraryCell jerk(const Measures& measures) {
  return measures.mean_jerk_m_s3 ? number(*measures.mean_jerk_m_s3) : LibraryCell{};
}

LibraryCell peak_jerk(const Measures& measures) {
  return measures.peak_jerk_m_s3 ? number(*measures.peak_jerk_m_s3) : LibraryCell{};
}

LibraryCell idle(const Measures& measures) {
  return measures.idle_share ? number(100.0 * *measures.idle_share) : LibraryCell{};
}

LibraryCell clearance(const Measures& measures) {
  return measures.clearance_m ? number(1e3 * *measures.clearance_m) : LibraryCell{};
}

LibraryCell grid(const Measures& measures) {
  return measures.grid_error_m ? number(1e3 * *measures.grid_error_m) : LibraryCell{};
}

LibraryCell replay(const LibraryRow& row) {
  if (!row.replay) return text("unknown");
  return text(row.replay->verified ? "verified" : "diverged");
}

LibraryCell odd(const LibraryRow& row) {
  if (row.oddity) return number(row.oddity->deviations);
  return row.measures ? LibraryCell{} : LibraryCell{Kind::kPending, 0.0, {}};
}

constexpr bool kNumber = true;
constexpr bool kText = false;
constexpr bool kAtOnce = false;
constexpr bool kMeasured = true;
constexpr std::array<LibraryColumn, 23> kColumns{{
    {"id", "Id", "", "The number that it keeps for good", kNumber, 0, kAtOnce,
     [](const LibraryRow& row) { return number(static_cast<double>(row.id.value)); }},
    {"name", "Name", "", "What it is called", kText, 0, kAtOnce, [](const LibraryRow& row) { return text(row.name); }},
    {"length", "Length", "s", "From gate to gate", kNumber, 2, kAtOnce,
     [](const LibraryRow& row) { return number(row.duration_s); }},
    {"samples", "Samples", "", "Between the gates", kNumber, 0, kAtOnce,
     [](const LibraryRow& row) { return number(static_cast<double>(row.samples)); }},
    {"segment", "Segments", "", "Those that are labelled between the gates", kText, 0, kAtOnce,
     [](const LibraryRow& row) { return text(row.segments); }},
    {"outcome", "Outcome", "", "How the transfer ended, as it was recorded; unknown once edits changed the motion",
     kText, 0, kAtOnce, [](const LibraryRow& row) { return text(std::string(demonstration::to_string(row.outcome))); }},
    {"verdict", "Verdict", "", "How the transfer ended in a person's eyes", kText, 0, kAtOnce,
     [](const LibraryRow& row) {
       return row.marks.verdict == Verdict::kNone ? LibraryCell{} : text(std::string(to_string(row.marks.verdict)));
     }},
    {"flag", "Flag", "", "Good, bad or unsure", kText, 0, kAtOnce,
     [](const LibraryRow& row) {
       return row.marks.flag == Flag::kNone ? LibraryCell{} : text(std::string(to_string(row.marks.flag)));
     }},
    {"rating", "Rating", "", "1 to 5", kNumber, 0, kAtOnce,
     [](const LibraryRow& row) { return row.marks.rating == 0 ? LibraryCell{} : number(row.marks.rating); }},
    {"tag", "Tags", "", "Words that it was tagged with", kText, 0, kAtOnce,
     [](const LibraryRow& row) { return joined(row.marks.tags); }},
    {"arms", "Arms", "", "Those whose tool goes farther than 2 mm", kText, 0, kMeasured, measured<arms>},
    {"path", "Path", "mm", "Length of both tools' paths together", kNumber, 0, kMeasured, measured<path>},
    {"jerk", "Smoothed jerk", "m/s³",
     "Mean along the path with its tremor smoothed away, of the jerkier arm; Diff tells the raw jerk, tremor included",
     kNumber, 3, kMeasured, measured<jerk>},
    {"peak_jerk", "Peak smoothed jerk", "m/s³", "The largest along the path with its tremor smoothed away", kNumber, 2,
     kMeasured, measured<peak_jerk>},
    {"idle", "Idle", "%", "Share of the time in which neither tool moves", kNumber, 0, kMeasured, measured<idle>},
    {"clearance", "Clearance", "mm", "The least distance of a tool from what it could hit; below 0, in it", kNumber, 2,
     kMeasured, measured<clearance>},
    {"grid", "Grid error", "mm", "The farthest of segments A and C from the middle of its cell", kNumber, 2, kMeasured,
     measured<grid>},
    {"odd", "Odd", "", "How far from the others in length, jerk or stillness, in robust standard deviations", kNumber,
     1, kMeasured, odd},
    {"replay", "Replay", "", "Whether the simulator gave the same states again", kText, 0, kAtOnce, replay},
    {"model", "Models", "", "Those that were trained on it", kText, 0, kAtOnce,
     [](const LibraryRow& row) { return joined(row.models); }},
    {"source", "Source", "", "Who or what made the recording", kText, 0, kAtOnce,
     [](const LibraryRow& row) { return text(row.source); }},
    {"note", "Note", "", "What was written about it", kText, 0, kAtOnce,
     [](const LibraryRow& row) { return text(row.marks.note); }},
    {"hash", "Hash", "", "Of its content: equal for duplicates", kText, 0, kAtOnce,
     [](const LibraryRow& row) { return text(to_hex(row.hash)); }},
}};

}  // namespace

std::span<const LibraryColumn> library_columns() {
  return kColumns;
}

const LibraryColumn* find_library_column(std::string_view id) {
  const auto* found = std::find_if(kColumns.begin(), kColumns.end(), [&](const auto& each) { return each.id == id; });
  return found == kColumns.end() ? nullptr : found;
}

std::string shown_cell(const LibraryColumn& column, const LibraryRow& row) {
  const LibraryCell cell = column.cell(row);
  switch (cell.kind) {
    case Kind::kNone:
      return "–";
    case Kind::kPending:
      return "…";
    case Kind::kNumber:
      return fmt::format("{:.{}f}", cell.number, column.decimals);
    case Kind::kText:
      return cell.text;
  }
  return {};
}

void sort_library(std::vector<const LibraryRow*>& rows, const LibraryColumn& by, bool descending) {
  struct Keyed {
    const LibraryRow* row;
    LibraryCell cell;
    bool known;
  };
  std::vector<Keyed> keyed;
  keyed.reserve(rows.size());
  for (const LibraryRow* row : rows) {
    LibraryCell cell = by.cell(*row);
    const bool known = cell.kind == Kind::kNumber || cell.kind == Kind::kText;
    keyed.push_back({row, std::move(cell), known});
  }
  std::stable_sort(keyed.begin(), keyed.end(), [descending](const Keyed& a, const Keyed& b) {
    if (a.known != b.known) return a.known;
    if (!a.known) return false;
    const LibraryCell& first = descending ? b.cell : a.cell;
    const LibraryCell& second = descending ? a.cell : b.cell;
    return first.kind == Kind::kNumber ? first.number < second.number : first.text < second.text;
  });
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = keyed[i].row;
}

}  // namespace trocar::workbench
