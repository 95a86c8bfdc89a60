#include "engine/exchange/column_map.h"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/core/file.h"
#include "engine/exchange/column_guess.h"
#include "engine/exchange/column_names.h"
#include "engine/exchange/exchange.h"
#include "engine/exchange/mapped_table.h"
#include "engine/exchange/number_table.h"
#include "engine/kinematics/psm.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/sentences.h"

using namespace trocar;
using namespace trocar::exchange;

using trocar::testing::mentions;

namespace {

/// Seconds in `t`, millimetres in `x y z` of the left tool.
constexpr const char* kSmall =
    R"({"time": {"column": "t"}, "left": {"position": {"columns": ["x", "y", "z"], "unit": "mm"}}})";

ColumnMap map_of(const std::string& json) {
  const auto map = column_map_from_json(json);
  if (!map) FAIL(map.error().text());
  return *map;
}

Result<Imported> import_text(const std::string& text, const ColumnMap& map) {
  TROCAR_ASSIGN_OR_RETURN(const NumberTable table, NumberTable::of_text(text, TextLayout::of(map)));
  return from_table(table, map);
}

std::string map_error(const std::string& json) {
  const auto map = column_map_from_json(json);
  REQUIRE_FALSE(map);
  CHECK(map.error().code() == ErrorCode::kInvalidArgument);
  return map.error().text();
}

/// An array file of `rows` by `width`.
template <typename Number>
std::string npy(const std::vector<Number>& values, std::size_t width, const char* type, bool columns_first = false) {
  std::string dictionary = fmt::format("{{'descr': '{}', 'fortran_order': {}, 'shape': ({}, {}), }}\n", type,
                                       columns_first ? "True" : "False", values.size() / width, width);
  std::string bytes("\x93NUMPY\x01\x00", 8);
  bytes += {static_cast<char>(dictionary.size() & 0xFF), static_cast<char>(dictionary.size() >> 8)};
  bytes += dictionary;
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Number));
  return bytes;
}

ColumnMap pose_map(const std::string& rotation, const std::string& frame = "{}") {
  return map_of(
      R"({"time": {"rate_hz": 100}, "header_lines": 0, "delimiter": "space", "right": {"position": {"columns": [1, 2, 3]},
                 "rotation": )" +
      rotation + R"(}, "frame": )" + frame + "}");
}

/// The right tool's pose of the first of two equal rows.
spatial::Pose first_pose(const std::string& row, const ColumnMap& map) {
  const auto read = import_text(row + "\n" + row + "\n", map);
  if (!read) FAIL(read.error().text());
  return read->recording.samples[0].arms[1].setpoint();
}

}  // namespace

TEST_CASE("a map comes back from its JSON") {
  const std::string json = R"({
    "delimiter": ";", "decimal": ",", "comment": "%", "header_lines": 2,
    "time": {"column": "stamp", "unit": "ns"},
    "left": {"position": {"columns": ["x", 3, "z"], "unit": "cm"},
             "rotation": {"columns": ["a", "b", "c"], "kind": "euler", "order": "ZYX", "unit": "deg"},
             "jaw": {"column": 9, "unit": "ratio", "closed": 1, "open": 0, "open_deg": 45}},
    "right": {"joints": {"columns": [11, 12, 13, 14, 15, 16], "unit": "deg", "insertion_unit": "mm"}},
    "frame": {"mirror": "y", "scale": 2, "rotation_wxyz": [0, 1, 0, 0], "translation_m": [0.1, 0, 0]}})";
  const std::string once = to_json(map_of(json));
  CHECK(to_json(map_of(once)) == once);
  const ColumnMap map = map_of(once);
  CHECK(map.arms[0].position->columns[1] == "#3");
  CHECK(map.arms[0].rotation->order == "ZYX");
  CHECK(map.arms[0].jaw->open_deg == 45.0);
  CHECK(map.arms[1].joints->insertion_unit == "mm");
  CHECK(map.frame.scale == 2.0);
  CHECK(map.time.unit == "ns");
}

