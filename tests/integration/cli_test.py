"""The command line as a user meets it: keys of --json, exit codes, and what each command does to the project."""
import csv
import json
import struct
import unittest

from cli_support import CHECK_FAILED, DONE, USAGE, WORLD, CommandLineTest, trocar


def read_rows(path):
    with path.open(newline="") as file:
        return list(csv.DictReader(file))


class Grammar(CommandLineTest):
    def test_help_is_everywhere(self):
        for words in ([], ["demo"], ["demo", "record"], ["demo", "edit"], ["demo", "edit", "trim"], ["model", "train"],
                      ["field", "export"], ["rollout", "run"], ["view", "render"], ["video", "render"], ["ui", "run"], ["ui", "dump"],
                      ["run"], ["doctor"]):
            done = trocar(*words, "--help")
            self.assertEqual(done.returncode, DONE, words)
            self.assertIn("Usage", done.stdout, words)
            self.assertIn(words[-1] if words else "trocar", done.stdout)

    def test_wrong_usage_is_two_and_one_sentence(self):
        self.refused(code=USAGE)
        self.refused("nonsense", code=USAGE)
        self.refused("demo", code=USAGE)
        self.refused("info", code=USAGE, saying="PROJECT")
        self.refused("new", "a.trocar", "--colour", "red", code=USAGE)
        project = self.empty_project()
        self.refused("demo", "record", project, "--block", "6", code=USAGE)
        self.refused("demo", "record", project, "--skill", "wizard", code=USAGE)
        self.refused("demo", "record", project, "--seed", "many", code=USAGE)

    def test_seeds_are_taken_as_they_are_or_not_at_all(self):
        project = self.recorded_project()
        for seed in ("-1", "18446744073709551616", "1.5", "0x10", "010", "1e3", ""):
            self.refused("demo", "record", project, "--seed", seed, code=USAGE)
            self.refused("model", "train", project, "1", "--seed", seed, code=USAGE)
        answer = self.answer("model", "train", project, "1", "--method", "eg-maxent", "--episodes", "5", "--seed",
                             "18446744073709551615")
        self.assertEqual(answer["seed"], 18446744073709551615)

    def test_only_the_agents_segments_are_learned(self):
        project = self.recorded_project()
        for segment in ("B", "D", "E"):
            self.refused("model", "train", project, "1", "--segment", segment, code=USAGE)

    def test_names_that_do_not_fit_are_refused(self):
        project = self.recorded_project()
        self.refused("new", self.folder / "x.txt", code=USAGE, saying=".trocar")
        self.refused("view", "render", project, "1", "--out", self.folder / "v.jpg", code=USAGE, saying=".png")
        self.assertEqual(self.leftovers(), ["recorded.trocar"])

    def test_a_project_that_cannot_be_made_says_why(self):
        error = self.refused("new", "/proc/self/x.trocar", code=WORLD)
        self.assertRegex(error, r"^trocar: the project cannot be created \(.*No such file.*\): /proc/self/x\.trocar$")

    def test_version(self):
        self.assertRegex(trocar("--version").stdout, r"^trocar \d+\.\d+\.\d+")

    def test_quiet_prints_nothing(self):
        done = trocar("-q", "new", self.folder / "a.trocar")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (DONE, "", ""))


