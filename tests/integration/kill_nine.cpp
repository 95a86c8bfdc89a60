/// A program that records and edits is killed at any moment; what it had been told was safe must be there.
#include <doctest/doctest.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>

#include "engine/core/random.h"
#include "tests/support/project_fixture.h"

using namespace trocar;
using namespace trocar::workbench;
using testing::moving_sample;
using testing::opened;
using testing::ScratchFolder;

namespace {

/// What the child says after a call has returned; shorter than PIPE_BUF, so it arrives whole or not at all.
struct Report {
  enum Kind : std::int64_t { kSample, kAdded, kHead } kind = kSample;
  std::int64_t id = 0;      ///< Recording, or journal entry.
  std::uint64_t value = 0;  ///< Samples so far, or the project's hash.
};

void say(int pipe, const Report& report) {
  if (::write(pipe, &report, sizeof report) != static_cast<ssize_t>(sizeof report)) ::_exit(2);
}

void record_one(ProjectFile& file, int pipe, Random& random) {
  RecordingWriter writer = file.begin_recording({}, "world").value();
  const int count = 2 + static_cast<int>(random.below(400));
  for (int i = 0; i < count; ++i) {
    if (!writer.add(moving_sample(i))) ::_exit(3);
    say(pipe, {Report::kSample, writer.id().value, static_cast<std::uint64_t>(i) + 1});
  }
  const auto recording = writer.finish(demonstration::Outcome::kSuccess, true);
  if (!recording || !file.commit(AddDemonstration{*recording, "Recorded"})) ::_exit(4);
  say(pipe, {Report::kAdded, recording->value, static_cast<std::uint64_t>(count)});
  say(pipe, {Report::kHead, file.head(), file.project()->hash()});
}

void edit_some(ProjectFile& file, int pipe, Random& random) {
  const DemonstrationId id = file.project()->demonstrations.rbegin()->first;
  for (int i = 0; i < 20; ++i) {
    const Status done =
        random.below(4) == 0 && file.head() > id.value
            ? file.undo()
            : file.commit(EditDemonstration{id, demonstration::Rename{std::to_string(i)}}).map([](std::int64_t) {});
    if (!done) ::_exit(5);
    say(pipe, {Report::kHead, file.head(), file.project()->hash()});
  }
}

/// Never returns; the parent ends it.
[[noreturn]] void work(const std::filesystem::path& path, int pipe, std::uint64_t seed) {
  Diagnostics diagnostics;
  Result<ProjectFile> file = ProjectFile::open(path, testing::clock_at_rest(), diagnostics);
  if (!file) ::_exit(1);
  Random random(seed);
  for (;;) {
    record_one(*file, pipe, random);
    edit_some(*file, pipe, random);
  }
}

/// When the child is killed: after so many reports, that is between two calls, or after a time, that is anywhere.
struct Moment {
  std::uint32_t reports = 0;        ///< 0: by time.
  std::chrono::microseconds delay;  ///< Since the first report.
};

/// True if there is something to read before `end`.
bool readable_until(int pipe, std::chrono::steady_clock::time_point end) {
  pollfd waiting{pipe, POLLIN, 0};
  const auto left = std::chrono::duration_cast<std::chrono::microseconds>(end - std::chrono::steady_clock::now());
  const timespec limit{0, static_cast<long>(1000 * std::clamp<std::int64_t>(left.count(), 0, 999'999))};
  return ::ppoll(&waiting, 1, &limit, nullptr) > 0;
}

/// Starts the child, kills it at `moment`, and returns all that it said before it died.
std::vector<Report> run_and_kill(const std::filesystem::path& path, std::uint64_t seed, const Moment& moment) {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    ::close(ends[0]);
    work(path, ends[1], seed);
  }
  ::close(ends[1]);
  std::vector<Report> reports;
  Report report;
  auto end = std::chrono::steady_clock::time_point::max();
  while (::read(ends[0], &report, sizeof report) == static_cast<ssize_t>(sizeof report)) {
    reports.push_back(report);
    if (moment.reports == 0 && reports.size() == 1) end = std::chrono::steady_clock::now() + moment.delay;
    const bool over = moment.reports == 0 ? std::chrono::steady_clock::now() >= end || !readable_until(ends[0], end)
                                          : reports.size() == moment.reports;
    if (over) ::kill(child, SIGKILL);
  }
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  REQUIRE(WIFSIGNALED(status));
  return reports;
}

/// Samples of a recording in the project, at any point of its history; 0 if it is not there.
std::size_t samples_of(const ProjectFile& file, std::int64_t recording) {
  for (const auto& [id, document] : file.project()->demonstrations) {
    if (document->recording->id.value == recording) return document->recorded.size();
  }
  return 0;
}

void check_nothing_is_lost(ProjectFile& file, const std::vector<Report>& reports) {
  std::map<std::int64_t, std::uint64_t> hashes;
  Report last_sample;
  for (const Report& report : reports) {
    if (report.kind == Report::kHead) hashes[report.id] = report.value;
    if (report.kind == Report::kSample) last_sample = report;
    if (report.kind == Report::kAdded) last_sample = Report{};
  }
  constexpr std::uint64_t kOneSecond = 200;
  if (last_sample.id != 0 && last_sample.value > kOneSecond) {
    CHECK(samples_of(file, last_sample.id) + kOneSecond >= last_sample.value);
  }
  for (const auto& [node, hash] : hashes) {
    REQUIRE(file.go_to(node));
    REQUIRE(file.project()->hash() == hash);
  }
}

/// Kills 50 times, five times in each project; returns how much was said.
std::size_t kill_fifty_times(const std::function<Moment()>& next_moment) {
  const ScratchFolder folder;
  Random random(20260301);
  std::size_t said = 0;
  for (int round = 0; round < 50; ++round) {
    const std::filesystem::path path = folder / fmt::format("p{}.trocar", round / 5);
    if (round % 5 == 0) testing::created(path);
    const std::vector<Report> reports = run_and_kill(path, random.next(), next_moment());
    said += reports.size();
    Diagnostics diagnostics;
    ProjectFile file = opened(path, diagnostics);
    check_nothing_is_lost(file, reports);
  }
  return said;
}

}  // namespace

TEST_CASE("killed between any of 50 calls, a project keeps every committed edit and all but a second of recording") {
  Random random(7);
  CHECK(kill_fifty_times([&] { return Moment{1 + random.below(900), {}}; }) > 5000);
}

TEST_CASE("killed at any of 50 instants, also in the middle of a write, it keeps the same") {
  Random random(8);
  CHECK(kill_fifty_times([&] { return Moment{0, std::chrono::microseconds(random.below(60'000))}; }) > 500);
}