TEST_CASE("a wrong map is refused in one sentence with the key at fault") {
  CHECK(map_error("{") == "the map is not JSON");
  CHECK(map_error("[]") == "the map must be an object");
  CHECK(map_error("{}") == "the map's \"time\" is missing");
  CHECK(map_error(R"({"time": {"column": "t"}})") == "the map's \"left\" and \"right\" are both missing");
  CHECK(map_error(R"({"time": {}})").find("either a column or a rate_hz") != std::string::npos);
  CHECK(map_error(R"({"time": {"column": "t", "unit": "h"}})") == "the map's \"time.unit\" must be one of s ms us ns");
  CHECK(map_error(R"({"time": {"column": 0}})").find("\"time.column\" must name columns") != std::string::npos);
  CHECK(map_error(R"({"tiem": 1, "time": {"rate_hz": 30}, "left": {"position": {"columns": [1, 2, 3]}}})") ==
        "the map's \"tiem\" is not known here");
  CHECK(map_error(R"({"time": {"rate_hz": 30}, "left": {"position": {"columns": [1, 2]}}})") ==
        "the map's \"left.position.columns\" must be 3 columns, not 2");
  CHECK(map_error(R"({"time": {"rate_hz": 30}, "left": {"jaw": {"column": 1}}})") ==
        "the map's \"left.position\" is missing, and joints are too");
  CHECK(map_error(R"({"time": {"rate_hz": 30}, "decimal": ",", "left": {"position": {"columns": [1, 2, 3]}}})") ==
        "the map's \"decimal\" cannot be the delimiter too");
}

TEST_CASE("times and positions are taken in the map's units, and columns that nothing is made of are listed") {
  const Imported read = import_text("t,x,y,z,force\n5,1,2,3,9\n5.5,4,5,6,9\n", map_of(kSmall)).value();
  REQUIRE(read.recording.samples.size() == 2);
  CHECK(read.recording.samples[0].tick == 0);
  CHECK(read.recording.samples[1].tick == 500);
  CHECK(read.recording.samples[1].arms[0].setpoint_p[2] == 0.006);
  CHECK(mentions(read.found, "columns that nothing is made of: force"));
  CHECK(mentions(read.lossy, "the right arm (it stands at its ready pose)"));
  CHECK(mentions(read.lossy, "the left tool's rotation (it points down)"));
  CHECK(read.recording.provenance.operator_kind == "imported");
  for (const auto& [unit, step] :
       std::vector<std::pair<std::string, std::string>>{{"ms", "500"}, {"us", "500000"}, {"ns", "500000000"}}) {
    ColumnMap map = map_of(kSmall);
    map.time.unit = unit;
    const Imported timed = import_text(fmt::format("t,x,y,z\n0,1,2,3\n{},1,2,3\n", step), map).value();
    CHECK(timed.recording.samples[1].tick == 500);
  }
}

TEST_CASE("positions in metres come through an identity frame to the bit") {
  CHECK(rc::check([] {
    ColumnMap map = map_of(kSmall);
    map.arms[0].position->unit = "m";
    std::string text = "t,x,y,z\n";
    std::vector<std::array<double, 3>> rows(*rc::gen::inRange<std::size_t>(2, 30));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (double& number : rows[i]) number = std::fmod(*rc::gen::arbitrary<double>(), 500.0);
      text += fmt::format("{},{},{},{}\n", 0.25 * static_cast<double>(i), rows[i][0], rows[i][1], rows[i][2]);
    }
    const Imported read = import_text(text, map).value();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      RC_ASSERT(read.recording.samples[i].tick == static_cast<std::int64_t>(250 * i));
      RC_ASSERT(read.recording.samples[i].arms[0].setpoint_p == rows[i]);
    }
  }));
}

