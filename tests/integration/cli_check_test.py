"""`demo check`: problems on the true geometry, their quick fixes, and whether the simulator still transfers the block."""
import unittest

from cli_support import CHECK_FAILED, DONE, USAGE, CommandLineTest, trocar


class Check(CommandLineTest):
    def broken_project(self):
        """The left tool goes through the board at 3 s."""
        project = self.recorded_project()
        self.answer("demo", "edit", project, "1", "move", "--at", "3", "--by-mm=0,0,-45")
        return project

    def collisions(self, answer):
        return [problem for problem in answer["problems"] if problem["kind"] == "collision"]

    def test_a_recorded_transfer_has_no_errors_and_is_still_one_in_the_simulator(self):
        answer = self.answer("demo", "check", self.recorded_project(), "1", "--simulate", "--model", "A exact")
        self.assertEqual([problem for problem in answer["problems"] if problem["severity"] == "error"], [])
        self.assertIs(answer["simulation"]["transferred"], True)
        self.assertIn("is transferred: handed over at", answer["simulation"]["sentence"])

    def test_a_fix_by_id_is_one_step_that_mends_the_problem(self):
        project = self.broken_project()
        before = self.answer("demo", "check", project, "1", code=CHECK_FAILED)
        found = self.collisions(before)
        self.assertTrue(found)
        self.assertEqual(found[0]["id"], "collision-1")
        self.assertEqual(found[0]["arm"], "left")
        self.assertTrue(found[0]["fix"].startswith("move "), found[0])
        hash_before = self.answer("demo", "show", project, "1")["hash"]
        after = self.answer("demo", "check", project, "1", "--fix", "collision-1", code=CHECK_FAILED if len(found) > 1 else DONE)
        self.assertEqual(len(after["fixed"]), 1)
        self.assertGreater(after["cost"]["moved_samples"], 0)
        self.assertGreater(after["cost"]["max_deviation_m"], 0.0)
        self.assertLess(after["cost"]["max_deviation_m"], 0.020)
        self.assertLess(len(self.collisions(after)), len(found))
        self.answer("undo", project)
        self.assertEqual(self.answer("demo", "show", project, "1")["hash"], hash_before)

    def test_fixing_all_leaves_no_error_and_is_undone_in_one_step(self):
        project = self.broken_project()
        edits = self.answer("info", project)["edits"]
        answer = self.answer("demo", "check", project, "1", "--fix", "all", "--simulate")
        self.assertEqual(self.collisions(answer), [])
        self.assertIs(answer["simulation"]["transferred"], True)
        self.assertEqual(self.answer("info", project)["edits"], edits + 1)
        stack = self.answer("demo", "stack", project, "1")["stack"]
        self.assertEqual([entry["id"] for entry in stack[1:]], [fixed["id"] for fixed in answer["fixed"]])
        self.answer("undo", project)
        self.assertTrue(self.collisions(self.answer("demo", "check", project, "1", code=CHECK_FAILED)))

    def test_jaws_that_open_on_the_way_drop_the_block_and_that_is_said(self):
        project = self.recorded_project()
        carried = next(span for span in self.answer("demo", "show", project, "1")["segments"] if span["label"] == "C")
        at_s = 0.5 * (carried["begin_s"] + carried["end_s"])
        self.answer("demo", "edit", project, "1", "jaw", "--from", at_s, "--to", at_s + 0.6, "--jaw-deg", "55", "--ramp", "0.1")
        answer = self.answer("demo", "check", project, "1", "--simulate", code=CHECK_FAILED)
        self.assertEqual(answer["simulation"]["outcome"], "dropped")
        failed = [problem for problem in answer["problems"] if problem["id"] == "simulation-1"]
        self.assertEqual(len(failed), 1)
        self.assertEqual(failed[0]["severity"], "error")
        self.assertIn(answer["simulation"]["sentence"], failed[0]["message"])
        self.assertNotIn("0 errors", trocar("demo", "check", project, "1", "--simulate").stdout)
        self.assertIn("the left arm loses it at", answer["simulation"]["sentence"])
        self.assertAlmostEqual(answer["simulation"]["last_touch_s"], at_s, delta=0.6)

    def test_what_cannot_be_done_is_refused(self):
        project = self.recorded_project()
        self.refused("demo", "check", project, "1", "--fix", "melting-3", code=USAGE, saying="no problem melting-3")
        table = self.folder / "a.csv"
        self.answer("demo", "export", project, "1", table)
        imported = self.answer("demo", "import", project, table, "--block", "0", "--goal", "0")
        done = trocar("demo", "check", project, str(imported["id"]), "--simulate")
        self.assertEqual(done.returncode, USAGE, done.stdout)
        self.assertIn("cannot be simulated", done.stderr)


if __name__ == "__main__":
    unittest.main()
