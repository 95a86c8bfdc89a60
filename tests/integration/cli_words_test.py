"""What the command line says to somebody who is new to it: hints, names, numbers and help."""
import json
import sqlite3
import unittest

from cli_support import CHECK_FAILED, DONE, USAGE, WORLD, CommandLineTest, trocar


def alter(project, sql):
    database = sqlite3.connect(project)
    database.execute(sql)
    database.commit()
    database.close()


class Hints(CommandLineTest):
    def test_a_name_that_is_nearly_right_is_named(self):
        project = self.recorded_project()
        for wrong in ("expert", "Exprt", "Exp", "ex-pert"):
            self.refused("demo", "show", project, wrong, code=USAGE, saying='did you mean "Expert" (id 1)?')
        self.refused("demo", "show", project, "Somebody", code=USAGE, saying='there is "Expert" (id 1)')
        self.answer("model", "train", project, "1", "--method", "eg-maxent", "--episodes", "5")
        self.refused("model", "show", project, "EG-MaxEnt A", code=USAGE, saying='did you mean "eg-maxent A ε=0.1" (id 3)?')

    def test_a_command_or_option_that_is_nearly_right_is_named(self):
        self.refused("dmeo", code=USAGE, saying="did you mean demo?")
        self.refused("replay", "x", code=USAGE, saying="did you mean demo replay or trial replay?")
        self.refused("demo", "recrod", "x", code=USAGE, saying="did you mean record?")
        self.refused("field", "frob", code=USAGE, saying="there is export")
        self.refused("demo", code=USAGE, saying="record")
        self.refused(code=USAGE, saying="history")
        self.refused("rollout", "run", "p", "m", "--start", "all", code=USAGE, saying="did you mean --starts?")

    def test_forgotten_quotes_are_recognised(self):
        self.refused("demo", "show", "p.trocar", "Expert", "1", code=USAGE, saying='quote the name: "Expert 1"')

    def test_help_of_what_does_not_exist_is_an_error(self):
        self.refused("export", "--help", code=USAGE, saying="export is no command; did you mean demo export, model export or field export?")
        self.refused("demo", "nosuch", "--help", code=USAGE, saying="nosuch is no command")

    def test_help_shows_arguments_in_the_order_in_which_they_are_typed(self):
        for words in (["demo", "edit", "trim", "--help"], ["demo", "edit", "p", "d", "trim", "--help"], ["help", "demo", "edit", "trim"]):
            done = trocar(*words)
            self.assertEqual(done.returncode, DONE, words)
            self.assertIn("Usage: trocar demo edit PROJECT DEMO trim [OPTIONS]", done.stdout)
            self.assertIn("--idle", done.stdout)
        self.refused("demo", "edit", "lab.trocar", "trim", "--idle", code=USAGE,
                     saying="write trocar demo edit PROJECT DEMO trim")

    def test_window_scripts_are_explained_where_they_are_used(self):
        self.assertIn('type LABEL TEXT', trocar("ui", "run", "--help").stdout)
        script = self.folder / "acts.ui"
        script.write_text('press "Toolbar/Undo"\n')
        self.refused("ui", "run", "--script", script, code=USAGE, saying="there are click, ")
        script.write_text('type "seven"\n')
        self.refused("ui", "run", "--script", script, code=USAGE, saying="write type LABEL TEXT")
        self.assertIn("default NAME VALUE", trocar("run", "--help").stdout)

    def test_errors_are_objects_with_json(self):
        project = self.empty_project()
        for words, code in ((["demo", "show", project, "X"], USAGE), (["info", self.folder / "none.trocar"], WORLD),
                            (["demo", "nosuch"], USAGE), (["demo", "show", project], USAGE)):
            done = trocar("--json", *words)
            self.assertEqual(done.returncode, code)
            answer = json.loads(done.stdout)
            self.assertEqual(answer["exit"], code)
            self.assertEqual(f"trocar: {answer['error']}", done.stderr.strip())

    def test_options_that_would_be_ignored_are_refused(self):
        project = self.recorded_project()
        self.refused("view", "render", project, "1", "--layer", "reward", "--out", self.folder / "v.png", code=USAGE, saying="--model")
        for words in (["--montage"], ["--map", "viridis"], ["--width", "500"], ["--scale", "symlog"]):
            self.refused("field", "export", project, "2", *words, "--out", self.folder / "f.csv", code=USAGE, saying=words[0])
        self.assertEqual(self.leftovers(), ["recorded.trocar"])

    def test_a_slice_that_is_none_says_what_one_is(self):
        self.refused("field", "export", self.recorded_project(), "2", "--slice", "z=40", "--out", self.folder / "f.png", code=USAGE,
                     saying="z=N with N from 0 to 21")

    def test_a_file_that_is_there_already_comes_with_a_way_on(self):
        self.refused("new", self.empty_project(), code=WORLD, saying="another name")