TEST_CASE("a decimal comma, semicolons, quotes, comments and several lines of header are read") {
  const ColumnMap map =
      map_of(R"({"delimiter": ";", "decimal": ",", "comment": "%", "header_lines": 2, "time": {"column": "t"},
                                 "left": {"position": {"columns": ["x;mm", "y", "z"], "unit": "mm"}}})");
  const Imported read =
      import_text("\xEF\xBB\xBF% made by\nTrial;1\nt;\"x;mm\";y;z\n0;1,5;+2;3\r\n% pause\n\n0,5; 2,5 ;2;3\n", map)
          .value();
  REQUIRE(read.recording.samples.size() == 2);
  CHECK(read.recording.samples[0].arms[0].setpoint_p[0] == doctest::Approx(0.0015));
  CHECK(read.recording.samples[1].arms[0].setpoint_p[0] == doctest::Approx(0.0025));
  CHECK(read.recording.samples[1].tick == 500);
}

TEST_CASE("rotations mean the same in every way of writing them") {
  const Eigen::Quaterniond q = Eigen::Quaterniond(Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ())) *
                               Eigen::Quaterniond(Eigen::AngleAxisd(-0.5, Eigen::Vector3d::UnitY())) *
                               Eigen::Quaterniond(Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitX()));
  const Eigen::Matrix3d R = q.toRotationMatrix();
  const auto angle = [&](const std::string& numbers, const std::string& rotation) {
    return spatial::angle_between(first_pose("0 0 0 " + numbers, pose_map(rotation)).q, q);
  };
  CHECK(angle(fmt::format("{} {} {} {}", q.x(), q.y(), q.z(), q.w()), R"({"columns": [4, 5, 6, 7]})") < 1e-7);
  CHECK(angle(fmt::format("{} {} {} {}", q.w(), q.x(), q.y(), q.z()),
              R"({"columns": [4, 5, 6, 7], "kind": "quaternion_wxyz"})") < 1e-7);
  std::string rows;
  std::string by_columns;
  for (int i = 0; i < 9; ++i) rows += fmt::format("{} ", R(i / 3, i % 3));
  for (int i = 0; i < 9; ++i) by_columns += fmt::format("{} ", R(i % 3, i / 3));
  CHECK(angle(rows, R"({"columns": [4, 5, 6, 7, 8, 9, 10, 11, 12], "kind": "matrix_rows"})") < 1e-7);
  CHECK(angle(by_columns, R"({"columns": [4, 5, 6, 7, 8, 9, 10, 11, 12], "kind": "matrix_columns"})") < 1e-7);
  CHECK(angle("0.3 -0.5 1.1", R"({"columns": [4, 5, 6], "kind": "euler", "order": "ZYX"})") < 1e-7);
  CHECK(angle("1.1 -0.5 0.3", R"({"columns": [4, 5, 6], "kind": "euler", "order": "xyz"})") < 1e-7);
  CHECK(angle(fmt::format("{} {} {}", 1.1 * 180 / M_PI, -0.5 * 180 / M_PI, 0.3 * 180 / M_PI),
              R"({"columns": [4, 5, 6], "kind": "euler", "order": "xyz", "unit": "deg"})") < 1e-7);
}

TEST_CASE("a left-handed source is mirrored: points and rotations move as in a mirror") {
  CHECK(rc::check([] {
    const char axis = *rc::gen::element('x', 'y', 'z');
    const double angle = *rc::gen::inRange(-30, 30) * 0.1;
    const Eigen::Vector3d about =
        Eigen::Vector3d(*rc::gen::inRange(1, 9), *rc::gen::inRange(-9, 9), *rc::gen::inRange(-9, 9)).normalized();
    const Eigen::Quaterniond q(Eigen::AngleAxisd(angle, about));
    const std::string row = fmt::format("0.1 0.2 0.3 {} {} {} {}", q.x(), q.y(), q.z(), q.w());
    const spatial::Pose read =
        first_pose(row, pose_map(R"({"columns": [4, 5, 6, 7]})", fmt::format(R"({{"mirror": "{}"}})", axis)));
    Eigen::Matrix3d S = Eigen::Matrix3d::Identity();
    S(axis - 'x', axis - 'x') = -1.0;
    RC_ASSERT((read.p - S * Eigen::Vector3d(0.1, 0.2, 0.3)).norm() < 1e-12);
    RC_ASSERT((read.rotation() - S * q.toRotationMatrix() * S).norm() < 1e-9);
  }));
}

