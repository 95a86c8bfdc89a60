#include <doctest/doctest.h>
#include <fmt/format.h>
#include <rapidcheck.h>
#include <sys/stat.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "engine/core/file.h"
#include "engine/demonstration/edits.h"
#include "engine/exchange/actions.h"
#include "engine/exchange/exchange.h"
#include "engine/exchange/hdf5_process.h"
#include "engine/exchange/robomimic.h"
#include "tests/support/document_samples.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/sentences.h"

using namespace trocar;
using namespace trocar::exchange;
using demonstration::Demonstration;
using demonstration::Sample;
using testing::moving_demonstration;
using testing::moving_recording;

using trocar::testing::mentions;

namespace {

std::shared_ptr<const Demonstration> shared(Demonstration document) {
  return std::make_shared<const Demonstration>(std::move(document));
}

std::shared_ptr<const Demonstration> document_of(demonstration::Recording recording, const std::string& name) {
  return shared(demonstration::make_demonstration(
                    {1}, name, std::make_shared<const demonstration::Recording>(std::move(recording)))
                    .value());
}

/// Any finite numbers at all, at any increasing times, as long as rotations are some.
demonstration::Recording any_recording() {
  demonstration::Recording recording = moving_recording(*rc::gen::inRange(2, 40));
  std::int64_t tick = *rc::gen::inRange(0, 1'000'000);
  for (Sample& sample : recording.samples) {
    tick += *rc::gen::inRange(1, 300);
    sample.tick = tick;
    for (demonstration::ArmSample& arm : sample.arms) {
      for (double& number : arm.setpoint_p) number = *rc::gen::arbitrary<double>();
      arm.setpoint_jaw_rad = *rc::gen::arbitrary<double>();
      for (float& number : arm.measured.p) number = *rc::gen::arbitrary<float>();
      for (float& number : arm.joints) number = *rc::gen::arbitrary<float>();
    }
    for (demonstration::CompactPose& block : sample.blocks) block.q_wxyz[3] = *rc::gen::arbitrary<float>();
    sample.flags = *rc::gen::inRange<std::uint32_t>(0, 16);
    sample.authority = static_cast<demonstration::Authority>(*rc::gen::inRange(0, 4));
    sample.segment = static_cast<demonstration::Segment>(*rc::gen::inRange(0, 5));
  }
  recording.provenance.seed = *rc::gen::arbitrary<std::uint64_t>();
  recording.outcome = static_cast<demonstration::Outcome>(*rc::gen::inRange(0, 6));
  recording.placed = *rc::gen::arbitrary<bool>();
  return recording;
}

/// The nodes of a file by their paths.
std::map<std::string, TreeNode> nodes_of(const std::filesystem::path& path) {
  std::map<std::string, TreeNode> nodes;
  REQUIRE(read_hdf5(path, [&](TreeNode&& node) {
    nodes[node.path] = std::move(node);
    return Status();
  }));
  return nodes;
}

TreeNode group(const std::string& path) {
  TreeNode node;
  node.path = path;
  return node;
}

/// A file as another program would write it: one arm of a robosuite robot that moves along x.
std::vector<TreeNode> foreign_nodes(std::size_t rows) {
  std::vector<double> positions;
  std::vector<double> rotations;
  std::vector<double> fingers;
  for (std::size_t i = 0; i < rows; ++i) {
    positions.insert(positions.end(), {0.001 * static_cast<double>(i), 0.0, 0.03});
    rotations.insert(rotations.end(), {1.0, 0.0, 0.0, 0.0});
    fingers.insert(fingers.end(), {0.01 * static_cast<double>(i), -0.01 * static_cast<double>(i)});
  }
  TreeNode data = group("data");
  data.attributes["env_args"] = std::string(R"({"env_name": "Lift", "env_kwargs": {"control_freq": 50}})");
  return {data,
          group("data/demo_0"),
          group("data/demo_0/obs"),
          array_node("data/demo_0/actions", TreeNode::Kind::kFloat64, {rows, 1}, std::vector<double>(rows, 0.0)),
          array_node("data/demo_0/obs/robot0_eef_pos", TreeNode::Kind::kFloat64, {rows, 3}, positions),
          array_node("data/demo_0/obs/robot0_eef_quat", TreeNode::Kind::kFloat64, {rows, 4}, rotations),
          array_node("data/demo_0/obs/robot0_gripper_qpos", TreeNode::Kind::kFloat64, {rows, 2}, fingers),
          group("mask"),
          texts_node("mask/train", {"demo_0"})};
}

void write_nodes(const std::filesystem::path& path, const std::vector<TreeNode>& nodes) {
  Hdf5Writer writer = Hdf5Writer::create(path).value();
  for (const TreeNode& node : nodes) REQUIRE(writer.add(node));
  REQUIRE(writer.finish());
}

Result<std::vector<Imported>> read_nodes(std::vector<TreeNode> nodes, RobomimicOptions options = {}) {
  RobomimicReader reader(std::move(options));
  for (TreeNode& node : nodes) REQUIRE(reader.take(std::move(node)));
  return reader.finish();
}

}  // namespace

