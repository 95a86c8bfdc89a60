"""What editing means on the command line: rates, steps of the history, conflicts of a stack, the lattice, takes that replace a part."""
import unittest

from cli_support import CHECK_FAILED, DONE, USAGE, CommandLineTest, trocar


class Rates(CommandLineTest):
    def thinned(self, rate_hz, lost=()):
        """A project with what is left of the expert's recording at another rate, without the samples in `lost`."""
        project = self.recorded_project()
        table = self.folder / "expert.csv"
        self.answer("demo", "export", project, "1", table)
        lines = table.read_text().splitlines()
        header = next(i for i, line in enumerate(lines) if not line.startswith("#"))
        rows = lines[header + 1:]
        count = int(len(rows) / 200.0 * rate_hz)
        kept = [rows[round(i * 200.0 / rate_hz)] for i in range(count) if i not in lost]
        thin = self.folder / "thin.csv"
        thin.write_text("\n".join(lines[:header + 1] + kept) + "\n")
        return project, str(self.answer("demo", "import", project, thin, "--name", "Thin")["id"])

    def gaps(self, answer):
        return [problem for problem in answer["problems"] if problem["kind"] == "time"]

    def test_gaps_at_30_hz_are_bridged_at_30_hz_and_all_fixes_are_one_step(self):
        project, thin = self.thinned(30.0, lost=(*range(40, 43), *range(90, 93), 150))
        before = self.answer("demo", "show", project, thin)
        trouble = trocar("demo", "check", project, thin, "--json")
        self.assertIn(trouble.returncode, (DONE, CHECK_FAILED))
        edits = self.answer("info", project)["edits"]
        done = trocar("demo", "check", project, thin, "--fix", "all")
        self.assertIn("of the history", done.stdout)
        self.assertEqual(self.answer("info", project)["edits"], edits + 1)
        stack = self.answer("demo", "stack", project, thin)["stack"]
        bridges = [entry for entry in stack if entry["edit"] == "bridge"]
        self.assertGreaterEqual(len(bridges), 3)
        self.assertEqual(len({entry["id"] for entry in stack}), len(stack))
        after = self.answer("demo", "check", project, thin, code=trocar("demo", "check", project, thin).returncode)
        self.assertEqual(self.gaps(after), [])
        # Each is still an edit of its own: one is switched off by the id as it is shown, and its gap is there again.
        self.assertRegex(stack[1]["entry"], r"^\d+\.1$")
        self.answer("demo", "stack", project, thin, bridges[0]["entry"], "disable")
        off = trocar("demo", "check", project, thin, "--json")
        self.assertEqual(off.stdout.count('"kind": "time"') + off.stdout.count('"kind":"time"'), 1)
        self.answer("undo", project)
        self.answer("undo", project)
        self.assertEqual(self.answer("demo", "show", project, thin)["hash"], before["hash"])

    def test_at_5_hz_there_is_jerk_and_motion_and_no_gap(self):
        project, thin = self.thinned(5.0)
        rows = {row["name"]: row for row in self.answer("demo", "list", project, "--measures")["demonstrations"]}
        self.assertGreater(rows["Thin"]["mean_smoothed_jerk_m_s3"], 0.0)
        self.assertLess(rows["Thin"]["idle_share"], 0.9)
        self.assertEqual(self.gaps(self.answer("demo", "check", project, thin,
                                               code=trocar("demo", "check", project, thin).returncode)), [])

    def test_at_2_hz_the_jerk_is_unknown(self):
        project, _ = self.thinned(2.0)
        rows = {row["name"]: row for row in self.answer("demo", "list", project, "--measures")["demonstrations"]}
        self.assertIsNone(rows["Thin"]["mean_smoothed_jerk_m_s3"])
        self.assertIsNotNone(rows["Expert"]["mean_smoothed_jerk_m_s3"])