TEST_CASE("a frame scales, turns and moves") {
  const spatial::Pose read = first_pose(
      "1 2 3 0 0 0 1",
      pose_map(
          R"({"columns": [4, 5, 6, 7]})",
          R"({"scale": 0.1, "rotation_wxyz": [0.7071067811865476, 0, 0, 0.7071067811865476], "translation_m": [1, 0, 0]})"));
  CHECK((read.p - Eigen::Vector3d(1.0 - 0.2, 0.1, 0.3)).norm() < 1e-12);
  CHECK((read.q * Eigen::Vector3d::UnitX() - Eigen::Vector3d::UnitY()).norm() < 1e-12);
}

TEST_CASE("jaws come in radians, in degrees, or as a share of their opening") {
  const auto jaw = [](const std::string& how) {
    const ColumnMap map =
        map_of(R"({"time": {"rate_hz": 30}, "header_lines": 0, "left": {"position": {"columns": [1, 2, 3]}, "jaw": )" +
               how + "}}");
    return import_text("0,0,0,0.5\n0,0,0,0.5\n", map).value().recording.samples[0].arms[0].setpoint_jaw_rad;
  };
  CHECK(jaw(R"({"column": 4})") == 0.5);
  CHECK(jaw(R"({"column": 4, "unit": "deg"})") == doctest::Approx(0.5 * M_PI / 180));
  CHECK(jaw(R"({"column": 4, "unit": "ratio"})") == doctest::Approx(30 * M_PI / 180));
  CHECK(jaw(R"({"column": 4, "unit": "ratio", "closed": 1, "open": 0.25, "open_deg": 90})") ==
        doctest::Approx(60 * M_PI / 180));
}

TEST_CASE("rows that cannot be samples are left out, and it is said why, how many and where the first is") {
  const std::string text =
      "t,x,y,z\n0,1,2,3\n1,1,2,3\n1,1,2,3\n0.5,1,2,3\n2,,2,3\n2.0,nan,2,3\n3,1,2,3\n3.0001,1,2,3\n4,1,2,3\n5,1,2,3\n6,"
      "1,2,3\n";
  const Imported read = import_text(text, map_of(kSmall)).value();
  CHECK(read.recording.samples.size() == 6);
  CHECK(mentions(read.found, "1 row is left out, the first is line 4: the time is that of the row before"));
  CHECK(mentions(read.found, "1 row is left out, the first is line 5: the time goes backward"));
  CHECK(mentions(read.found, "2 rows are left out, the first is line 6: a number is missing"));
  CHECK(mentions(read.found, "1 row is left out, the first is line 9: less than a millisecond after the row before"));
  const auto bad = import_text("t,x,y,z\n0,1,2,3\n1,1,2,3\n1,1,2,3\n1,1,2,3\n1,1,2,3\n", map_of(kSmall));
  CHECK(bad.error().text() == "only 2 of 5 rows can be samples: 3 from line 4 on (the time is that of the row before)");
}

TEST_CASE("a quaternion keeps its sign, and rows whose rotation is none are left out") {
  const ColumnMap map = pose_map(R"({"columns": [4, 5, 6, 7]})");
  const Imported read = import_text("0 0 0 0 0 0 1\n0 0 0 0 0 0 -1\n0 0 0 0 0 0 0\n0 0 0 0 0 0 1.02\n", map).value();
  REQUIRE(read.recording.samples.size() == 3);
  CHECK(read.recording.samples[1].arms[1].setpoint_q_wxyz[0] == -1.0);
  CHECK(read.recording.samples[2].tick == 30);
  CHECK(mentions(read.found, "far from length 1"));
  CHECK(mentions(read.found, "rotations are off by up to 0.02"));
}