TEST_CASE("an unedited recording comes back from HDF5 with the same hash of all its content") {
  const testing::ScratchFolder folder;
  CHECK(rc::check([&folder] {
    const auto document = document_of(any_recording(), "Any");
    const ExportReport report = export_demonstrations({document}, folder / "any.hdf5", Format::kHdf5).value();
    // Times at random are no rate, and what happens to be zero was never recorded.
    for (const std::string& lost : report.lossy) {
      RC_ASSERT(lost.starts_with("times, for other programs: ") || lost.ends_with("(never recorded)"));
    }
    const Imported read = import_demonstration(folder / "any.hdf5", Format::kHdf5).value();
    RC_ASSERT(read.recording.content_hash() == testing::recording_of(*document).content_hash());
    RC_ASSERT(demonstration::hash_of(read.recording.samples) == demonstration::hash_of(document->recorded.to_vector()));
    RC_ASSERT(read.recording.initial_world == document->recording->initial_world);
    RC_ASSERT(read.recording.hashes.size() == document->recording->hashes.size());
    RC_ASSERT(read.recording.provenance.seed == document->recording->provenance.seed);
    RC_ASSERT(read.recording.outcome == document->recording->outcome);
    RC_ASSERT(read.recording.placed == document->recording->placed);
    RC_ASSERT(read.name == "Any");
  }));
}

TEST_CASE("several demonstrations go into one file and come back in their order, with their notes and filter keys") {
  const testing::ScratchFolder folder;
  Documents documents;
  for (int i = 0; i < 12; ++i) {
    Demonstration document = *document_of(moving_recording(10 + i), fmt::format("Number {}", i));
    document =
        demonstration::apply(document,
                             demonstration::AddNote{"look", 0.01, 0.02, "seen", 4, demonstration::NoteColour::kGreen,
                                                    demonstration::NoteGlyph::kStar},
                             7)
            .value();
    if (i == 3) document = demonstration::apply(document, demonstration::AddNote{"hard", 0, 0, "mask", 0}, 8).value();
    documents.push_back(shared(document));
  }
  const ExportReport report =
      export_demonstrations(documents, folder / "all.hdf5", Format::kHdf5, {{"train", {0, 11}}}).value();
  CHECK(report.samples == 12 * 10 + 66);
  CHECK(report.reread == "186 samples read again, equal to the bit");
  const auto read = import_demonstrations(folder / "all.hdf5", Format::kHdf5).value();
  REQUIRE(read.size() == 12);
  for (std::size_t i = 0; i < read.size(); ++i) {
    CHECK(read[i].name == fmt::format("Number {}", i));
    CHECK(read[i].recording.samples.size() == 10 + i);
    REQUIRE(!read[i].notes.empty());
    const auto seen = std::find_if(read[i].notes.begin(), read[i].notes.end(),
                                   [](const demonstration::AddNote& note) { return note.tag == "seen"; });
    REQUIRE(seen != read[i].notes.end());
    CHECK(seen->rating == 4);
    CHECK(seen->colour == demonstration::NoteColour::kGreen);
    CHECK(seen->glyph == demonstration::NoteGlyph::kStar);
    CHECK(seen->to_s == 0.02);
  }
  CHECK(read[11].notes.size() == 2);
  CHECK(read[11].notes.back().text == "train");
  CHECK(read[3].notes.size() == 2);
  ImportOptions options;
  options.robomimic.only = {"train"};
  CHECK(import_demonstrations(folder / "all.hdf5", Format::kHdf5, options)->size() == 2);
  options.robomimic.only = {"demo_10", "hard"};
  const auto chosen = import_demonstrations(folder / "all.hdf5", Format::kHdf5, options).value();
  REQUIRE(chosen.size() == 2);
  CHECK(chosen[0].name == "Number 3");
  options.robomimic.only = {"nobody"};
  const auto none = import_demonstrations(folder / "all.hdf5", Format::kHdf5, options);
  CHECK(none.error().code() == ErrorCode::kNotFound);
}