class Projects(CommandLineTest):
    def test_a_new_project_is_empty(self):
        answer = self.answer("info", self.empty_project())
        self.assertEqual([answer[key] for key in ("demonstrations", "models", "trials", "schema")], [0, 0, 0, 1])
        self.assertGreater(answer["size_bytes"], 0)

    def test_new_refuses_to_overwrite(self):
        project = self.empty_project()
        before = project.read_bytes()
        self.refused("new", project, code=WORLD, saying=str(project))
        self.assertEqual(project.read_bytes(), before)

    def test_undo_and_redo_walk_the_history(self):
        project = self.recorded_project()
        self.assertEqual(self.answer("undo", project)["head"], 1)
        self.assertEqual(self.answer("info", project)["models"], 0)
        self.assertEqual(self.answer("redo", project)["head"], 2)
        self.assertEqual(self.answer("info", project)["models"], 1)
        self.refused("redo", project, code=USAGE)

    def test_an_edit_after_an_undo_starts_a_branch(self):
        project = self.recorded_project()
        self.answer("undo", project)
        self.answer("demo", "edit", project, "Expert", "rename", "Other")
        history = self.answer("history", project)
        self.assertEqual([node["parent"] for node in history["history"]], [0, 1, 1])
        self.assertEqual([node["head"] for node in history["history"]], [False, False, True])
        self.assertEqual(history["head"], 3)
        for key in ("id", "parent", "name", "time"):
            self.assertIn(key, history["history"][0])
        self.assertEqual(trocar("history", project).stdout.count("\n"), 3)

    def test_an_empty_project_has_nothing_to_undo(self):
        self.refused("undo", self.empty_project(), code=USAGE)