TEST_CASE("a table that does not fit its map is refused with what is wrong") {
  const auto refusal = [](const std::string& text, const std::string& json = kSmall) {
    const auto read = import_text(text, map_of(json));
    REQUIRE_FALSE(read);
    return read.error().text();
  };
  CHECK(refusal("") == "the table has no rows");
  CHECK(refusal("t,x,y\n0,1,2\n") == "no column is named \"z\"");
  CHECK(refusal("t,x,x,y,z\n0,1,2,3,4\n") ==
        "several columns are named \"x\"; give the number of the one that is meant");
  CHECK(refusal("t,x,y,z\n0,1,2,3\n1,one,2,3\n") == "line 3: x must be a number, not \"one\"");
  CHECK(refusal("t,x,y,z\n0,1e9,2,3\n1,1,2,3\n") ==
        "line 2: the left tool is more than a kilometre away, is its unit mm?");
  CHECK(refusal("t,x,y,z\n0,1,2,3\n9e9,1,2,3\n").find("more than a month") != std::string::npos);
  CHECK(refusal("1,2,3\n4,5,6\n",
                R"({"header_lines": 0, "time": {"column": 4}, "left": {"position": {"columns": [1, 2, 3]}}})") ==
        "there is no column 4, the table has 3");
}

TEST_CASE("joints go through the arm's forward kinematics, and limits that are passed are said") {
  CHECK(rc::check([] {
    const kinematics::PsmModel model = kinematics::psm_model(kinematics::ArmSide::kRight);
    kinematics::Joints q{};
    for (std::size_t i = 0; i < q.size(); ++i) {
      const double share = *rc::gen::inRange(0, 1000) * 0.001;
      q[i] = model.limits[i].low + share * (model.limits[i].high - model.limits[i].low);
    }
    std::vector<double> values;
    for (int row = 0; row < 2; ++row) {
      values.insert(values.end(), q.begin(), q.end());
      values.push_back(0.25);
    }
    const ColumnMap map = map_of(
        R"({"time": {"rate_hz": 100}, "right": {"joints": {"columns": [1, 2, 3, 4, 5, 6]}, "jaw": {"column": 7}}})");
    const Imported read = from_table(NumberTable::of_npy(npy(values, 7, "<f8")).value(), map).value();
    const spatial::Pose expected = kinematics::forward(model, q);
    const auto& arm = read.recording.samples[0].arms[1];
    RC_ASSERT(arm.setpoint().p == expected.p);
    RC_ASSERT(spatial::angle_between(arm.setpoint().q, expected.q) < 1e-7);
    RC_ASSERT(arm.joints[3] == static_cast<float>(q[3]));
    RC_ASSERT(arm.setpoint_jaw_rad == 0.25);
    RC_ASSERT(!mentions(read.found, "beyond their limits"));
  }));
  const std::vector<double> far{0, 0, 100, 0, 0, 0, 3.0, 0, 100, 0, 0, 0};
  const ColumnMap map = map_of(
      R"({"time": {"rate_hz": 50}, "left": {"joints": {"columns": [1, 2, 3, 4, 5, 6], "insertion_unit": "mm"}}})");
  const Imported read = from_table(NumberTable::of_npy(npy(far, 6, "<f8")).value(), map).value();
  CHECK(mentions(read.found,
                 "the left arm's joints are beyond their limits in 1 row, first in row 2: the yaw joint would be"));
}

TEST_CASE("arrays of other kinds of numbers and orders are read, and cut ones are not") {
  const std::vector<float> by_columns{1, 2, 3, 4, 5, 6};
  const NumberTable table = NumberTable::of_npy(npy(by_columns, 3, "<f4", true)).value();
  CHECK(table.rows() == 2);
  CHECK(table.read_all(0) == std::vector<double>{1, 3, 5});
  const std::vector<std::int64_t> whole{1, 2, 3, 4};
  CHECK(NumberTable::of_npy(npy(whole, 2, "<i8"))->read_all(1) == std::vector<double>{3, 4});
  CHECK_FALSE(NumberTable::of_npy(npy(whole, 2, "<c8")));
  const std::string bytes = npy(whole, 2, "<i8");
  for (std::size_t size = 0; size < bytes.size(); ++size) CHECK_FALSE(NumberTable::of_npy(bytes.substr(0, size)));
}