TEST_CASE("a trimmed demonstration keeps its samples but not the world that it cannot be replayed from") {
  const testing::ScratchFolder folder;
  Demonstration trimmed = demonstration::apply(moving_demonstration(400), demonstration::Trim{0.5, 1.0}, 3).value();
  trimmed = demonstration::apply(trimmed, demonstration::AddNote{"in", 0.6, 0.7, "", 0}, 4).value();
  trimmed = demonstration::apply(trimmed, demonstration::AddNote{"out", 0.1, 0.2, "", 0}, 5).value();
  const auto report = export_demonstrations({shared(trimmed)}, folder / "t.h5", Format::kHdf5).value();
  CHECK(mentions(report.lossy, "outside of the gates"));
  CHECK(mentions(report.lossy, "cannot be replayed"));
  CHECK_FALSE(mentions(report.lossless, "simulated world"));
  const Imported read = import_demonstration(folder / "t.h5", Format::kHdf5).value();
  CHECK(read.recording.samples.size() == 101);
  CHECK(read.recording.initial_world.empty());
  CHECK(read.recording.hashes.empty());
  REQUIRE(read.notes.size() == 1);
  CHECK(read.notes[0].from_s == doctest::Approx(0.1));
}

TEST_CASE("the file has robomimic's layout") {
  const testing::ScratchFolder folder;
  REQUIRE(export_demonstrations({document_of(moving_recording(30), "One")}, folder / "r.hdf5", Format::kHdf5));
  const auto nodes = nodes_of(folder / "r.hdf5");
  CHECK(std::get<std::int64_t>(nodes.at("data").attributes.at("total")) == 30);
  CHECK(nodes.at("data").attributes.contains("env_args"));
  CHECK(std::get<std::int64_t>(nodes.at("data/demo_0").attributes.at("num_samples")) == 30);
  const std::vector<double> actions = nodes.at("data/demo_0/actions").numbers();
  REQUIRE(actions.size() == 30 * kActionWidth);
  CHECK(std::all_of(actions.begin(), actions.end(), [](double value) { return std::abs(value) <= 1.0; }));
  CHECK(nodes.at("data/demo_0/dones").numbers().back() == 1.0);
  CHECK(nodes.at("data/demo_0/obs/robot1_eef_quat").shape == std::vector<std::uint64_t>{30, 4});
  CHECK(nodes.at("data/demo_0/obs/robot1_eef_quat").number(3) == 1.0);  // w is the last
  CHECK(nodes.at("mask/operator_scripted").texts == std::vector<std::string>{"demo_0"});
}

TEST_CASE("actions, scaled back, lead from each setpoint to the next") {
  const demonstration::Recording recording = moving_recording(200);
  ActionRange range;
  range.add(recording.samples);
  const ActionScale scale = range.scale();
  const std::vector<double> rows = actions(recording.samples, scale);
  for (std::size_t i = 0; i + 1 < recording.samples.size(); ++i) {
    for (std::size_t arm = 0; arm < 2; ++arm) {
      const auto& next = recording.samples[i + 1].arms[arm];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::size_t at = 7 * arm + axis;
        const double reached = recording.samples[i].arms[arm].setpoint_p[axis] +
                               scale.factor()[at] * rows[i * kActionWidth + at] + scale.offset()[at];
        CHECK(reached == doctest::Approx(next.setpoint_p[axis]).epsilon(1e-12));
      }
      const std::size_t jaw = 7 * arm + 6;
      CHECK(scale.factor()[jaw] * rows[i * kActionWidth + jaw] + scale.offset()[jaw] ==
            doctest::Approx(next.setpoint_jaw_rad).epsilon(1e-12));
    }
  }
}

