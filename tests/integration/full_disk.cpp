/// A disk that is full is an error that the caller sees; what was committed before stays, and work can go on after.
#include <doctest/doctest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/project_fixture.h"

using namespace trocar;
using namespace trocar::workbench;
using testing::moving_sample;
using testing::opened;
using testing::ScratchFolder;

namespace {

/// No file of this process may grow beyond `bytes`, as if the disk ended there.
void limit_files(rlim_t bytes) {
  ::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  ::getrlimit(RLIMIT_FSIZE, &limit);
  limit.rlim_cur = bytes;
  ::setrlimit(RLIMIT_FSIZE, &limit);
}

/// Runs `work` in a process of its own, as the limit is one of a process; returns what it returned.
template <typename Work>
int in_child(Work work) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(work());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

int record_until_full(const std::filesystem::path& path) {
  Diagnostics diagnostics;
  Result<ProjectFile> file = ProjectFile::open(path, testing::clock_at_rest(), diagnostics);
  if (!file) return 1;
  Result<RecordingWriter> writer = file->begin_recording({}, "world");
  if (!writer) return 2;
  limit_files(600'000);
  Status added;
  for (int i = 0; i < 20'000 && added; ++i) added = writer->add(moving_sample(i));
  if (added) return 3;
  return added.error().code() == ErrorCode::kIo ? 0 : 4;
}

int edit_until_full(const std::filesystem::path& path) {
  Diagnostics diagnostics;
  Result<ProjectFile> file = ProjectFile::open(path, testing::clock_at_rest(), diagnostics);
  if (!file) return 1;
  const DemonstrationId id = file->project()->demonstrations.begin()->first;
  const auto rename = [&](int i) {
    return file->commit(EditDemonstration{id, demonstration::Rename{std::to_string(i)}});
  };
  limit_files(400'000);
  int count = 0;
  Result<std::int64_t> committed = rename(count);
  while (committed && count < 20'000) committed = rename(++count);
  if (committed || committed.error().code() != ErrorCode::kIo) return 2;
  // The failed edit has changed nothing, and once there is room the next one succeeds.
  if (file->project()->demonstrations.at(id)->name != std::to_string(count - 1)) return 3;
  limit_files(RLIM_INFINITY);
  return rename(-1) ? 0 : 4;
}

}  // namespace

TEST_CASE("a disk that fills up while recording is an I/O error, and what was written is recovered") {
  const ScratchFolder folder;
  testing::created(folder / "p.trocar");
  CHECK(in_child([&] { return record_until_full(folder / "p.trocar"); }) == 0);
  Diagnostics diagnostics;
  const ProjectFile file = opened(folder / "p.trocar", diagnostics);
  REQUIRE(file.project()->demonstrations.size() == 1);
  CHECK(file.project()->demonstrations.begin()->second->gated().size() >= 50);
}

TEST_CASE("a disk that fills up while editing is an I/O error, and editing goes on when there is room") {
  const ScratchFolder folder;
  {
    ProjectFile file = testing::created(folder / "p.trocar");
    testing::add_demonstration(file, 100, "a");
  }
  CHECK(in_child([&] { return edit_until_full(folder / "p.trocar"); }) == 0);
  const ProjectFile file = opened(folder / "p.trocar");
  CHECK(file.project()->demonstrations.begin()->second->name == "-1");
}

TEST_CASE("a project that does not fit on the disk is not created at all") {
  const ScratchFolder folder;
  const int result = in_child([&] {
    limit_files(20'000);
    const auto file = ProjectFile::create(folder / "p.trocar", testing::clock_at_rest());
    return !file && file.error().code() == ErrorCode::kIo ? 0 : 1;
  });
  CHECK(result == 0);
  CHECK(std::filesystem::is_empty(folder.path()));
}