class Names(CommandLineTest):
    def test_default_names_of_models_do_not_repeat(self):
        project = self.recorded_project()
        for name in ("exact A", "exact A 2", "exact A 3"):
            self.assertEqual(self.answer("model", "train", project, "1")["name"], name)

    def test_a_taken_name_is_numbered_and_this_is_said(self):
        project = self.recorded_project()
        self.assertEqual(self.answer("demo", "export", project, "1", self.folder / "Expert.csv")["format"], "csv")
        done = trocar("demo", "import", project, self.folder / "Expert.csv", "--json")
        self.assertEqual(json.loads(done.stdout)["name"], "Expert 2")
        self.assertIn("named Expert already", done.stderr)
        self.assertEqual(self.answer("model", "train", project, "1", "--name", "A exact")["name"], "A exact 2")
        self.assertEqual(self.answer("model", "train", project, "1", "--name", "A exact 2")["name"], "A exact 3")

    def test_a_rename_to_a_taken_name_is_refused(self):
        project = self.recorded_project()
        self.answer("demo", "export", project, "1", self.folder / "Other.csv")
        self.answer("demo", "import", project, self.folder / "Other.csv")
        self.refused("demo", "edit", project, "Other", "rename", "Expert", code=USAGE, saying="demonstration 1 is named Expert")
        self.answer("demo", "edit", project, "Expert", "rename", "Expert")

    def test_an_ambiguous_name_comes_with_its_ids(self):
        project = self.recorded_project()
        self.answer("demo", "export", project, "1", self.folder / "Other.csv")
        self.answer("demo", "import", project, self.folder / "Other.csv")
        alter(project, "UPDATE journal SET parameters = replace(parameters, 'Other', 'Expert')")
        self.refused("demo", "show", project, "Expert", code=USAGE, saying="give the id: 1, 3")