TEST_CASE("the range of actions is 1, 2 or 5 of a decade and holds whatever moves") {
  CHECK(rc::check([] {
    const demonstration::Recording recording = moving_recording(*rc::gen::inRange(2, 30));
    std::vector<Sample> samples = recording.samples;
    const double times = std::pow(10.0, *rc::gen::inRange(-3, 3));
    for (Sample& sample : samples) {
      for (double& number : sample.arms[0].setpoint_p) number *= times;
      sample.arms[1].setpoint_jaw_rad *= times;
    }
    ActionRange range;
    range.add(samples);
    const double exponent = std::log10(range.scale().position_m);
    const double digit = std::pow(10.0, exponent - std::floor(exponent + 1e-9));
    RC_ASSERT(std::abs(digit - 1.0) < 1e-6 || std::abs(digit - 2.0) < 1e-6 || std::abs(digit - 5.0) < 1e-6);
    for (const double value : actions(samples, range.scale())) RC_ASSERT(std::abs(value) <= 1.0);
  }));
}

TEST_CASE("a node comes back from its bytes, and from no part of them") {
  TreeNode node = array_node("data/demo_0/states", TreeNode::Kind::kFloat32, {2, 3}, {1, 2, 3, 4, 5, 6.5});
  node.attributes = {{"a", 1.5},
                     {"b", std::int64_t{-3}},
                     {"c", std::string("word")},
                     {"d", std::vector<double>{1, 2}},
                     {"e", std::vector<std::string>{"x", ""}}};
  const std::string bytes = encode(node);
  const auto read = decode(bytes);
  REQUIRE(read);
  CHECK(read->attributes == node.attributes);
  CHECK(read->numbers() == node.numbers());
  CHECK(read->shape == node.shape);
  for (std::size_t size = 0; size < bytes.size(); ++size) CHECK_FALSE(decode(bytes.substr(0, size)));
  CHECK_FALSE(decode(bytes + "x"));
}

TEST_CASE("a robomimic file of another program is taken as far as it is known, and says how") {
  const testing::ScratchFolder folder;
  write_nodes(folder / "lift.hdf5", foreign_nodes(51));
  const Imported read = import_demonstration(folder / "lift.hdf5", Format::kHdf5).value();
  const auto& samples = read.recording.samples;
  REQUIRE(samples.size() == 51);
  CHECK(samples[50].tick == 1000);
  CHECK(samples[50].arms[0].setpoint_p[0] == 0.05);
  CHECK(samples[0].arms[0].setpoint_q_wxyz == std::array<double, 4>{0, 1, 0, 0});
  CHECK(samples[0].arms[0].setpoint_jaw_rad == 0.0);
  CHECK(samples[50].arms[0].setpoint_jaw_rad == doctest::Approx(1.0471975512));
  CHECK(samples[0].arms[1].setpoint_p == samples[50].arms[1].setpoint_p);
  CHECK(read.recording.provenance.operator_kind == "imported");
  CHECK(read.recording.provenance.device == "lift.hdf5");
  CHECK(read.name == "demo_0");
  CHECK(mentions(read.found, "50 samples a second"));
  CHECK(mentions(read.found, "0 to 1 of the file's gripper become 0 to 60°"));
  CHECK(mentions(read.lossy, "the right arm"));
  CHECK(mentions(read.lossy, "actions"));
  REQUIRE(read.notes.size() == 1);
  CHECK(read.notes[0].text == "train");
  CHECK(read.notes[0].tag == "mask");
}

