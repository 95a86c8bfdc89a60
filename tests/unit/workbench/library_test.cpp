#include <doctest/doctest.h>
#include <fmt/format.h>
#include <rapidcheck.h>

#include <algorithm>

#include "engine/workbench/batch.h"
#include "engine/workbench/library_query.h"
#include "engine/workbench/saved_filters.h"
#include "tests/support/project_fixture.h"
#include "tests/support/random_edits.h"

namespace trocar::workbench {
namespace {

using testing::add_demonstration;
using testing::created;
using testing::opened;
using testing::ScratchFolder;

/// Three demonstrations, the first two of the same samples.
struct ThreeOf {
  ScratchFolder folder;
  ProjectFile file = created(folder / "p.trocar");
  DemonstrationId a = add_demonstration(file, 400, "Expert 1");
  DemonstrationId b = add_demonstration(file, 400, "Expert 2");
  DemonstrationId c = add_demonstration(file, 800, "Novice");

  void mark(DemonstrationId id, MarkChange change) { REQUIRE(file.commit(MarkDemonstration{id, std::move(change)})); }
  std::shared_ptr<const LibraryView> library(bool measured = true) {
    Progress progress;
    return whole_library({file.project(), file.replays()}, measured, progress).value();
  }
  std::string found(std::string_view query, bool measured = true) {
    const auto view = library(measured);
    std::size_t undecided = 0;
    std::string names;
    for (const LibraryRow* row : matching(*view, LibraryQuery::parse(query).value(), undecided)) {
      names += fmt::format("{}{}", names.empty() ? "" : " ", row->id.value);
    }
    return undecided == 0 ? names : fmt::format("{} and {} undecided", names, undecided);
  }
  std::shared_ptr<const BatchPlan> plan(std::vector<std::string> words) {
    Progress progress;
    return plan_batch({file.project(), {a, b, c}, std::move(words)}, progress);
  }
};

std::string complaint(std::string_view query) {
  const auto parsed = LibraryQuery::parse(query);
  return parsed ? "" : parsed.error().text();
}

}  // namespace

TEST_CASE("an edit of several without a span is of all that lies between each one's gates") {
  ThreeOf three;
  const auto plan = three.plan({"smooth", "--max-deviation-mm", "0.3"});
  REQUIRE(plan->error.empty());
  for (const Edit& edit : plan->edit.edits) {
    const auto& one = std::get<EditDemonstration>(edit);
    const auto& document = *three.file.project()->demonstrations.at(one.demonstration);
    const auto& smooth = std::get<demonstration::Smooth>(one.edit);
    CHECK(smooth.from_s == document.begin_s);
    CHECK(smooth.to_s == document.end_s);
  }
  for (const BatchLine& line : plan->lines) CHECK(line.problem.find("the end") == std::string::npos);
}

TEST_CASE("what is said of a demonstration survives a restart, and undo takes it back") {
  ThreeOf three;
  const std::uint64_t before = three.file.project()->hash();
  MarkChange change;
  change.flag = Flag::kBad;
  change.rating = 2;
  change.add = {"slow", "left-handed"};
  change.note = "Hesitates over the peg";
  three.mark(three.a, change);
  const Marks marks = three.file.project()->marks_of(three.a);
  CHECK(marks.flag == Flag::kBad);
  CHECK(marks.tags == std::set<std::string>{"left-handed", "slow"});
  CHECK(three.file.project()->hash() != before);
  const ProjectFile again = opened(three.folder / "p.trocar");
  CHECK(again.project()->marks_of(three.a) == marks);
  CHECK(again.project()->marks_of(three.b) == Marks{});
  REQUIRE(three.file.undo());
  CHECK(three.file.project()->hash() == before);
}

TEST_CASE("a tag that could not be asked for and a rating beyond 5 are refused, and nothing changes") {
  ThreeOf three;
  const std::uint64_t before = three.file.project()->hash();
  for (const char* tag : {"", "two words", "a:b", "\"", "(", "\xff"}) {
    MarkChange change;
    change.add = {tag};
    CHECK(three.file.commit(MarkDemonstration{three.a, change}).error().code() == ErrorCode::kInvalidArgument);
  }
  MarkChange change;
  change.rating = 6;
  CHECK_FALSE(three.file.commit(MarkDemonstration{three.a, change}));
  CHECK(three.file.project()->hash() == before);
}

TEST_CASE("what is removed lies in the trash with its marks, also after a restart, and comes back as it was") {
  ThreeOf three;
  MarkChange change;
  change.add = {"keep"};
  three.mark(three.b, change);
  const std::uint64_t before = three.file.project()->hash();
  REQUIRE(three.file.commit(RemoveDemonstration{three.b}));
  CHECK_FALSE(three.file.project()->demonstrations.contains(three.b));
  CHECK(three.file.project()->trash.contains(three.b));
  CHECK(opened(three.folder / "p.trocar").project()->trash.contains(three.b));
  CHECK_FALSE(three.file.commit(RestoreDemonstration{three.a}));
  REQUIRE(three.file.commit(RestoreDemonstration{three.b}));
  CHECK(three.file.project()->hash() == before);
  CHECK(three.file.project()->trash.empty());
}

TEST_CASE("a batch is one step of the history: undone, all is as it was, and done again it is the same") {
  ThreeOf three;
  const std::uint64_t before = three.file.project()->hash();
  const std::size_t steps = three.file.history().size();
  const auto plan = three.plan({"flag", "bad"});
  CHECK(plan->edit.edits.size() == 3);
  REQUIRE(three.file.commit(plan->edit));
  CHECK(three.file.history().size() == steps + 1);
  CHECK(three.file.history().back().description == "Flag bad: 3 demonstrations");
  CHECK(three.found("flag:bad") == "1 2 3");
  const std::uint64_t after = three.file.project()->hash();
  CHECK(opened(three.folder / "p.trocar").project()->hash() == after);
  REQUIRE(three.file.undo());
  CHECK(three.file.project()->hash() == before);
  REQUIRE(three.file.redo());
  CHECK(three.file.project()->hash() == after);
}

TEST_CASE("property: any batch of edits, undone, gives the same hash, and redone the same again") {
  CHECK(rc::check([](std::uint64_t seed) {
    ThreeOf three;
    Random random(seed);
    Batch batch;
    for (int i = 0; i < 6; ++i) {
      const DemonstrationId id = std::vector{three.a, three.b, three.c}[random.below(3)];
      const std::uint32_t kind = random.below(4);
      MarkChange change;
      change.flag = static_cast<Flag>(random.below(4));
      change.add = {fmt::format("t{}", random.below(3))};
      Edit edit = EditDemonstration{id, testing::random_edit(random, 1.9)};
      if (kind == 0) edit = MarkDemonstration{id, change};
      if (kind == 1) edit = SaveFilter{fmt::format("f{}", random.below(2)), "flag:bad"};
      if (kind == 2 && random.below(3) == 0) edit = RemoveDemonstration{id};
      batch.edits.push_back(std::move(edit));
    }
    const std::uint64_t before = three.file.project()->hash();
    const Result<std::int64_t> made = three.file.commit(batch);
    if (!made) {
      RC_ASSERT(three.file.project()->hash() == before);
      RC_DISCARD("one of the edits could not be made");
    }
    const std::uint64_t after = three.file.project()->hash();
    const Result<Edit> read = edit_from_json(Batch::kName, to_json(Edit(batch)));
    RC_ASSERT(read.has_value());
    RC_ASSERT(to_json(*read) == to_json(Edit(batch)));
    RC_ASSERT(three.file.undo().has_value());
    RC_ASSERT(three.file.project()->hash() == before);
    RC_ASSERT(three.file.redo().has_value());
    RC_ASSERT(three.file.project()->hash() == after);
  }));
}

TEST_CASE("a batch of which one edit cannot be made changes nothing, and one that adds is refused") {
  ThreeOf three;
  const std::uint64_t before = three.file.project()->hash();
  CHECK_FALSE(three.file.commit(Batch{"", {RemoveDemonstration{three.a}, RemoveDemonstration{three.a}}}));
  CHECK(three.file.commit(Batch{"", {CopyDemonstration{three.a, "", {}}}}).error().code() ==
        ErrorCode::kInvalidArgument);
  CHECK(edit_from_json(Batch::kName, R"({"title":"","edits":[{"name":"batch","parameters":{}}]})").error().code() ==
        ErrorCode::kCorrupt);
  CHECK(three.file.project()->hash() == before);
}

TEST_CASE("several copies are one step with an id each, and come back the same") {
  ThreeOf three;
  const std::uint64_t before = three.file.project()->hash();
  const Result<std::int64_t> last = three.file.commit(
      CopyDemonstrations{{{three.a, "", {}}, {three.a, "", {demonstration::Mirror{}}}, {three.b, "Other", {}}}});
  REQUIRE(last);
  const std::uint64_t after = three.file.project()->hash();
  CHECK(three.file.project()->demonstrations.size() == 6);
  CHECK(three.file.project()->demonstrations.at(DemonstrationId{*last})->name == "Other");
  const auto& first = three.file.project()->demonstrations.at(DemonstrationId{*last - 2});
  const auto& second = three.file.project()->demonstrations.at(DemonstrationId{*last - 1});
  CHECK(first->name != second->name);
  CHECK(first->hash() == three.file.project()->demonstrations.at(three.a)->hash());
  CHECK(second->hash() != first->hash());
  // The next step takes the next id.
  CHECK(three.file.commit(RemoveDemonstration{{*last}}).value() == *last + 1);
  REQUIRE(three.file.undo());
  CHECK(opened(three.folder / "p.trocar").project()->hash() == after);
  REQUIRE(three.file.undo());
  CHECK(three.file.project()->hash() == before);
  CHECK_FALSE(three.file.commit(CopyDemonstrations{}));
  CHECK(three.file.project()->hash() == before);
}

TEST_CASE("two edits of one demonstration in a batch are two entries of its stack") {
  ThreeOf three;
  const demonstration::Edit offset = demonstration::Offset{demonstration::Arms::kBoth, {0.0, 0.0, 0.001}};
  REQUIRE(three.file.commit(Batch{"", {EditDemonstration{three.a, offset}, EditDemonstration{three.a, offset}}}));
  const auto stack = three.file.project()->demonstrations.at(three.a)->stack;
  REQUIRE(stack->size() == 2);
  CHECK((*stack)[0].id != (*stack)[1].id);
}

TEST_CASE("a plan says of each what would change, and leaves out what would not") {
  ThreeOf three;
  MarkChange change;
  change.add = {"slow"};
  three.mark(three.b, change);
  const auto tags = three.plan({"tag", "slow"});
  REQUIRE(tags->lines.size() == 3);
  CHECK(tags->lines[0].problem == "");
  CHECK(tags->lines[1].problem == "it is so already");
  CHECK(tags->edit.edits.size() == 2);
  const auto trims = three.plan({"trim", "--from", "0.5", "--to", "3"});
  CHECK(trims->lines[2].change == "4.00 s → 2.50 s");
  CHECK(three.plan({"melt"})->error.find("melt") != std::string::npos);
  CHECK(three.plan({"rename", "All"})->error != "");
  CHECK(three.plan({"rate", "9"})->error != "");
}

TEST_CASE("a batch that only moves gates holds the gates, so that it is quick to make and to undo") {
  ThreeOf three;
  const auto plan = three.plan({"trim-idle", "--longer", "0.05", "--speed-mm-s", "9"});
  CHECK(plan->error == "");
  CHECK_FALSE(plan->edit.edits.empty());
  for (const Edit& edit : plan->edit.edits) {
    CHECK(std::holds_alternative<demonstration::Trim>(std::get<EditDemonstration>(edit).edit));
  }
}

TEST_CASE("the library knows duplicates, what is said and what was trained") {
  ThreeOf three;
  const auto view = three.library();
  REQUIRE(view->rows.size() == 3);
  CHECK(view->unmeasured == 0);
  CHECK(view->rows[0].duplicate == three.b);
  CHECK(view->rows[1].duplicate == three.a);
  CHECK(view->rows[2].duplicate == DemonstrationId{});
  CHECK(view->rows[0].segments == "ABCDE");
  CHECK(view->rows[2].measures->moves[0]);
  CHECK(view->rows[2].measures->path_length_m[0] > view->rows[0].measures->path_length_m[0]);
}

TEST_CASE("measures come piece by piece, and what has not changed is not measured again") {
  ThreeOf three;
  LibraryMaker maker;
  const LibraryRequest request{three.file.project(), {}};
  CHECK(maker.make(request, 0)->unmeasured == 3);
  // The second has the first one's content, and with it its measures.
  const auto first = maker.make(request, 1);
  CHECK(first->unmeasured == 1);
  const auto measures = first->rows[0].measures;
  CHECK(first->rows[1].measures == measures);
  MarkChange change;
  change.flag = Flag::kGood;
  three.mark(three.a, change);
  const auto later = maker.make({three.file.project(), {}}, 1);
  CHECK(later->unmeasured == 0);
  CHECK(later->rows[0].measures == measures);
}

TEST_CASE("of very many versions only the measures of those at hand are remembered") {
  const demonstration::Demonstration one = testing::moving_demonstration(40);
  LibraryMaker maker;
  std::size_t most = 0;
  for (std::size_t i = 0; i < kMostMeasures + 100; ++i) {
    auto version = std::make_shared<demonstration::Demonstration>(one);
    version->end_s -= 1e-6 * static_cast<double>(i);
    auto project = std::make_shared<Project>();
    project->demonstrations[version->id] = version;
    CHECK(maker.make({project, {}}, 1)->unmeasured == 0);
    most = std::max(most, maker.remembered());
  }
  CHECK(most == kMostMeasures);
  CHECK(maker.remembered() < 200);
}

TEST_CASE("a filter chooses by numbers, words, marks and their combinations") {
  ThreeOf three;
  MarkChange bad;
  bad.flag = Flag::kBad;
  bad.add = {"slow"};
  three.mark(three.c, bad);
  CHECK(three.found("") == "1 2 3");
  CHECK(three.found("length>2") == "3");
  CHECK(three.found("length>2s or name:\"expert 2\"") == "2 3");
  CHECK(three.found("duplicate not name:2") == "1");
  CHECK(three.found("novice") == "3");
  CHECK(three.found("expert") == "1 2 3");  // All were made by a scripted expert.
  CHECK(three.found("tag:SLOW and flag!=good") == "3");
  CHECK(three.found("flag:none") == "1 2");
  CHECK(three.found("not (tag:slow or name:1)") == "2");
  CHECK(three.found("segment:AC outcome:unfinished") == "1 2 3");
  CHECK(three.found("replay:unknown samples=400") == "1 2");
}

TEST_CASE("= asks for a text that is just that, : and ~ for one that has it somewhere") {
  ThreeOf three;
  MarkChange slow;
  slow.add = {"slow-start"};
  slow.flag = Flag::kBad;
  three.mark(three.b, slow);
  CHECK(three.found("name=expert") == "");
  CHECK(three.found("name=\"expert 2\"") == "2");
  CHECK(three.found("name!=\"expert 2\"") == "1 3");
  CHECK(three.found("name:expert") == "1 2");
  CHECK(three.found("name~expert") == "1 2");
  CHECK(three.found("name!~expert") == "3");
  CHECK(three.found("tag=slow") == "");
  CHECK(three.found("tag~slow") == "2");
  CHECK(three.found("flag~ba") == "2");
  CHECK(three.found("flag:ba") == "");
  CHECK(three.found("segment=ABCDE") == "1 2 3");
  CHECK(three.found("segment=AC") == "");
  CHECK(three.found("samples:400") == "1 2");
  CHECK(complaint("length~4") ==
        "length is a number, so that ~ says nothing of it; ask length=10 (character 7 of the filter)");
}

TEST_CASE("what is being measured leaves a row undecided, unless all else decides") {
  ThreeOf three;
  CHECK(three.found("idle>=0", false) == " and 3 undecided");
  CHECK(three.found("idle>=0 or name:novice", false) == "3 and 2 undecided");
  CHECK(three.found("idle>=0 and name:novice", false) == " and 1 undecided");
  CHECK(LibraryQuery::parse("idle>=0").value().measured());
  CHECK_FALSE(LibraryQuery::parse("length>=0").value().measured());
}

TEST_CASE("a filter that cannot be read says what is wrong and where") {
  CHECK(complaint("jerk>") == "nothing follows jerk> (character 6 of the filter)");
  CHECK(complaint("length>ten") == "length is a number (s), not \"ten\" (character 8 of the filter)");
  CHECK(complaint("name<3") == "name is text, so that < says nothing of it; ask name:WORD (character 5 of the filter)");
  CHECK(complaint("(a or b") == "a parenthesis is not closed (character 1 of the filter)");
  CHECK(complaint("a) b") == "\")\" closes nothing (character 2 of the filter)");
  CHECK(complaint("ü and") == "something is missing at the end (character 6 of the filter)");
  CHECK(complaint("lenght>3").find("there is no column \"lenght\"; there are id, name, length") == 0);
  CHECK(complaint(std::string(3000, 'a')) == "a filter has at most 2,000 characters");
  CHECK(complaint(std::string(900, '(')).find("nested too deep") != std::string::npos);
}

TEST_CASE("a term is put into a filter and taken out again") {
  CHECK(with_term_toggled("", "flag:bad") == "flag:bad");
  CHECK(with_term_toggled("length>3 and flag:bad", "flag:bad") == "length>3");
  CHECK(with_term_toggled("a or b", "flag:bad") == "(a or b) and flag:bad");
  CHECK(with_term_toggled("(a or b) and flag:bad", "flag:bad") == "(a or b)");
}

TEST_CASE("rows sort by any column, those without a value last") {
  ThreeOf three;
  MarkChange change;
  change.rating = 4;
  three.mark(three.b, change);
  const auto view = three.library();
  std::vector<const LibraryRow*> rows;
  for (const LibraryRow& row : view->rows) rows.push_back(&row);
  sort_library(rows, *find_library_column("length"), true);
  CHECK(rows.front()->id == three.c);
  sort_library(rows, *find_library_column("rating"), false);
  CHECK(rows.front()->id == three.b);
  sort_library(rows, *find_library_column("rating"), true);
  CHECK(rows.front()->id == three.b);
}

TEST_CASE("a saved filter is a filter key of what is exported") {
  ThreeOf three;
  REQUIRE(three.file.commit(SaveFilter{"long/ones", "length>2"}));
  REQUIRE(three.file.commit(SaveFilter{"broken", "length>"}));
  Progress progress;
  Diagnostics diagnostics;
  const auto& all = three.file.project()->demonstrations;
  const auto keys = filter_keys({three.file.project(), {}}, {all.at(three.c), all.at(three.a)}, progress, diagnostics);
  REQUIRE(keys);
  CHECK(*keys == std::map<std::string, std::vector<std::size_t>>{{"long_ones", {0}}});
  CHECK(diagnostics.warnings().size() == 1);
  REQUIRE(three.file.commit(RemoveFilter{"broken"}));
  CHECK_FALSE(three.file.commit(RemoveFilter{"broken"}));
}

}  // namespace trocar::workbench
