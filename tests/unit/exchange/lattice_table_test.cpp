#include "engine/exchange/lattice_table.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "engine/exchange/npy.h"

using namespace trocar;
using namespace trocar::exchange;
using learning::TableKind;
namespace fs = std::filesystem;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

const spatial::Grid& grid() {
  static const spatial::Grid made = spatial::Grid::with_cells(4);
  return made;
}

std::vector<double> numbered(std::size_t count) {
  std::vector<double> table;
  for (std::size_t i = 0; i < count; ++i) table.push_back(i % 5 == 2 ? kNan : -0.1 * static_cast<double>(i));
  return table;
}

bool same(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::isnan(a[i]) ? !std::isnan(b[i]) : a[i] != b[i]) return false;
  }
  return true;
}

std::string table_refusal(const Result<std::vector<double>>& table) {
  REQUIRE_FALSE(table);
  return table.error().text();
}

}  // namespace

TEST_CASE("a table comes back from a file as it was, both kinds, both formats") {
  for (const TableKind kind : {TableKind::kQ, TableKind::kTheta}) {
    const std::vector<double> table = numbered(64 * static_cast<std::size_t>(learning::table_width(kind)));
    for (const char* ending : {".npy", ".csv"}) {
      const fs::path path = fs::temp_directory_path() / ("trocar_table_" + std::to_string(::getpid()) + ending);
      REQUIRE(write_table(table, kind, grid(), path));
      CHECK(same(read_table(path, kind, grid()).value(), table));
      fs::remove(path);
    }
  }
}

TEST_CASE("the order is x, y, z, action, and both shapes are taken") {
  std::vector<double> table(64 * 6, 0.0);
  table[6 * static_cast<std::size_t>(grid().index({1, 2, 3}).value) + 4] = 7.0;  // +z
  const std::string whole = to_npy(NpyNumbers{{4, 4, 4, 6}, table});
  CHECK(parse_table_npy(whole, TableKind::kQ, grid()).value()[6 * ((1 * 4 + 2) * 4 + 3) + 4] == 7.0);
  CHECK(same(parse_table_npy(to_npy(NpyNumbers{{64, 6}, table}), TableKind::kQ, grid()).value(), table));
  const std::string text = "i,j,k,+x,-x,+y,-y,+z,-z\n1,2,3,0,0,0,0,7,nan\n";
  const std::vector<double> read = parse_table_csv(text, TableKind::kQ, grid()).value();
  CHECK(read[6 * 27 + 4] == 7.0);
  CHECK(std::isnan(read[6 * 27 + 5]));
  CHECK(std::isnan(read[0]));  // No line, not known.
}

TEST_CASE("Fortran order and whole numbers are read as what they mean") {
  std::string bytes = to_npy(NpyNumbers{{4, 4, 4}, std::vector<double>(64, 0.0)});
  bytes.replace(bytes.find("False"), 5, "True ");
  const std::size_t data = bytes.size() - 64 * sizeof(double);
  const double seven = 7.0;
  std::memcpy(bytes.data() + data + sizeof(double) * (1 + 4 * 2 + 16 * 3), &seven, sizeof seven);
  const std::vector<double> table = parse_table_npy(bytes, TableKind::kTheta, grid()).value();
  CHECK(table[static_cast<std::size_t>(grid().index({1, 2, 3}).value)] == 7.0);
}

TEST_CASE("lines without a header are cells in their order; a field's own CSV is rewards") {
  std::string rows;
  for (int i = 0; i < 64; ++i) rows += std::to_string(-i) + (i == 9 ? "e0\r\n" : "\n");
  const std::vector<double> table = parse_table_csv(rows, TableKind::kTheta, grid()).value();
  CHECK(table[9] == -9.0);
  CHECK(table[63] == -63.0);
  const std::vector<double> field =
      parse_table_csv("i,j,k,x_mm,y_mm,z_mm,value\n0,0,1,5,5,5,-2.5\n", TableKind::kTheta, grid()).value();
  CHECK(field[1] == -2.5);
  CHECK(std::isnan(field[0]));
}

TEST_CASE("a wrong shape is refused with both shapes and the order") {
  const std::string flat = to_npy(NpyNumbers{{4, 4, 6}, std::vector<double>(96, 0.0)});
  CHECK(
      table_refusal(parse_table_npy(flat, TableKind::kQ, grid())) ==
      "expected 4x4x4x6 or 64x6, found 4x4x6; the order is x, y, z, action with the action fastest, the actions +x -x "
      "+y -y +z -z");
  const std::string q = to_npy(NpyNumbers{{4, 4, 4, 6}, std::vector<double>(384, 0.0)});
  CHECK(table_refusal(parse_table_npy(q, TableKind::kTheta, grid())).starts_with("expected 4x4x4 or 64, found 4x4x4x6;"));
  CHECK(table_refusal(parse_table_csv("1,2,3,4,5,6\n", TableKind::kQ, grid()))
            .starts_with("expected 4x4x4x6 or 64x6, found 1x6;"));
}

TEST_CASE("what is wrong in a line is said with its number") {
  const auto said = [](const char* text, TableKind kind = TableKind::kTheta) {
    return table_refusal(parse_table_csv(text, kind, grid()));
  };
  CHECK(said("i,j,k,theta\n0,0,4,1\n") == "line 2: k is no whole number from 0 to 3");
  CHECK(said("i,j,k,theta\n0,0,0.5,1\n") == "line 2: k is no whole number from 0 to 3");
  CHECK(said("i,j,k,theta\n0,0,0,1\n0,0,0,2\n") == "line 3: this cell has a line already");
  CHECK(said("i,j,k,theta\n0,0,0,high\n") == "line 2: column 4 holds no number");
  CHECK(said("i,j,theta\n0,0,0\n") == "line 1: the header must have all of the columns i, j and k, or none");
  CHECK(said("i,j,k,+x,-x,+y,-y,+z\n", TableKind::kQ).starts_with("line 1: the header has no column -z"));
  CHECK(said("1,2,3\n", TableKind::kQ).starts_with("line 1: 3 numbers without a header"));
  CHECK(said("i,j,k,theta\n") == "there is no cell in the file");
}

TEST_CASE("another ending, a file that is not there, and an array cut short are refused") {
  CHECK(read_table("/tmp/table.txt", TableKind::kQ, grid()).error().code() == ErrorCode::kInvalidArgument);
  CHECK(write_table({}, TableKind::kQ, grid(), "/tmp/table.txt").error().code() == ErrorCode::kInvalidArgument);
  CHECK(read_table("/nowhere/table.npy", TableKind::kQ, grid()).error().code() == ErrorCode::kIo);
  std::string bytes = to_npy(NpyNumbers{{4, 4, 4}, std::vector<double>(64, 0.0)});
  bytes.pop_back();
  CHECK(parse_table_npy(bytes, TableKind::kTheta, grid()).error().code() == ErrorCode::kCorrupt);
}