TEST_CASE("names of columns are understood") {
  const auto said = [](std::string_view name) {
    const auto column = understood(name);
    return column
               ? fmt::format("{} {} {} {}", static_cast<int>(column->quantity), column->part, column->arm, column->unit)
               : std::string("nothing");
  };
  CHECK(said("Timestamp (ms)") == "0 0 -1 ms");
  CHECK(said("PSM1.pose.position.y") == "1 1 1 ");
  CHECK(said("left_tip_x_mm") == "1 0 0 mm");
  CHECK(said("left_qw") == "2 3 0 ");
  CHECK(said("robot1_orientation.x") == "2 0 1 ");
  CHECK(said("R23") == "3 5 -1 ");
  CHECK(said("rightGripper") == "5 0 1 ");
  CHECK(said("joint_3") == "6 2 -1 ");
  CHECK(said("left_velocity_x") == "nothing");
  CHECK(said("comment") == "nothing");
}

TEST_CASE("an unknown table gets a map that reads it, and says what is not certain") {
  std::string text = "stamp_ms\tL_x\tL_y\tL_z\tL_qx\tL_qy\tL_qz\tL_qw\tL_grip\tR_x\tR_y\tR_z\tnote\n";
  for (int i = 0; i < 50; ++i) {
    text +=
        fmt::format("{}\t{}\t2\t30\t0\t0\t0\t1\t{}\t5\t6\t{}\tword\n", 1000 + 33 * i, i, i == 20 ? 1.0 : 0.0, 30 - i);
  }
  const ColumnGuess guess = guess_columns_of_text(text).value().value();
  CHECK(guess.map.delimiter == "tab");
  CHECK(guess.map.time.unit == "ms");
  CHECK(guess.map.arms[0].position->unit == "mm");
  CHECK(guess.map.arms[0].rotation->columns.size() == 4);
  CHECK(guess.map.arms[0].jaw->unit == "ratio");
  CHECK(guess.map.arms[1].position->columns == std::vector<ColumnName>{"R_x", "R_y", "R_z"});
  CHECK(mentions(guess.doubts, "positions are taken as mm by their size"));
  const Imported read = import_text(text, map_of(to_json(guess.map))).value();
  CHECK(read.recording.samples.size() == 50);
  CHECK(mentions(read.found, "columns that nothing is made of: note"));
  CHECK_FALSE(guess_columns_of_text("a,b\n1,2\n3,4\n").value());
}

TEST_CASE("without names the numbers tell: a rising time, positions with quaternions, joints") {
  std::string text;
  for (int i = 0; i < 20; ++i) {
    text += fmt::format("{},{};0,01{};0,02;0,03;0,6;0;0;0,8;0,5;0,1;0,2;0,3;0;1;0;0;0,7\n", i / 10, i % 10, i);
  }
  const ColumnGuess guess = guess_columns_of_text(text).value().value();
  CHECK(guess.map.decimal == ",");
  CHECK(guess.map.header_lines == 0);
  CHECK(guess.map.time.column == "#1");
  CHECK(guess.map.arms[0].position->columns.front() == "#2");
  CHECK(guess.map.arms[0].jaw->column == "#9");
  CHECK(guess.map.arms[1].rotation->columns.front() == "#13");
  CHECK(import_text(text, guess.map)->recording.samples.size() == 20);
  const std::vector<double> joints(14 * 3, 0.1);
  const ColumnGuess array = guess_columns_of_npy(npy(joints, 14, "<f8")).value().value();
  CHECK(array.map.arms[1].joints->columns.front() == "#8");
  CHECK(array.map.time.rate_hz == 30.0);
}