TEST_CASE("a foreign file without a rate is said to be taken at 20 Hz, unless one is given") {
  std::vector<TreeNode> nodes = foreign_nodes(5);
  nodes[0].attributes.clear();
  const auto guessed = read_nodes(nodes).value();
  CHECK(guessed[0].recording.samples[1].tick == 50);
  CHECK(mentions(guessed[0].found, "20 samples a second are assumed"));
  CHECK(read_nodes(nodes, {{}, 100.0}).value()[0].recording.samples[1].tick == 10);
  CHECK(read_nodes(nodes, {{}, 5000.0}).error().code() == ErrorCode::kInvalidArgument);
}

TEST_CASE("a row of a foreign file without a number is left out, and keys and counts that do not fit are told") {
  std::vector<TreeNode> nodes = foreign_nodes(5);
  std::vector<double> positions(15, 0.02);
  positions[7] = std::nan("");
  nodes[4] = array_node("data/demo_0/obs/robot0_eef_pos", TreeNode::Kind::kFloat64, {5, 3}, positions);
  for (TreeNode& node : nodes) {
    if (node.path == "data/demo_0") node.attributes["num_samples"] = std::int64_t{4};
    if (node.path == "mask/train") node.texts.push_back("demo_7");
  }
  const auto read = read_nodes(nodes).value();
  REQUIRE(read[0].recording.samples.size() == 4);
  CHECK(read[0].recording.samples[2].tick == 60);
  CHECK(mentions(read[0].found, "1 row is left out, the first is row 3: a number is missing"));
  CHECK(mentions(read[0].found, "the file says 4 samples, but holds 5; all are taken"));
  CHECK(mentions(read[0].found, "the filter key train names demo_7, which the file does not hold"));
}

TEST_CASE("a foreign file with arrays that do not fit is refused with the array's name") {
  const auto refusal = [](std::size_t which, const TreeNode& node) {
    std::vector<TreeNode> nodes = foreign_nodes(5);
    nodes[which] = node;
    const auto read = read_nodes(nodes);
    REQUIRE_FALSE(read);
    return read.error().text();
  };
  const std::string obs = "data/demo_0/obs/";
  const auto kind = TreeNode::Kind::kFloat64;
  const double nan = std::nan("");
  CHECK(refusal(5, array_node(obs + "robot0_eef_quat", kind, {4, 4}, std::vector<double>(16, 0.5))) ==
        "demo_0: obs/robot0_eef_quat has not the shape of 5 by 3 to 4");
  CHECK(refusal(5, array_node(obs + "robot0_eef_quat", kind, {5, 4}, std::vector<double>(20, 3.0))) ==
        "demo_0: row 1 of obs/robot0_eef_quat is no rotation");
  CHECK(refusal(4, array_node(obs + "robot0_eef_pos", kind, {5, 3}, std::vector<double>(15, 1e9))) ==
        "demo_0: row 1 of obs/robot0_eef_pos is no position in metres");
  const std::string none = "demo_0: only 0 of 5 rows can be samples, numbers are missing from row 1 on";
  CHECK(refusal(4, array_node(obs + "robot0_eef_pos", kind, {5, 3}, std::vector<double>(15, nan))) == none);
  CHECK(refusal(6, array_node(obs + "robot0_gripper_qpos", kind, {5, 1}, std::vector<double>(5, nan))) == none);
  CHECK(refusal(4, group(obs + "robot0_eef_pos")).find("it has no tool position") != std::string::npos);
  CHECK(read_nodes({group("data")}).error().text().find("no group data with demonstrations") != std::string::npos);
}

TEST_CASE("samples that were changed after the export claim no origin") {
  const testing::ScratchFolder folder;
  REQUIRE(export_demonstrations({document_of(moving_recording(20), "One")}, folder / "r.hdf5", Format::kHdf5));
  auto nodes = nodes_of(folder / "r.hdf5");
  nodes.at("data/demo_0/states").data[8 * 3] ^= 1;
  std::vector<TreeNode> changed;
  for (auto& [path, node] : nodes) changed.push_back(node);
  const Imported read = std::move(read_nodes(changed).value().front());
  CHECK(read.recording.provenance.operator_kind == "imported");
  CHECK(read.recording.initial_world.empty());
  CHECK(mentions(read.found, "no longer those that Trocar wrote"));
}

