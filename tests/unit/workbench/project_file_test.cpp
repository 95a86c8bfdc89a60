#include "engine/workbench/project_file.h"

#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>

namespace fs = std::filesystem;
using namespace trocar;
using namespace trocar::workbench;
using demonstration::Sample;

namespace {

/// A folder of this test only, removed with it.
struct Scratch {
  Scratch() {
    static int count = 0;
    folder = fs::temp_directory_path() /
             ("trocar_project_test_" + std::to_string(::getpid()) + "_" + std::to_string(++count));
    fs::create_directories(folder);
  }
  ~Scratch() { fs::remove_all(folder); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  fs::path folder;
};

Sample sample_at(int index) {
  Sample sample;
  sample.tick = std::int64_t{index} * demonstration::kTicksPerSample;
  sample.arms[0].setpoint_p = {0.001 * index, 0.0, 0.03};
  sample.segment = static_cast<demonstration::Segment>(std::min(index / 40, 4));
  return sample;
}

demonstration::Recording recording_of(int samples) {
  demonstration::Recording recording;
  recording.provenance.operator_kind = "scripted";
  recording.initial_world = std::string("world\0bytes", 11);
  for (int i = 0; i < samples; ++i) recording.samples.push_back(sample_at(i));
  recording.hashes = {{0, 1}, {995, 0xFFFFFFFFFFFFFFFFULL}};
  return recording;
}

std::shared_ptr<const Clock> clock_at_rest() {
  return std::make_shared<ManualClock>();
}

ProjectFile reopened(const fs::path& path) {
  Diagnostics diagnostics;
  auto file = ProjectFile::open(path, clock_at_rest(), diagnostics);
  if (!file) FAIL(file.error().text());
  return std::move(*file);
}

DemonstrationId add_demonstration(ProjectFile& file, int samples, const std::string& name) {
  const auto id = file.store_recording(recording_of(samples));
  REQUIRE(id);
  const auto node = file.commit(AddDemonstration{*id, name});
  REQUIRE(node);
  return {*node};
}

}  // namespace

TEST_CASE("a demonstration comes back as it was recorded when the project is opened again") {
  const Scratch scratch;
  const fs::path path = scratch.folder / "p.trocar";
  std::uint64_t hash = 0;
  {
    ProjectFile file = ProjectFile::create(path, clock_at_rest()).value();
    add_demonstration(file, 200, "First");
    hash = file.project()->hash();
  }
  const ProjectFile file = reopened(path);
  REQUIRE(file.project()->demonstrations.size() == 1);
  const demonstration::Demonstration& document = *file.project()->demonstrations.begin()->second;
  CHECK(document.name == "First");
  CHECK(document.segments.size() == 5);
  CHECK(document.recording->content_hash() == recording_of(200).content_hash());
  CHECK(document.recording->initial_world == recording_of(1).initial_world);
  CHECK(file.project()->hash() == hash);
}

TEST_CASE("closing a project leaves exactly one file") {
  const Scratch scratch;
  {
    ProjectFile file = ProjectFile::create(scratch.folder / "p.trocar", clock_at_rest()).value();
    add_demonstration(file, 200, "First");
  }
  CHECK(std::distance(fs::directory_iterator(scratch.folder), fs::directory_iterator{}) == 1);
}