class Demonstrations(CommandLineTest):
    def test_an_expert_places_the_block(self):
        self.recorded_project()
        answer = CommandLineTest.recorded
        self.assertEqual(answer["outcome"], "success")
        self.assertIs(answer["placed"], True)
        self.assertGreater(answer["samples"], 200)
        self.assertAlmostEqual(answer["duration_s"], (answer["samples"] - 1) / 200.0, delta=0.011)
        self.assertEqual([span["label"] for span in answer["segments"]], ["A", "B", "C", "D", "E"])

    def test_the_same_seed_records_the_same_states(self):
        hashes = set()
        for name in ("a.trocar", "b.trocar"):
            self.answer("new", self.folder / name)
            self.answer("demo", "record", self.folder / name, "--seed", "7", "--skill", "trained", "--block", "2",
                        "--name", "T")
            with self.subTest(name):
                self.answer("demo", "export", self.folder / name, "T", self.folder / (name + ".csv"))
            hashes.add((self.folder / (name + ".csv")).read_bytes())
        self.assertEqual(len(hashes), 1)

    def test_list_and_show(self):
        project = self.recorded_project()
        (listed,) = self.answer("demo", "list", project)["demonstrations"]
        shown = self.answer("demo", "show", project, "1")
        for key in ("id", "name", "duration_s", "samples", "rate_hz", "segments", "path_length_m", "hash", "provenance"):
            self.assertEqual(listed[key], shown[key])
        self.assertAlmostEqual(shown["rate_hz"], 200.0, delta=0.5)
        self.assertEqual(shown["provenance"]["operator"], "scripted")
        self.assertEqual(shown, self.answer("demo", "show", project, "Expert"))

    def test_an_unknown_name_is_refused(self):
        project = self.recorded_project()
        self.refused("demo", "show", project, "99", code=USAGE, saying="99")
        self.refused("demo", "show", project, "Nobody", code=USAGE, saying="Nobody")

    def test_edits_change_the_hash_and_undo_gives_it_back(self):
        project = self.recorded_project()
        before = self.answer("demo", "show", project, "1")
        trimmed = self.answer("demo", "edit", project, "1", "trim", "--from", "0.5", "--to", "3.0")
        self.assertEqual(trimmed["hash_before"], before["hash"])
        self.assertNotEqual(trimmed["hash_after"], before["hash"])
        self.assertAlmostEqual(self.answer("demo", "show", project, "1")["duration_s"], 2.5, delta=0.006)
        self.assertIs(self.answer("model", "show", project, "A exact")["stale"], True)
        self.answer("undo", project)
        self.assertEqual(self.answer("demo", "show", project, "1")["hash"], before["hash"])
        self.assertIs(self.answer("model", "show", project, "A exact")["stale"], False)

    def test_rename_and_label(self):
        project = self.recorded_project()
        self.answer("demo", "edit", project, "1", "rename", "Best of all")
        self.answer("demo", "edit", project, "Best of all", "label", "B", "--from", "0.2", "--to", "0.4")
        labels = [s["label"] for s in self.answer("demo", "show", project, "1")["segments"]]
        self.assertEqual(labels[:3], ["A", "B", "A"])

    def test_times_beyond_the_ends_are_the_ends(self):
        project = self.recorded_project()
        end_s = self.answer("demo", "show", project, "1")["end_s"]
        edit = self.answer("demo", "edit", project, "1", "trim", "--from", "1", "--to", "1e9")
        self.assertIn(f"to 1.00–{end_s:.2f} s", edit["description"])
        edit = self.answer("demo", "edit", project, "1", "trim", "--from", "-5", "--to", "20")
        self.assertIn("to 0.00–20.00 s", edit["description"])
        self.refused("demo", "edit", project, "1", "trim", "--from", "-7", "--to", "20", code=USAGE, saying="already")
        edit = self.answer("demo", "edit", project, "1", "label", "B", "--from", "-5", "--to", "0.5")
        self.assertIn("Label 0.00–0.50 s", edit["description"])
        self.refused("demo", "edit", project, "1", "trim", "--from", "nan", code=USAGE)

    def test_an_import_says_what_is_wrong_with_it(self):
        project = self.recorded_project()
        good = self.folder / "good.csv"
        self.answer("demo", "export", project, "1", good)
        answer = self.answer("demo", "import", project, good)
        self.assertEqual(answer["errors"], 0)
        lines = good.read_text().splitlines()
        header = next(i for i, line in enumerate(lines) if not line.startswith("#"))
        columns = lines[header].split(",")
        for column, value in (("left_setpoint_x_m", "1e30"), ("left_setpoint_jaw_rad", "1e9")):
            with self.subTest(column):
                rows = [line.split(",") for line in lines]
                rows[header + 50][columns.index(column)] = value
                bad = self.folder / "bad.csv"
                bad.write_text("\n".join(",".join(row) for row in rows) + "\n")
                answer = self.answer("demo", "import", project, bad)
                self.assertGreater(answer["errors"], 0)
                self.assertIn("error", trocar("demo", "import", project, bad).stdout)
                self.answer("demo", "check", project, str(answer["id"]), code=CHECK_FAILED)

    def test_trimming_idle_ends_keeps_the_motion(self):
        project = self.recorded_project()
        before = self.answer("demo", "show", project, "1")
        self.answer("demo", "edit", project, "1", "trim", "--idle")
        after = self.answer("demo", "show", project, "1")
        removed_s = before["duration_s"] - after["duration_s"]
        self.assertGreater(removed_s, 0)
        # What is slower than 2 mm/s is idle (workbench, "Auto-trim idle").
        self.assertAlmostEqual(after["path_length_m"], before["path_length_m"], delta=0.002 * removed_s)
        again = self.answer("demo", "edit", project, "1", "trim", "--idle")
        self.assertIsNone(again["id"])
        self.assertEqual(again["hash_before"], again["hash_after"])

    def test_edits_that_make_no_sense_are_refused_and_change_nothing(self):
        project = self.recorded_project()
        before = self.answer("info", project)
        for wrong in (["trim", "--from", "3", "--to", "2"], ["trim", "--from", "nan"], ["trim"], ["trim", "--from", "1e9"],
                      ["trim", "--idle", "--from", "1"], ["label", "F", "--from", "0", "--to", "1"],
                      ["label", "A", "--from", "2", "--to", "1"], ["rename", ""], ["melt"]):
            self.refused("demo", "edit", project, "1", *wrong, code=USAGE)
        self.assertEqual(self.answer("info", project)["hash"], before["hash"])
        self.assertEqual(self.answer("info", project)["edits"], before["edits"])

    def test_replay_verifies_what_was_recorded(self):
        answer = self.answer("demo", "replay", self.recorded_project(), "1", "--verify")
        self.assertIs(answer["verified"], True)
        self.assertIsNone(answer["diverged_at_s"])

    def test_check_lists_problems_with_all_keys(self):
        done = trocar("demo", "check", self.recorded_project(), "1", "--json")
        problems = json.loads(done.stdout)["problems"]
        for problem in problems:
            for key in ("kind", "severity", "begin_s", "end_s", "message", "fix"):
                self.assertIn(key, problem)
        worst = any(problem["severity"] == "error" for problem in problems)
        self.assertEqual(done.returncode, CHECK_FAILED if worst else DONE)

    def test_check_finds_a_missing_segment(self):
        project = self.recorded_project()
        end_s = self.answer("demo", "show", project, "1")["segments"][0]["end_s"]
        self.answer("demo", "edit", project, "1", "trim", "--from", str(end_s + 0.1))
        problems = json.loads(trocar("demo", "check", project, "1", "--json").stdout)["problems"]
        self.assertTrue(any("A" in problem["message"] for problem in problems), problems)

    def test_diff_against_the_original_counts_what_a_trim_removed(self):
        project = self.recorded_project()
        answer = self.answer("demo", "diff", project, "1")
        self.assertEqual([answer[key] for key in ("duration_change_s", "removed", "added", "moved")], [0, 0, 0, 0])
        self.answer("demo", "edit", project, "1", "trim", "--from", "1.0")
        answer = self.answer("demo", "diff", project, "1", "--against", "original")
        self.assertAlmostEqual(answer["duration_change_s"], -1.0, delta=0.006)
        self.assertEqual(answer["removed"], 200)
        self.assertEqual(answer["max_deviation_mm"], 0)
        self.assertEqual(answer["rms_deviation_mm"], 0)

    def test_diff_compares_with_a_point_of_the_history_by_every_alignment(self):
        project = self.recorded_project()
        self.answer("demo", "edit", project, "1", "offset", "--by-mm", "0,0,4")
        point = self.answer("history", project)["head"]
        self.answer("demo", "edit", project, "1", "offset", "--by-mm", "0,0,3")
        original = self.answer("demo", "diff", project, "1")
        self.assertAlmostEqual(original["max_deviation_mm"], 7, delta=1e-3)
        for alignment in ("time", "arc", "segment"):
            answer = self.answer("demo", "diff", project, "1", "--against", f"history:{point}", "--align", alignment)
            for key in ("max_deviation_mm", "mean_deviation_mm", "share_95_deviation_mm"):
                self.assertAlmostEqual(answer[key], 3, delta=1e-3)
        # Warping finds what is nearer.
        warped = self.answer("demo", "diff", project, "1", "--against", f"history:{point}", "--align", "dtw")
        self.assertLess(warped["mean_deviation_mm"], 3)
        text = trocar("demo", "diff", project, "1", "--against", f"history:{point}", "--format", "md").stdout
        self.assertTrue(text.startswith("### "), text)
        self.assertIn("| both | 3.000 | 3.000 | 3.000 |", text)
        self.refused("demo", "diff", project, "1", "--against", "history:0", code=USAGE)
        self.refused("demo", "diff", project, "1", "--against", "history:999", code=USAGE)
        self.refused("demo", "diff", project, "1", "--against", "history:x", code=USAGE)

    def test_curves_are_written_as_numbers_and_as_figures(self):
        project = self.recorded_project()
        out = self.folder / "curves.csv"
        answer = self.answer("demo", "plot", project, "1", "--curve", "z,speed", "--out", out)
        rows = read_rows(out)
        for told in answer["curves"]:
            values = [float(row["value"]) for row in rows if row["curve"] == told["curve"] and row["line"] == told["arm"]]
            self.assertEqual((min(values), max(values)), (told["low"], told["high"]))
        self.assertEqual({row["unit"] for row in rows}, {"mm", "mm/s"})
        shown = self.answer("demo", "show", project, "1")
        self.assertEqual(sum(row["curve"] == "z" and row["line"] == "Left" for row in rows), shown["samples"])
        for name in ("curves.svg", "curves.png"):
            self.answer("demo", "plot", project, "1", "--curve", "speed,acceleration,jerk,jaw", "--out", self.folder / name)
            self.assertGreater((self.folder / name).stat().st_size, 5000)
        self.refused("demo", "plot", project, "1", "--curve", "sped", "--out", out, code=USAGE)
        self.refused("demo", "plot", project, "1", "--from", "3", "--to", "2", "--out", out, code=USAGE)
        self.refused("demo", "plot", project, "1", "--out", self.folder / "curves.doc", code=USAGE)