class Findings(CommandLineTest):
    def test_a_difference_in_labels_is_told(self):
        project = self.recorded_project()
        self.assertEqual(self.answer("demo", "diff", project, "1")["labels"], [])
        spans = self.answer("demo", "show", project, "1")["segments"]
        end_s = spans[0]["end_s"]
        self.answer("demo", "edit", project, "1", "label", "B", "--from", "0.20", "--to", "0.40")
        labels = self.answer("demo", "diff", project, "1")["labels"]
        self.assertEqual(labels[0], f"segment A was 0.00–{end_s:.2f} s, is 0.00–0.20 and 0.40–{end_s:.2f} s")
        self.assertIn("segment B was", labels[1])
        self.assertIn(labels[0], trocar("demo", "diff", project, "1").stdout)

    def test_segments_out_of_order_are_an_error(self):
        project = self.recorded_project()
        self.answer("demo", "check", project, "1")
        end_s = self.answer("demo", "show", project, "1")["end_s"]
        self.answer("demo", "edit", project, "1", "label", "A", "--from", str(end_s - 2), "--to", str(end_s - 1))
        done = trocar("demo", "check", project, "1")
        self.assertEqual(done.returncode, CHECK_FAILED)
        self.assertIn("segment E comes before segment A", done.stdout)
        self.assertIn("segment A comes again", done.stdout)

    def test_segments_are_shown_between_the_gates(self):
        project = self.recorded_project()
        before = self.answer("demo", "show", project, "1")["segments"]
        self.answer("demo", "edit", project, "1", "trim", "--from", "1.0", "--to", str(before[2]["end_s"] - 0.5))
        after = self.answer("demo", "show", project, "1")["segments"]
        self.assertEqual([span["label"] for span in after], ["A", "B", "C"])
        self.assertEqual((after[0]["begin_s"], after[0]["end_s"]), (1.0, before[0]["end_s"]))
        self.assertAlmostEqual(after[2]["end_s"], before[2]["end_s"] - 0.5)
        self.assertIn("segment A        1.00 …", trocar("demo", "show", project, "1").stdout)

    def test_people_read_rounded_numbers(self):
        project = self.recorded_project()
        self.answer("demo", "edit", project, "1", "trim", "--from", "0.615")
        for words in (["demo", "show", project, "1"], ["model", "show", project, "2"]):
            shown = trocar(*words).stdout
            self.assertNotRegex(shown, r"\d\.\d{10}")
            self.assertNotIn("{", shown)

    def test_only_the_agents_segments_are_learned_and_it_says_so(self):
        project = self.recorded_project()
        for segment in ("B", "D", "E"):
            self.refused("model", "train", project, "1", "--segment", segment, code=USAGE, saying="the agent does A")
        self.refused("model", "train", project, "1", "--segment", "Z", code=USAGE, saying="there are A, B, C, D and E")

    def test_a_comparison_of_different_tasks_is_warned_of(self):
        project = self.recorded_project()
        self.answer("model", "train", project, "1", "--segment", "C", "--name", "C exact")
        for words in (["model", "compare"], ["rollout", "compare"]):
            self.assertIn("different tasks", trocar(*words, project, "A exact", "C exact").stderr)
            self.assertEqual(trocar(*words, project, "A exact", "A exact").stderr, "")

    def test_a_stale_model_says_so_wherever_it_is_used(self):
        project = self.recorded_project()
        self.answer("demo", "edit", project, "1", "trim", "--from", "0.5")
        picture = self.folder / "v.png"
        for words in (["view", "render", project, "1", "--model", "2", "--size", "64x36", "--out", picture],
                      ["rollout", "run", project, "2"], ["rollout", "compare", project, "2", "2"], ["model", "compare", project, "2", "2"],
                      ["field", "export", project, "2", "--out", self.folder / "f.npy"]):
            self.assertEqual(trocar(*words).stderr.count("is stale"), 1, words)

    def test_neighbourhoods_are_counted_only_where_they_belong(self):
        project = self.recorded_project()
        self.assertEqual(trocar("rollout", "run", project, "2").stdout.count("within ±"), 5)
        self.assertNotIn("within ±", trocar("rollout", "run", project, "2", "--starts", "around:2").stdout)
        starts = self.folder / "s.csv"
        starts.write_text("i,j,k\n0,0,0\n")
        self.assertEqual(self.answer("rollout", "run", project, "2", "--starts", f"file:{starts}")["around"], [])

    def test_undo_and_redo_say_what(self):
        project = self.recorded_project()
        self.assertEqual(trocar("undo", project).stdout, "undone: Add model A exact; now at edit 1 (Add Expert)\n")
        self.assertEqual(trocar("redo", project).stdout, "done again: Add model A exact; now at edit 2 (Add model A exact)\n")

    def test_the_history_can_be_gone_to(self):
        project = self.recorded_project()
        self.answer("demo", "edit", project, "1", "rename", "Later")
        self.answer("undo", project)
        self.answer("demo", "edit", project, "1", "rename", "Other")
        self.assertEqual(self.answer("history", project, "--go", "3")["head"], 3)
        self.assertEqual(self.answer("demo", "show", project, "1")["name"], "Later")
        self.assertEqual(self.answer("history", project, "--go", "0")["head"], 0)
        self.assertEqual(self.answer("info", project)["demonstrations"], 0)
        self.refused("history", project, "--go", "9", code=USAGE, saying="no entry 9")


if __name__ == "__main__":
    unittest.main()