TEST_CASE("what is no HDF5 file, or is damaged anywhere, gives one sentence or the samples") {
  const testing::ScratchFolder folder;
  REQUIRE(write_file(folder / "words.hdf5", "no HDF5 at all"));
  const auto words = import_demonstration(folder / "words.hdf5", Format::kHdf5);
  CHECK(words.error().code() == ErrorCode::kCorrupt);
  CHECK(words.error().text() == "the file is not HDF5, or damaged: " + (folder / "words.hdf5").string());
  CHECK(import_demonstration(folder / "none.hdf5", Format::kHdf5).error().code() == ErrorCode::kIo);
  CHECK(import_demonstration(folder.path(), Format::kHdf5).error().code() == ErrorCode::kIo);
  REQUIRE(::mkfifo((folder / "pipe.hdf5").c_str(), 0600) == 0);
  CHECK(import_demonstration(folder / "pipe.hdf5", Format::kHdf5).error().code() == ErrorCode::kIo);

  REQUIRE(export_demonstrations({document_of(moving_recording(6), "One")}, folder / "r.hdf5", Format::kHdf5));
  const std::string whole = read_file(folder / "r.hdf5").value();
  for (int part = 0; part < 16; ++part) {
    std::string bytes = whole;
    const std::size_t at = bytes.size() * static_cast<std::size_t>(part) / 16;
    if (part % 2 == 0) {
      bytes.resize(at);
    } else {
      for (std::size_t i = at; i < std::min(at + 64, bytes.size()); ++i) bytes[i] = '\xA5';
    }
    REQUIRE(write_file(folder / "bad.hdf5", bytes));
    const auto read = import_demonstrations(folder / "bad.hdf5", Format::kHdf5);
    if (!read) CHECK(read.error().text().find('\n') == std::string::npos);
  }
}

TEST_CASE("an export that cannot be written leaves what was there") {
  const testing::ScratchFolder folder;
  const auto document = document_of(moving_recording(20), "One");
  CHECK(export_demonstrations({document}, folder / "no/d.hdf5", Format::kHdf5).error().code() == ErrorCode::kIo);
  CHECK(export_demonstrations({document, document}, folder / "d.csv", Format::kCsv).error().code() ==
        ErrorCode::kInvalidArgument);
  REQUIRE(write_file(folder / "old.hdf5", "old"));
  CHECK_FALSE(export_demonstrations({document}, folder / "old.hdf5", Format::kHdf5, {{"a/b", {0}}}));
  CHECK(read_file(folder / "old.hdf5").value() == "old");
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
}

TEST_CASE("an outcome that edits or gates made unknown is unknown in a file, and is worth nothing") {
  const testing::ScratchFolder folder;
  demonstration::Recording recording = moving_recording(1000);
  recording.outcome = demonstration::Outcome::kSuccess;
  recording.placed = true;
  const auto whole = document_of(std::move(recording), "Whole");
  const auto cut = shared(demonstration::apply(*whole, demonstration::Trim{0.0, 2.0}, 7).value());
  const auto moved =
      shared(demonstration::apply(*whole, demonstration::Offset{demonstration::Arms::kLeft, {0.001, 0, 0}}, 8).value());
  REQUIRE(export_demonstrations({whole, cut, moved}, folder / "three.hdf5", Format::kHdf5));
  const auto nodes = nodes_of(folder / "three.hdf5");
  CHECK(nodes.at("mask/outcome_success").texts == std::vector<std::string>{"demo_0"});
  CHECK(nodes.at("mask/outcome_unknown").texts == std::vector<std::string>{"demo_1", "demo_2"});
  const auto last_reward = [&](const std::string& name) {
    const TreeNode& rewards = nodes.at("data/" + name + "/rewards");
    return rewards.number(static_cast<std::size_t>(rewards.shape[0]) - 1);
  };
  CHECK(last_reward("demo_0") == 1.0);
  CHECK(last_reward("demo_1") == 0.0);
  CHECK(last_reward("demo_2") == 0.0);
  const auto back = import_demonstrations(folder / "three.hdf5", Format::kHdf5).value();
  CHECK(back[0].recording.outcome == demonstration::Outcome::kSuccess);
  for (const std::size_t i : {1U, 2U}) {
    CHECK(back[i].recording.outcome == demonstration::Outcome::kUnknown);
    CHECK_FALSE(back[i].recording.placed);
  }
  const ExportReport report = export_report({cut}, Format::kHdf5).value();
  CHECK(mentions(report.lossy,
                 "its outcome (success as recorded, but the gates leave out how it ended: written as unknown"));
  CHECK_FALSE(mentions(report.lossless, "outcome"));
}