class Learning(CommandLineTest):
    def test_exact_arrives_from_every_cell(self):
        project = self.recorded_project()
        for key in ("id", "seconds", "fully_explored", "fully_unexplored", "arrival_from_start"):
            self.assertIn(key, CommandLineTest.trained)
        answer = self.answer("rollout", "run", project, "A exact", "--starts", "all")
        self.assertEqual((answer["count"], answer["arrived"]), (22**3, 22**3))

    def test_rollouts_count_every_start_once(self):
        project = self.recorded_project()
        out = self.folder / "rollouts.csv"
        answer = self.answer("rollout", "run", project, "A exact", "--starts", "around:2", "--out", out)
        self.assertEqual(answer["arrived"] + answer["looped"] + answer["dead_end"] + answer["outside"], answer["count"])
        self.assertEqual([row["k"] for row in answer["around"]], [1, 2, 3, 4, 5])
        self.assertEqual(answer["around"][1]["arrived"], answer["arrived"])
        rows = read_rows(out)
        self.assertEqual(len(rows), answer["count"])
        self.assertEqual(sum(row["end"] == "arrives" for row in rows), answer["arrived"])

    def test_starts_from_a_file(self):
        project = self.recorded_project()
        starts = self.folder / "starts.csv"
        starts.write_text("i,j,k\n0,0,0\n21,21,21\n")
        self.assertEqual(self.answer("rollout", "run", project, "A exact", "--starts", f"file:{starts}")["count"], 2)
        for text in ("", "i,j\n0,0\n", "i,j,k\n", "i,j,k\n0,0,22\n", "i,j,k\n0,0,nan\n", "i,j,k\n0,0\n", "\0\xff\n"):
            starts.write_text(text)
            self.refused("rollout", "run", project, "A exact", "--starts", f"file:{starts}", code=WORLD)
        for text in ("some", "around:", "around:-1", "around:99", "around:1.5"):
            self.refused("rollout", "run", project, "A exact", "--starts", text, code=USAGE)
        self.refused("rollout", "run", project, "A exact", "--starts", "file:none.csv", code=WORLD)

    def test_comparing_a_model_with_itself_finds_no_difference(self):
        project = self.recorded_project()
        answer = self.answer("rollout", "compare", project, "A exact", "A exact")
        self.assertEqual((answer["wins_a"], answer["wins_b"], answer["ties"]), (0, 0, 22**3))
        self.assertEqual(answer["mcnemar_p"], 1.0)
        self.assertEqual(self.answer("model", "compare", project, "2", "2")["policy_changed"], 0)

    def test_exploration_reaches_more_states(self):
        """Section V.A of the paper: the sign of both changes."""
        project = self.recorded_project()
        for epsilon, name in (("0", "none"), ("0.1", "some")):
            self.answer("model", "train", project, "Expert", "--method", "eg-maxent", "--epsilon", epsilon, "--name", name)
        answer = self.answer("model", "compare", project, "none", "some")
        self.assertGreater(answer["fully_explored"]["change_percent"], 0)
        self.assertLess(answer["fully_unexplored"]["change_percent"], 0)

    def test_parameters_that_make_no_sense_are_refused(self):
        project = self.recorded_project()
        for wrong in (["--epsilon", "-0.1"], ["--epsilon", "1.1"], ["--epsilon", "nan"], ["--episodes", "0"],
                      ["--episodes", "-5"], ["--grid", "0"], ["--grid", "-1"], ["--grid", "100000"], ["--segment", "Z"],
                      ["--method", "magic"]):
            method = [] if "--method" in wrong else ["--method", "eg-maxent"]
            self.refused("model", "train", project, "1", *method, *wrong, code=USAGE)
        self.refused("model", "train", project, "7", code=USAGE, saying="7")
        self.assertEqual(self.answer("info", project)["models"], 1)

    def test_exact_claims_no_exploration(self):
        project = self.recorded_project()
        for answer in (CommandLineTest.trained, self.answer("model", "show", project, "2"),
                       self.answer("model", "list", project)["models"][0]):
            for key in ("epsilon", "episodes", "seed", "fully_explored", "partly_explored", "fully_unexplored"):
                self.assertIsNone(answer[key])
            self.assertGreater(answer["iterations"], 0)
            self.assertGreater(answer["mismatch"], 0.0)
        self.assertNotIn("explored", trocar("model", "list", project).stdout)
        compared = self.answer("model", "compare", project, "2", "2")
        self.assertIsNone(compared["fully_explored"]["a"])

    def test_from_above_is_said_of_segment_a_only(self):
        project = self.recorded_project()
        self.answer("model", "train", project, "1", "--segment", "C", "--name", "C exact")
        self.assertIn("from above", trocar("rollout", "run", project, "A exact").stdout)
        self.assertNotIn("from above", trocar("rollout", "run", project, "C exact").stdout)

    def test_fields_as_numbers_agree(self):
        project = self.recorded_project()
        self.answer("field", "export", project, "A exact", "--layer", "reward", "--out", self.folder / "r.csv")
        self.answer("field", "export", project, "A exact", "--layer", "reward", "--out", self.folder / "r.npy")
        rows = read_rows(self.folder / "r.csv")
        self.assertEqual(len(rows), 22**3)
        raw = (self.folder / "r.npy").read_bytes()
        self.assertEqual(raw[:6], b"\x93NUMPY")
        header = 10 + struct.unpack("<H", raw[8:10])[0]
        values = struct.unpack(f"<{22**3}d", raw[header:])
        for row in rows[:: 97]:
            index = (int(row["i"]) * 22 + int(row["j"])) * 22 + int(row["k"])
            if row["value"]:
                self.assertAlmostEqual(float(row["value"]), values[index], places=5)

    def test_fields_as_figures(self):
        project = self.recorded_project()
        for layer in ("reward", "value", "q+x", "q-z", "margin", "visits", "explored", "safe", "basin", "steps", "policy",
                      "expert", "theta-change", "obstacles"):
            out = self.folder / f"{layer}.png"
            self.answer("field", "export", project, "A exact", "--layer", layer, "--slice", "z=11", "--out", out)
            self.assertEqual(out.read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        self.answer("field", "export", project, "A exact", "--montage", "--out", self.folder / "m.svg")
        self.assertIn("<svg", (self.folder / "m.svg").read_text())
        seen = set()
        for vision in ("full", "protan", "deutan", "tritan", "grey"):
            out = self.folder / f"{vision}.png"
            self.answer("field", "export", project, "A exact", "--slice", "z=11", "--vision", vision, "--out", out)
            seen.add(out.read_bytes())
        self.assertEqual(len(seen), 5)
        for wrong in (["--slice", "w=1"], ["--slice", "z=22"], ["--slice", "z=-1"], ["--layer", "mood"], ["--vision", "dog"]):
            self.refused("field", "export", project, "A exact", *wrong, "--out", self.folder / "n.png", code=USAGE)
        self.refused("field", "export", project, "A exact", "--out", self.folder / "n.docx", code=USAGE)
        self.assertFalse(list(self.folder.glob("n.*")))


class Pictures(CommandLineTest):
    def test_a_view_has_the_size_that_was_asked_for(self):
        project = self.recorded_project()
        out = self.folder / "view.png"
        self.answer("view", "render", project, "1", "--at", "1.0", "--camera", "top", "--size", "322x180", "--out", out)
        self.assertEqual(struct.unpack(">II", out.read_bytes()[16:24]), (322, 180))
        self.refused("view", "render", project, "1", "--size", "0x180", "--out", out, code=USAGE)
        self.refused("view", "render", project, "1", "--camera", "moon", "--out", out, code=USAGE)
        for at in ("nan", "-1", "1e9"):
            self.refused("view", "render", project, "1", "--at", at, "--out", out, code=USAGE)

    def test_a_view_draws_a_field_as_it_is_asked_to(self):
        project = self.recorded_project()
        pictures = set()
        for n, drawing in enumerate(
                ([], ["--no-slices"], ["--scale", "rank"], ["--map", "magma"], ["--vision", "grey"], ["--slice", "x=3"],
                 ["--slab", "5"], ["--slab", "1,3,1"], ["--limits", "-3", "-1"], ["--glyphs", "best"], ["--glyphs", "stars"],
                 ["--no-slices", "--voxels", "0.5"], ["--no-slices", "--iso", "0.5"], ["--no-slices", "--volume"],
                 ["--no-slices", "--volume", "--opacity", "0.3"], ["--no-slices", "--volume", "--opacity-curve", "lowest"],
                 ["--no-slices", "--volume", "--opacity-curve", "0:0/0.5:0.4/1:0"], ["--no-slices", "--streamlines", "around:2"])):
            out = self.folder / f"{n}.png"
            self.answer("view", "render", project, "1", "--size", "320x180", "--model", "A exact", "--layer", "reward", *drawing,
                        "--out", out)
            pictures.add(out.read_bytes())
        self.assertEqual(len(pictures), 18)
        out = self.folder / "no.png"
        for wrong in (["--scale", "log10"], ["--map", "rainbow"], ["--vision", "dog"], ["--iso", "1.5"], ["--voxels", "-1"],
                      ["--glyphs", "hats"], ["--streamlines", "there"], ["--slab", "0"], ["--slab", "1,2"], ["--limits", "2", "1"],
                      ["--slice", "z=22"], ["--no-slices", "--slice", "z=2"], ["--layer", "safe", "--volume"],
                      ["--volume", "--opacity-curve", "hill"], ["--opacity-curve", "ramp"],
                      ["--layer", "policy", "--iso", "0.5"]):
            self.refused("view", "render", project, "1", "--model", "A exact", *wrong, "--out", out, code=USAGE)
        self.refused("view", "render", project, "1", "--volume", "--out", out, code=USAGE)
        self.assertFalse(out.exists())

    def test_a_film_has_a_frame_for_each_moment(self):
        project = self.recorded_project()
        self.answer("demo", "edit", project, "1", "trim", "--from", "1", "--to", "3")
        out = self.folder / "film.mp4"
        answer = self.answer("video", "render", project, "1", "--fps", "10", "--size", "160x90", "--out", out)
        self.assertAlmostEqual(answer["frames"], 20, delta=1)
        self.assertEqual(answer["seconds"], answer["frames"] / 10)
        self.assertIn("codec", answer)
        self.assertEqual(self.leftovers(), ["film.mp4", "recorded.trocar"])
        self.answer("video", "render", project, "1", "1", "--layout", "side-by-side", "--fps", "5", "--size", "160x90",
                    "--out", self.folder / "pair.mp4")

    def test_films_that_cannot_be_are_refused_and_leave_nothing(self):
        project = self.recorded_project()
        film = self.folder / "film.mp4"
        for wrong in (["--size", "9x90"], ["--fps", "0"], ["--fps", "nan"], ["--fps", "-1"], ["--speed", "0"],
                      ["--layout", "side-by-side"], ["--codec", "paint"], ["--overlays", "paint"], ["--preset", "paint"],
                      ["--sync", "paint"]):
            self.refused("video", "render", project, "1", *wrong, "--out", film, code=USAGE)
        self.refused("video", "render", project, "1", "--out", self.folder / "film.txt", code=USAGE)
        self.refused("video", "render", project, "1", "--out", self.folder / "no" / "film.mp4", code=WORLD)
        self.assertEqual(self.leftovers(), ["recorded.trocar"])

    def test_the_window_runs_without_a_display(self):
        project = self.recorded_project()
        script = self.folder / "acts.ui"
        shot = self.folder / "window.png"
        script.write_text('click "Library/Demonstrations/Expert"\nwait idle 60\n')
        answer = self.answer("ui", "run", "--project", project, "--script", script, "--screenshot", shot,
                             "--size", "1024x640")
        self.assertEqual((answer["lines"], answer["screenshots"]), (2, 1))
        self.assertEqual(struct.unpack(">II", shot.read_bytes()[16:24]), (1024, 640))
        widgets = self.answer("ui", "dump", "--project", project)["widgets"]
        self.assertGreater(len(widgets), 20)
        script.write_text('click "Library/Nobody"\n')
        self.assertIn("1", self.refused("ui", "run", "--project", project, "--script", script, code=USAGE))
        self.refused("ui", "run", "--script", self.folder / "none.ui", code=WORLD)
        self.refused("ui", "run", "--project", self.folder / "none.trocar", code=WORLD, saying="no such project")
        cut = self.folder / "cut.trocar"
        cut.write_bytes(project.read_bytes()[:20000])
        self.refused("ui", "run", "--project", cut, code=WORLD, saying="truncated")

    def test_doctor_says_what_there_is(self):
        done = trocar("doctor", "--json")
        answer = json.loads(done.stdout)
        for key in ("gl", "codecs", "formats", "devices", "links"):
            for entry in answer[key]:
                self.assertTrue(entry["detail"])


class Scripts(CommandLineTest):
    def test_a_script_runs_in_order_and_its_variables_are_replaced(self):
        script = self.folder / "run.trocar"
        script.write_text('# A comment\ndefault name plain\n\nnew "${out}/${name}.trocar"\ninfo ${out}/${name}.trocar # end\n')
        answer = self.answer("run", script, "--out", self.folder / "o", "--set", "name=own name")
        self.assertEqual([step["exit"] for step in answer["steps"]], [0, 0])
        self.assertTrue((self.folder / "o" / "own name.trocar").exists())

    def test_a_script_stops_at_the_first_failure_with_its_exit_code(self):
        script = self.folder / "run.trocar"
        script.write_text("new ${out}/a.trocar\ninfo ${out}/none.trocar\nnew ${out}/b.trocar\n")
        done = trocar("run", script, "--out", self.folder / "o")
        self.assertEqual(done.returncode, WORLD)
        self.assertIn("line 2", done.stderr)
        self.assertFalse((self.folder / "o" / "b.trocar").exists())

    def test_a_variable_that_the_script_does_not_have_is_refused(self):
        script = self.folder / "run.trocar"
        script.write_text("default size 3\nnew ${out}/a.trocar\n")
        self.refused("run", script, "--out", self.folder / "o", "--set", "siez=4", code=USAGE, saying="siez")
        self.answer("run", script, "--out", self.folder / "o", "--set", "size=4")

    def test_a_script_that_runs_itself_is_stopped(self):
        script = self.folder / "run.trocar"
        script.write_text("run ${here}/run.trocar --out ${out}\n")
        self.assertIn("itself", trocar("run", script, "--out", self.folder / "o").stderr)
        self.assertEqual(trocar("run", script, "--out", self.folder / "o").returncode, USAGE)

    def test_broken_scripts_are_refused(self):
        script = self.folder / "run.trocar"
        for text in ('new "open\n', "new ${nobody}\n", "new ${out\n"):
            script.write_text(text)
            self.refused("run", script, code=WORLD, saying="line 1")
        self.refused("run", self.folder / "none", code=WORLD)


if __name__ == "__main__":
    unittest.main()
