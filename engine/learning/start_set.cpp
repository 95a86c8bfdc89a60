#include "engine/learning/start_set.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "engine/core/random.h"
#include "engine/learning/rollout.h"

namespace trocar::learning {
namespace {

using spatial::CellCoordinates;
using spatial::CellIndex;
using Starts = Result<std::vector<CellIndex>>;

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

template <typename T>
std::optional<T> number(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

struct Range {
  int first = 0;
  int last = 0;
};
/// "3-7" or "3", within 0 … most − 1.
std::optional<Range> range(std::string_view text, int most) {
  const std::size_t dash = text.find('-');
  const auto first = number<int>(text.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : number<int>(text.substr(dash + 1));
  if (!first || !last || *first < 0 || *last < *first || *last >= most) return std::nullopt;
  return Range{*first, *last};
}

template <typename Predicate>
std::vector<CellIndex> cells_where(const spatial::Grid& grid, Predicate predicate) {
  std::vector<CellIndex> cells;
  for (std::int32_t cell = 0; cell < grid.cell_count(); ++cell) {
    if (predicate(grid.coordinates({cell}))) cells.push_back({cell});
  }
  return cells;
}

Starts around(std::string_view rest, const Model& model) {
  const auto k = number<int>(rest);
  if (k && *k >= 0 && *k < model.grid.n) return starts_around(model, *k);
  return fail(ErrorCode::kInvalidArgument, fmt::format("around: needs a number of cells, 0 … {}", model.grid.n - 1));
}

Starts box(std::string_view rest, const Model& model) {
  const std::vector<std::string_view> parts = split(rest, ',');
  std::array<Range, 3> ranges{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto found = parts.size() == 3 ? range(parts[axis], model.grid.n) : std::nullopt;
    if (!found) {
      return fail(ErrorCode::kInvalidArgument,
                  fmt::format("box: needs three ranges of cells within 0 … {}, as box:3-7,0-21,10", model.grid.n - 1));
    }
    ranges[axis] = *found;
  }
  return cells_where(model.grid, [&](const CellCoordinates& c) {
    return c.x >= ranges[0].first && c.x <= ranges[0].last && c.y >= ranges[1].first && c.y <= ranges[1].last &&
           c.z >= ranges[2].first && c.z <= ranges[2].last;
  });
}

Starts face(std::string_view rest, const Model& model) {
  const std::size_t axis = rest.empty() ? std::string_view::npos : std::string_view("xyz").find(rest[0]);
  if (rest.size() != 2 || axis == std::string_view::npos || (rest[1] != '0' && rest[1] != '1')) {
    return fail(ErrorCode::kInvalidArgument, "face: needs an axis and an end, as face:z1 (the top)");
  }
  const int wanted = rest[1] == '0' ? 0 : model.grid.n - 1;
  return cells_where(model.grid, [&](const CellCoordinates& c) {
    return (axis == 0 ? c.x : axis == 1 ? c.y : c.z) == wanted;
  });
}

Starts sphere(std::string_view rest, const Model& model) {
  const std::vector<std::string_view> parts = split(rest, ',');
  std::array<double, 4> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto found = parts.size() == 4 ? number<double>(parts[i]) : std::nullopt;
    if (!found || !(std::abs(*found) < 1e6) || (i == 3 && *found < 0.0)) {
      return fail(ErrorCode::kInvalidArgument, "sphere: needs a cell and a radius in cells, as sphere:11,12,19,3.5");
    }
    values[i] = *found;
  }
  std::vector<CellIndex> cells = cells_where(model.grid, [&](const CellCoordinates& c) {
    const double x = c.x - values[0];
    const double y = c.y - values[1];
    const double z = c.z - values[2];
    return x * x + y * y + z * z <= values[3] * values[3];
  });
  if (cells.empty()) return fail(ErrorCode::kInvalidArgument, "no cell of the lattice lies within that sphere");
  return cells;
}

Starts gaussian(std::string_view rest, const Model& model) {
  const std::vector<std::string_view> parts = split(rest, ',');
  const auto sigma_mm = parts.size() == 3 ? number<double>(parts[0]) : std::nullopt;
  const auto count = parts.size() == 3 ? number<int>(parts[1]) : std::nullopt;
  const auto seed = parts.size() == 3 ? number<std::uint64_t>(parts[2]) : std::nullopt;
  if (!sigma_mm || !count || !seed || !(*sigma_mm > 0.0 && *sigma_mm <= 100.0) || *count < 1 || *count > kMostDraws) {
    return fail(
        ErrorCode::kInvalidArgument,
        "gaussian: needs a standard deviation of up to 100 mm, up to 1,000,000 draws and a seed, as gaussian:5,200,1");
  }
  Random random(*seed);
  const Eigen::Vector3d middle = model.grid.centre(model.start);
  std::vector<CellIndex> cells;
  cells.reserve(static_cast<std::size_t>(*count));
  while (cells.size() < static_cast<std::size_t>(*count)) {
    // The lattice is a box: to draw one coordinate anew is to draw from the same distribution, and takes fewer tries.
    Eigen::Vector3d place;
    for (int axis = 0; axis < 3; ++axis) {
      const double low = model.grid.p_WGo[axis];
      do {
        place[axis] = middle[axis] + 1e-3 * *sigma_mm * random.normal();
      } while (place[axis] < low || place[axis] >= low + model.grid.n * model.grid.cell_m);
    }
    if (const Result<CellIndex> cell = model.grid.cell_at(place)) cells.push_back(*cell);
  }
  return cells;
}

/// One draw in each of N equal parts of every axis, the parts of the axes matched at random (McKay et al. 1979).
Starts latin(std::string_view rest, const Model& model) {
  const std::vector<std::string_view> parts = split(rest, ',');
  const bool near = parts.size() == 3;
  const auto count = parts.size() == 2 || near ? number<int>(parts[0]) : std::nullopt;
  const auto seed = count ? number<std::uint64_t>(parts[1]) : std::nullopt;
  const auto k = near ? number<int>(parts[2]) : std::optional<int>(model.grid.n);
  if (!count || !seed || !k || *count < 1 || *count > kMostDraws || *k < 0 || *k > model.grid.n) {
    return fail(ErrorCode::kInvalidArgument,
                "latin: needs up to 1,000,000 draws, a seed and, if not of the whole lattice, a number of cells around "
                "the start, as latin:200,1 or latin:200,1,3");
  }
  const CellCoordinates start = model.grid.coordinates(model.start);
  Random random(*seed);
  const auto draws = static_cast<std::size_t>(*count);
  std::array<std::vector<int>, 3> places;
  for (std::size_t axis = 0; axis < places.size(); ++axis) {
    const int middle = axis == 0 ? start.x : axis == 1 ? start.y : start.z;
    const int low = std::max(0, middle - *k);
    const int cells = std::min(model.grid.n - 1, middle + *k) - low + 1;
    for (std::size_t i = 0; i < draws; ++i) {
      const double part = (static_cast<double>(i) + random.uniform()) / static_cast<double>(draws);
      places[axis].push_back(low + std::min(static_cast<int>(part * cells), cells - 1));
    }
    for (std::size_t i = draws; i > 1; --i) {
      std::swap(places[axis][i - 1],
                places[axis][static_cast<std::size_t>(random.below(static_cast<std::uint32_t>(i)))]);
    }
  }
  std::vector<CellIndex> found;
  for (std::size_t i = 0; i < draws; ++i) {
    found.push_back(model.grid.index({places[0][i], places[1][i], places[2][i]}));
  }
  return found;
}

Starts listed(std::string_view rest, const Model& model) {
  spatial::CellSet set(model.grid);
  for (const std::string_view part : split(rest, ',')) {
    const auto found = range(part, model.grid.cell_count());
    if (!found) {
      return fail(ErrorCode::kInvalidArgument, fmt::format("\"{}\" is no cell, nor a range of cells, within 0 … {}",
                                                           part.substr(0, 40), model.grid.cell_count() - 1));
    }
    for (int cell = found->first; cell <= found->last; ++cell) set.insert({cell});
  }
  std::vector<CellIndex> cells;
  for (std::int32_t cell = 0; cell < model.grid.cell_count(); ++cell) {
    if (set.contains({cell})) cells.push_back({cell});
  }
  return cells;
}

struct Form {
  std::string_view name;
  Starts (*read)(std::string_view rest, const Model& model);
};
constexpr std::array<Form, 7> kForms{{{"around:", around},
                                      {"box:", box},
                                      {"face:", face},
                                      {"sphere:", sphere},
                                      {"gaussian:", gaussian},
                                      {"latin:", latin},
                                      {"cells:", listed}}};

}  // namespace

std::string_view start_set_help() {
  return "all, around:K (within ±K cells of the start), box:X0-X1,Y0-Y1,Z0-Z1, face:x0 … face:z1, sphere:X,Y,Z,R, "
         "gaussian:SIGMA_MM,N,SEED, latin:N,SEED (or latin:N,SEED,K near the start), cells:A,B-C or file:F.csv "
         "(columns i,j,k)";
}

Starts starts_from(std::string_view text, const Model& model) {
  if (text == "all") return cells_where(model.grid, [](const CellCoordinates&) { return true; });
  for (const Form& form : kForms) {
    if (text.starts_with(form.name)) return form.read(text.substr(form.name.size()), model);
  }
  return fail(ErrorCode::kInvalidArgument,
              fmt::format("\"{}\" names no starts; use {}", text.substr(0, 40), start_set_help()));
}

std::string start_text(const std::vector<CellIndex>& cells) {
  std::vector<CellIndex> sorted = cells;
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  std::string text = "cells:";
  for (std::size_t i = 0; i < sorted.size();) {
    std::size_t last = i;
    while (last + 1 < sorted.size() && sorted[last + 1].value == sorted[last].value + 1) ++last;
    text += fmt::format("{}{}", i == 0 ? "" : ",", sorted[i].value);
    if (last > i) text += fmt::format("-{}", sorted[last].value);
    i = last + 1;
  }
  return text;
}

}  // namespace trocar::learning