TEST_CASE("a first column that rises is the time under any name, unless it counts rows") {
  for (const char* name : {"Zeit [s]", "Zeit"}) {
    std::string text = fmt::format("{},left_x_mm,left_y_mm,left_z_mm\n", name);
    for (int i = 0; i < 20; ++i) text += fmt::format("{},1,2,3\n", 0.03 * i + (i > 9 ? 1.0 : 0.0));
    const ColumnGuess guess = guess_columns_of_text(text).value().value();
    CHECK(guess.map.time.column == name);
    CHECK(guess.map.time.unit == "s");
    CHECK(mentions(guess.doubts, "because it comes first and rises"));
  }
  std::string counted = "row,left_x_mm,left_y_mm,left_z_mm\n";
  for (int i = 0; i < 20; ++i) counted += fmt::format("{},1,2,3\n", i);
  CHECK(guess_columns_of_text(counted).value().value().map.time.column.empty());
}

TEST_CASE("decimal commas in every cell are no delimiter, with semicolons or tabs") {
  for (const char cut : {';', '\t'}) {
    std::string text = fmt::format("time_s{0}left_x_mm{0}left_y_mm{0}left_z_mm\n", cut);
    for (int i = 0; i < 20; ++i) text += fmt::format("{1},{2}{0}1,5{0}-2,25{0}3,{2}\n", cut, i / 10, i % 10);
    const ColumnGuess guess = guess_columns_of_text(text).value().value();
    CHECK(guess.map.delimiter == (cut == ';' ? ";" : "tab"));
    CHECK(guess.map.decimal == ",");
    CHECK(guess.map.header_lines == 1);
    CHECK(guess.map.arms[0].position->unit == "mm");
    const demonstration::Recording read = import_text(text, guess.map)->recording;
    REQUIRE(read.samples.size() == 20);
    CHECK(read.samples[3].arms[0].setpoint_p[1] == doctest::Approx(-0.00225));
  }
}

TEST_CASE("axes in two units, cells beyond the columns and one column taken twice are told") {
  std::string text = "time_s,left_x_mm,left_y_m,left_z_mm\n";
  for (int i = 0; i < 20; ++i) text += fmt::format("{},{},2,3{}\n", i, i, i == 4 ? ",5" : "");
  ColumnGuess guess = guess_columns_of_text(text).value().value();
  CHECK(mentions(guess.doubts, "left_y_m is named in m, another axis of that tool in mm; all are taken as mm"));
  CHECK(mentions(import_text(text, guess.map)->found,
                 "1 row has more cells than there are columns, the first is line 6"));
  guess.map.arms[0].position->columns[1] = "left_x_mm";
  CHECK(import_text(text, guess.map).error().text() ==
        "the map takes two numbers of the left tool from one column, left_x_mm");
}

TEST_CASE("a file is imported through its map, and moved as asked") {
  const testing::ScratchFolder folder;
  REQUIRE(write_file(folder / "r.tsv", "t,x,y,z\n0,1,2,3\n1,1,2,3\n"));
  ImportOptions options;
  options.map = map_of(kSmall);
  options.X_WF.p = {1.0, 0.0, 0.0};
  const auto format = guess_format(folder / "r.tsv").value();
  const Imported read = import_demonstration(folder / "r.tsv", format, options).value();
  CHECK(read.recording.samples[0].arms[0].setpoint_p[0] == doctest::Approx(1.001));
  CHECK(read.recording.provenance.device == "r.tsv");
  CHECK(guess_columns(folder / "r.tsv", format).value().has_value());
  CHECK(import_demonstration(folder / "r.tsv", Format::kHdf5, options).error().code() == ErrorCode::kInvalidArgument);
  REQUIRE(write_file(folder / "words.csv", "a,b\n1,2\n"));
  CHECK(guess_columns(folder / "words.csv", Format::kCsv).error().code() == ErrorCode::kUnsupported);
}