TEST_CASE("a file tells the rate that its demonstrations have") {
  const testing::ScratchFolder folder;
  const auto told = [&](const Documents& documents) {
    REQUIRE(export_demonstrations(documents, folder / "rate.hdf5", Format::kHdf5));
    return std::get<std::string>(nodes_of(folder / "rate.hdf5").at("data").attributes.at("env_args"));
  };
  const auto camera = shared(testing::slow_demonstration(31, 30.0));
  const auto robot = shared(testing::slow_demonstration(40, 20.0));
  CHECK(mentions({told({camera})}, "\"control_freq\":30.0"));
  CHECK(mentions({told({robot})}, "\"control_freq\":20.0"));
  CHECK(mentions({told({shared(moving_demonstration(100))})}, "\"control_freq\":200.0"));
  CHECK_FALSE(mentions(export_report({camera}, Format::kHdf5).value().lossy, "times"));
  CHECK(mentions(export_report({camera, robot}, Format::kHdf5).value().lossy,
                 "the file says 30 samples a second, 1 of the demonstrations has another rate"));
  const auto holed = shared(demonstration::apply(*camera, demonstration::DeleteSpan{0.4, 0.6, false}, 7).value());
  CHECK(mentions(export_report({holed}, Format::kHdf5).value().lossy, "1 of their steps are others"));
}

TEST_CASE("joints and blocks that were never recorded are in no file, and nothing stands in for them") {
  const testing::ScratchFolder folder;
  const auto document = shared(moving_demonstration(100));
  const ExportReport report = export_demonstrations({document}, folder / "bare.hdf5", Format::kHdf5).value();
  for (const char* missing : {"the joints of the left arm", "the joints of the right arm", "the blocks"}) {
    CHECK(mentions(report.lossy, std::string(missing) + " (never recorded)"));
    CHECK(mentions(export_report({document}, Format::kCsv).value().lossy, std::string(missing) + " (never recorded"));
  }
  CHECK_FALSE(mentions(report.lossless, "joints"));
  CHECK_FALSE(mentions(report.lossless, "blocks"));
  const auto nodes = nodes_of(folder / "bare.hdf5");
  CHECK_FALSE(nodes.contains("data/demo_0/obs/robot0_joint_pos"));
  CHECK_FALSE(nodes.contains("data/demo_0/obs/robot1_joint_pos"));
  CHECK_FALSE(nodes.contains("data/demo_0/obs/object"));
  for (const std::string& name :
       std::get<std::vector<std::string>>(nodes.at("data/demo_0/states").attributes.at("columns"))) {
    CHECK_FALSE(name.starts_with("block_"));
    CHECK(name.find("_joint_") == std::string::npos);
  }
  const Imported back = import_demonstration(folder / "bare.hdf5", Format::kHdf5).value();
  CHECK(demonstration::hash_of(back.recording.samples) == demonstration::hash_of(document->recorded.to_vector()));
  CHECK(mentions(back.lossy, "the joints of the left arm"));
  CHECK(mentions(back.lossy, "the blocks"));
  // Mirrored, each zero is a negative one: still to the bit.
  const auto mirror = shared(demonstration::apply(*document, demonstration::Mirror{}, 7).value());
  CHECK(mentions(export_demonstrations({mirror}, folder / "mirror.hdf5", Format::kHdf5).value().lossy, "the blocks"));
}