class Stack(CommandLineTest):
    def test_an_edit_whose_span_is_gone_is_a_conflict_and_comes_back(self):
        project = self.recorded_project()
        length = self.answer("demo", "show", project, "1")["duration_s"]
        cut = self.answer("demo", "edit", project, "1", "delete", "--from", length - 1.0, "--to", length)["id"]
        self.answer("demo", "stack", project, "1", cut, "disable")
        smooth = self.answer("demo", "edit", project, "1", "smooth", "--from", length - 0.8, "--to", length - 0.2)
        answer = self.answer("demo", "stack", project, "1", cut, "enable")
        self.assertEqual(answer["conflicts"], 1)
        self.assertEqual([entry["id"] for entry in answer["stack"]], [cut, smooth["id"]])
        self.assertIsNone(answer["stack"][0]["conflict"])
        self.assertIn("holds 0 samples", answer["stack"][1]["conflict"])
        self.assertIn("conflict", trocar("demo", "stack", project, "1").stdout)
        back = self.answer("demo", "stack", project, "1", cut, "disable")
        self.assertEqual(back["conflicts"], 0)
        self.assertEqual(back["hash"], smooth["hash"])
        # What is asked for now and cannot be is refused.
        self.refused("demo", "stack", project, "1", smooth["id"], "change", "--", "smooth", "--from", "900", "--to", "901",
                     code=USAGE, saying="samples")
        self.refused("demo", "stack", project, "1", "12.x", "disable", code=USAGE, saying="no id of an edit")

    def test_snapping_tells_what_it_costs_and_a_second_time_changes_nothing(self):
        project = self.recorded_project()
        span = next(span for span in self.answer("demo", "show", project, "1")["segments"] if span["label"] == "A")
        snap = ("demo", "edit", project, "1", "snap", "--from", span["begin_s"] + 0.5, "--to", span["end_s"] - 0.1)
        first = self.answer(*snap)
        (figures,) = first["snap"]
        self.assertGreater(figures["actions"], 5)
        self.assertGreater(figures["max_error_mm"], figures["mean_error_mm"])
        # Half the diagonal of a cell, and as much again where it is filled in.
        self.assertLess(figures["max_error_mm"], 4.4)
        self.assertGreaterEqual(figures["skipped_cells"], 0)
        second = self.answer(*snap)
        self.assertEqual(second["hash"], first["hash"])
        self.assertEqual(second["snap"][0]["max_error_mm"], 0.0)
        self.assertEqual(second["snap"][0]["actions"], figures["actions"])

    def test_copies_are_one_step_with_a_name_each(self):
        project = self.recorded_project()
        edits = self.answer("info", project)["edits"]
        copies = self.answer("demo", "copy", project, "Expert", "--copies", "3", "--perturb-mm", "0.5")["copies"]
        self.assertEqual(len({copy["hash"] for copy in copies}), 3)
        named = self.answer("demo", "copy", project, "Expert", "--copies", "2", "--name", copies[0]["name"])["copies"]
        names = [copy["name"] for copy in copies + named]
        self.assertEqual(len(set(names)), 5, names)
        self.assertEqual(self.answer("info", project)["edits"], edits + 2)
        self.answer("undo", project)
        self.answer("undo", project)
        self.assertEqual(len(self.answer("demo", "list", project)["demonstrations"]), 1)
        self.answer("redo", project)
        self.assertEqual([copy["hash"] for copy in copies],
                         [self.answer("demo", "show", project, copy["id"])["hash"] for copy in copies])


class Takes(CommandLineTest):
    def script(self, text):
        path = self.folder / "take.keys"
        path.write_text(text)
        return path

    def record(self, project, script, *more):
        return self.answer("demo", "record", project, "--operator", "keys", "--script", self.script(script), *more)

    def test_a_time_limit_ends_a_take_by_keys(self):
        take = self.record(self.empty_project(), "0 hold W 0.2\n5 end\n", "--time-limit", "1.5", "--right", "still")
        self.assertAlmostEqual(take["duration_s"], 1.5, delta=0.02)

    def test_a_script_without_a_key_is_refused(self):
        project = self.empty_project()
        for text in ("", "\n\n", "# nothing yet\n"):
            self.refused("demo", "record", project, "--operator", "keys", "--script", self.script(text), code=USAGE,
                         saying="presses no key")
        self.assertEqual(self.answer("info", project)["demonstrations"], 0)

    def test_a_take_replaces_a_part_in_one_step_and_nothing_else(self):
        project = self.recorded_project()
        before = self.answer("demo", "show", project, "Expert")
        self.assertEqual(before["outcome"], "success")
        edits = self.answer("info", project)["edits"]
        take = self.record(project, "0 hold W 0.2\n0.1 pause 1\n0.4 end\n", "--replay", "Expert", "--from", "1", "--to", "2")
        self.assertEqual(self.answer("info", project)["edits"], edits + 1)
        self.assertEqual(take["id"], before["id"])
        self.assertEqual(take["duration_s"], before["duration_s"])
        self.assertEqual(take["samples"], before["samples"])
        self.assertEqual(take["segments"], before["segments"])
        self.assertEqual(take["outcome"], "unknown")
        self.assertEqual(take["recorded_outcome"], "success")
        self.assertIs(take["edited_since"], True)
        self.assertEqual(take["replaced"]["arms"], "left")
        self.assertAlmostEqual(take["take"]["duration_s"], 0.4, delta=0.02)
        self.assertAlmostEqual(take["replaced"]["to_s"], 1.4, delta=0.02)
        self.assertNotEqual(take["take"]["id"], before["id"])
        self.answer("undo", project)
        after = self.answer("demo", "show", project, "Expert")
        self.assertEqual((after["hash"], after["outcome"]), (before["hash"], "success"))


if __name__ == "__main__":
    unittest.main()
