#include "engine/store/project_store.h"

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "engine/core/file.h"
#include "engine/store/database.h"
#include "tests/support/scratch_folder.h"

namespace fs = std::filesystem;
using namespace trocar;
using store::ProjectStore;
using testing::ScratchFolder;

namespace {

std::size_t files_in(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}));
}

/// A project with a journal, a finished recording of `chunks` pieces and an object.
void fill(ProjectStore& project, int chunks) {
  REQUIRE(project.append({0, 0, "2026-01-01T00:00:00Z", "trim", R"({"from_s":1})", "Trim"}));
  const std::int64_t id = project.begin_recording("{}").value();
  for (int i = 0; i < chunks; ++i) {
    REQUIRE(project.append_chunk(id, {i, std::string(20000, static_cast<char>('a' + i % 26))}));
  }
  REQUIRE(project.finish_recording(id, R"({"samples":0})"));
  REQUIRE(project.put_object("model", "{}", std::string("\0\1\2", 3)));
}

}  // namespace

TEST_CASE("what is stored is what is read after opening again") {
  const ScratchFolder folder;
  {
    ProjectStore project = ProjectStore::create(folder / "p.trocar").value();
    fill(project, 3);
    REQUIRE(project.set_setting("layout", "wide"));
  }
  const ProjectStore project = ProjectStore::open(folder / "p.trocar").value();
  const auto journal = project.journal().value();
  REQUIRE(journal.size() == 1);
  CHECK(journal[0].id == 1);
  CHECK(journal[0].parameters == R"({"from_s":1})");
  CHECK(project.head().value() == 1);
  const auto chunks = project.chunks(1).value();
  REQUIRE(chunks.size() == 3);
  CHECK(chunks[2].bytes == std::string(20000, 'c'));
  CHECK(project.recordings().value()[0].finished);
  CHECK(project.object_bytes(1).value() == std::string("\0\1\2", 3));
  CHECK(project.setting("layout").value() == "wide");
  CHECK_FALSE(project.setting("colour").value().has_value());
}

TEST_CASE("closing leaves the one file") {
  const ScratchFolder folder;
  {
    ProjectStore project = ProjectStore::create(folder / "p.trocar").value();
    fill(project, 10);
    CHECK(files_in(folder.path()) > 1);
  }
  CHECK(files_in(folder.path()) == 1);
}

TEST_CASE("an existing file is not overwritten, and a missing folder is said to be missing") {
  const ScratchFolder folder;
  REQUIRE(write_file(folder / "p.trocar", "precious"));
  CHECK(ProjectStore::create(folder / "p.trocar").error().text().starts_with("the file exists already: "));
  CHECK(read_file(folder / "p.trocar").value() == "precious");
  CHECK(ProjectStore::create(folder / "no" / "p.trocar").error().text().starts_with("the folder does not exist: "));
}

TEST_CASE("the log of a project that is gone is not mixed into a new one") {
  const ScratchFolder folder;
  REQUIRE(write_file(folder / "p.trocar-wal", "left over"));
  CHECK(ProjectStore::create(folder / "p.trocar").error().code() == ErrorCode::kIo);
  CHECK_FALSE(fs::exists(folder / "p.trocar"));
}

TEST_CASE("a folder that cannot be written gives one sentence and no file") {
  if (::geteuid() == 0) return;  // The superuser may write anywhere.
  const ScratchFolder folder;
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
  CHECK(ProjectStore::create(folder / "p.trocar").error().code() == ErrorCode::kIo);
  fs::permissions(folder.path(), fs::perms::owner_all);
  CHECK(files_in(folder.path()) == 0);
}

TEST_CASE("what is not a project is refused with its reason and left as it is") {
  const ScratchFolder folder;
  const auto refusal = [&](const std::string& bytes) {
    const fs::path path = folder / "x.trocar";
    REQUIRE(write_file(path, bytes));
    const auto opened = ProjectStore::open(path);
    REQUIRE_FALSE(opened);
    CHECK(opened.error().code() == ErrorCode::kCorrupt);
    CHECK(read_file(path).value() == bytes);
    CHECK(files_in(folder.path()) == 1);
    const std::string text = opened.error().text();
    return text.substr(0, text.find(": /"));
  };
  CHECK(refusal("") == "the file is too short to be a Trocar project");
  CHECK(refusal("hello") == "the file is too short to be a Trocar project");
  CHECK(refusal(std::string(5000, 'x')) == "the file is not a Trocar project");
  CHECK(refusal(std::string("SQLite format 3\0", 16) + std::string(5000, '\0')) ==
        "the file is a database of another program, not a Trocar project");
  CHECK(ProjectStore::open(folder / "missing.trocar").error().code() == ErrorCode::kIo);
  CHECK(ProjectStore::open(folder.path()).error().code() == ErrorCode::kCorrupt);
}

TEST_CASE("a project of a newer version is refused and not changed") {
  const ScratchFolder folder;
  const fs::path path = folder / "p.trocar";
  { REQUIRE(ProjectStore::create(path)); }
  {
    store::Database database = store::Database::open(path, store::Database::Access::kWrite).value();
    REQUIRE(database.execute("PRAGMA user_version = 2"));
  }
  const std::string before = read_file(path).value();
  const auto opened = ProjectStore::open(path);
  REQUIRE_FALSE(opened);
  CHECK(opened.error().code() == ErrorCode::kUnsupported);
  CHECK(opened.error().text().starts_with(
      "the project was written by a newer Trocar (schema 2, this one reads up to 1)"));
  CHECK(read_file(path).value() == before);
}

TEST_CASE("tables that are missing make a clear error") {
  const ScratchFolder folder;
  const fs::path path = folder / "p.trocar";
  { REQUIRE(ProjectStore::create(path)); }
  {
    store::Database database = store::Database::open(path, store::Database::Access::kWrite).value();
    REQUIRE(database.execute("DROP TABLE head"));
  }
  CHECK(ProjectStore::open(path).error().code() == ErrorCode::kCorrupt);
}

TEST_CASE("a copy cut off at any size is refused or read, never changed") {
  const ScratchFolder folder;
  {
    ProjectStore project = ProjectStore::create(folder / "p.trocar").value();
    fill(project, 8);
  }
  const std::string whole = read_file(folder / "p.trocar").value();
  const fs::path path = folder / "cut.trocar";
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 97) {
    const std::string cut = whole.substr(0, size);
    REQUIRE(write_file(path, cut));
    CHECK(ProjectStore::open(path).error().code() == ErrorCode::kCorrupt);
    CHECK(read_file(path).value() == cut);
  }
}

TEST_CASE("bytes that are overwritten in the middle are an error where they are read, not a crash") {
  const ScratchFolder folder;
  {
    ProjectStore project = ProjectStore::create(folder / "p.trocar").value();
    fill(project, 8);
  }
  const std::string whole = read_file(folder / "p.trocar").value();
  for (std::size_t at = 4096; at + 512 < whole.size(); at += 4096) {
    std::string bad = whole;
    bad.replace(at, 512, 512, '\xA5');
    REQUIRE(write_file(folder / "bad.trocar", bad));
    auto opened = ProjectStore::open(folder / "bad.trocar");
    if (!opened) continue;
    (void)opened->journal();
    (void)opened->chunks(1);
    (void)opened->object_bytes(1);
  }
}

TEST_CASE("two programs may write in turn, and each notices the other") {
  const ScratchFolder folder;
  ProjectStore one = ProjectStore::create(folder / "p.trocar").value();
  ProjectStore two = ProjectStore::open(folder / "p.trocar").value();
  CHECK_FALSE(two.changed_elsewhere().value());
  REQUIRE(one.append({0, 0, "t", "a", "{}", ""}));
  CHECK(two.changed_elsewhere().value());
  CHECK_FALSE(two.changed_elsewhere().value());
  CHECK(two.append({0, 0, "t", "b", "{}", ""}).value() == 2);
  CHECK(one.journal_after(1).value().size() == 1);
}

TEST_CASE("while another program is writing, a write says so and changes nothing") {
  const ScratchFolder folder;
  ProjectStore one = ProjectStore::create(folder / "p.trocar").value();
  ProjectStore two = ProjectStore::open(folder / "p.trocar").value();
  REQUIRE(one.transaction([&]() -> Status {
    const auto refused = two.append({0, 0, "t", "a", "{}", ""});
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code() == ErrorCode::kIo);
    CHECK(refused.error().text().starts_with("the project is open in another program that is writing to it: "));
    CHECK(two.journal().value().empty());
    return {};
  }));
}

TEST_CASE("a transaction that fails leaves nothing") {
  const ScratchFolder folder;
  ProjectStore project = ProjectStore::create(folder / "p.trocar").value();
  const Status status = project.transaction([&]() -> Status {
    REQUIRE(project.append({0, 0, "t", "a", "{}", ""}));
    REQUIRE(project.set_setting("k", "v"));
    return fail(ErrorCode::kCancelled, "stop");
  });
  CHECK(status.error().code() == ErrorCode::kCancelled);
  CHECK(project.journal().value().empty());
  CHECK(project.head().value() == 0);
  CHECK_FALSE(project.setting("k").value().has_value());
}

TEST_CASE("a recording counts as being written until its store is closed or gives it up") {
  const ScratchFolder folder;
  {
    ProjectStore project = ProjectStore::create(folder / "p.trocar").value();
    const std::int64_t id = project.begin_recording("{}").value();
    REQUIRE(project.begin_recording("{}"));
    CHECK(project.recordings().value()[0].writer_lives);
    REQUIRE(project.abandon_recording(id));
    CHECK_FALSE(project.recordings().value()[0].writer_lives);
    CHECK(project.recordings().value()[1].writer_lives);
  }
  const ProjectStore project = ProjectStore::open(folder / "p.trocar").value();
  CHECK_FALSE(project.recordings().value()[1].writer_lives);
}

TEST_CASE("a chunk is written once and a recording is finished once") {
  const ScratchFolder folder;
  ProjectStore project = ProjectStore::create(folder / "p.trocar").value();
  const std::int64_t id = project.begin_recording("{}").value();
  REQUIRE(project.append_chunk(id, {0, "first"}));
  CHECK_FALSE(project.append_chunk(id, {0, "second"}));
  CHECK(project.chunks(id).value()[0].bytes == "first");
  REQUIRE(project.finish_recording(id, "{}"));
  CHECK(project.finish_recording(id, "{}").error().code() == ErrorCode::kNotFound);
}

TEST_CASE("a discarded recording is gone") {
  const ScratchFolder folder;
  ProjectStore project = ProjectStore::create(folder / "p.trocar").value();
  const std::int64_t id = project.begin_recording("{}").value();
  REQUIRE(project.append_chunk(id, {0, "first"}));
  REQUIRE(project.discard_recording(id));
  CHECK(project.recordings().value().empty());
  CHECK(project.chunks(id).value().empty());
}
