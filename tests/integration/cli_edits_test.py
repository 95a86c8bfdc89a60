"""Every parameter of the edits as the command line takes it: dry runs, choices, numbers of what an edit does, sentences."""
import json
import unittest

from cli_support import DONE, USAGE, CommandLineTest, trocar


class Parameters(CommandLineTest):
    def edit(self, project, *words, code=DONE):
        return self.answer("demo", "edit", project, "Expert", *words, code=code)

    def test_help_shows_choices_units_and_what_is_so_if_nobody_says(self):
        text = trocar("demo", "edit", "smooth", "--help").stdout
        for words in ("savitzky-golay|gaussian|low-pass", "left|right|both", "NUMBER, mm", "(else 2)", "(else the begin gate)",
                      "--lock-jaws", "yes|no", "--dry-run"):
            self.assertIn(words, text)
        text = trocar("demo", "edit", "retime", "--help").stdout
        for words in ("scale|duration|speed-cap|constant-speed|warp", "--ease-in", "--ease-out", "--knots", "1.5:2,3:2.5"):
            self.assertIn(words, text)

    def test_a_dry_run_says_what_would_be_and_changes_nothing(self):
        project = self.recorded_project()
        before = self.answer("info", project)["hash"]
        dry = self.edit(project, "smooth", "--width", "0.3", "--dry-run")
        self.assertTrue(dry["dry_run"])
        self.assertIsNone(dry["id"])
        self.assertEqual(self.answer("info", project)["hash"], before)
        self.assertIn("Would be: Smooth", trocar("demo", "edit", project, "Expert", "smooth", "--dry-run").stdout)
        made = self.edit(project, "smooth", "--width", "0.3")
        self.assertEqual(made["hash_after"], dry["hash_after"])
        self.assertEqual(made["effect"], dry["effect"])
        self.assertLess(made["effect"]["after"]["mean_raw_jerk_m_s3"][0], made["effect"]["before"]["mean_raw_jerk_m_s3"][0])
        self.assertLessEqual(made["effect"]["rms_deviation_m"], made["effect"]["max_deviation_m"])
        self.assertLessEqual(made["effect"]["max_deviation_m"], 0.002 + 1e-7)

    def test_idle_spans_are_listed_and_some_of_them_kept(self):
        project = self.recorded_project()
        self.edit(project, "retime", "--from", "3", "--to", "3.05", "--mode", "duration", "--duration", "2")
        words = ("trim-idle", "--inside=yes", "--speed-mm-s", "3")
        spans = self.edit(project, *words, "--dry-run")["spans"]
        self.assertGreaterEqual(len(spans), 1)
        for span in spans:
            self.assertLess(span["from_s"], span["to_s"])
            self.assertFalse(span["stays"])
        inside = [span for span in spans if span["where"] == "inside"]
        self.assertTrue(inside)
        kept = inside[0]
        all_gone = self.edit(project, *words, "--dry-run")
        some = self.edit(project, *words, "--keep-span", kept["span"], "--dry-run") if len(spans) > 1 else None
        if some:
            self.assertTrue(some["spans"][kept["span"] - 1]["stays"])
            self.assertAlmostEqual(some["duration_s"] - all_gone["duration_s"], kept["to_s"] - kept["from_s"], delta=0.011)
        self.refused("demo", "edit", project, "Expert", *words, "--keep-span", "99", code=USAGE,
                     saying=f"there is no idle span 99, but {len(spans)}; --dry-run lists them")

    def test_time_goes_by_a_curve_and_eases(self):
        project = self.recorded_project()
        length = self.answer("demo", "show", project, "Expert")["duration_s"]
        warped = self.edit(project, "retime", "--from", "1", "--to", "3", "--mode", "warp", "--knots", "2:2.5,3:3.25")
        self.assertAlmostEqual(warped["duration_s"], length + 0.25, delta=0.006)
        self.assertIn("by a curve of 2 knots", warped["description"])
        self.assertEqual(warped["effect"]["speed_limit_m_s"], 0.25)
        eased = self.edit(project, "retime", "--from", "1", "--to", "3", "--ease-in", "0.4", "--ease-out", "0.2")
        self.assertAlmostEqual(eased["duration_s"], warped["duration_s"] + 0.3, delta=0.006)
        self.refused("demo", "edit", project, "Expert", "retime", "--mode", "warp", code=USAGE, saying="needs a knot")
        self.refused("demo", "edit", project, "Expert", "retime", "--mode", "warp", "--knots", "2-3", code=USAGE,
                     saying="two numbers with a colon between")

    def test_a_rate_that_is_too_low_says_what_is_lost(self):
        project = self.recorded_project()
        for method in ("linear", "cubic", "nearest"):
            answer = self.edit(project, "resample", "--rate-hz", "100", "--method", method, "--dry-run")
            self.assertEqual(answer["remarks"], [])
        coarse = self.edit(project, "resample", "--rate-hz", "2", "--dry-run")
        self.assertGreater(coarse["effect"]["energy_above_half_rate"], 0.01)
        self.assertIn("aliasing", coarse["remarks"][0])

    def test_a_trim_that_changes_nothing_is_refused_and_one_that_cuts_the_end_away_leaves_it_unknown(self):
        project = self.recorded_project()
        for dry in ([], ["--dry-run"]):
            self.refused("demo", "edit", project, "Expert", "trim", "--from=-5", "--to", "300", *dry, code=USAGE,
                         saying="already")
        self.assertEqual(self.answer("demo", "show", project, "Expert")["outcome_doubt"], "")
        self.edit(project, "trim", "--to", "8")
        cut = self.answer("demo", "show", project, "Expert")
        self.assertEqual(cut["outcome"], "unknown")
        self.assertFalse(cut["placed"])
        self.assertEqual(cut["outcome_doubt"], "the gates leave out how it ended")
        self.assertEqual(cut["recorded_outcome"], "success")

    def test_a_mirrored_transfer_says_that_it_fits_no_peg(self):
        project = self.recorded_project()
        for dry in (["--dry-run"], []):
            self.assertIn("no longer fits a peg", self.edit(project, "mirror", *dry)["remarks"][0])

    def test_one_channel_of_one_arm_comes_back(self):
        project = self.recorded_project()
        original = self.answer("demo", "show", project, "Expert")["hash"]
        self.edit(project, "offset", "--by-mm", "1,0,0", "--arms", "left")
        self.assertNotEqual(self.edit(project, "revert", "--what", "jaw", "--dry-run")["hash_after"], original)
        back = self.edit(project, "revert", "--arms", "left", "--what", "pose")
        self.assertEqual(back["hash_after"], original)
        self.edit(project, "label", "B", "--from", "1", "--to", "2")
        labels = self.answer("demo", "show", project, "Expert")["segments"]
        self.edit(project, "revert", "--what", "labels")
        self.assertNotEqual(self.answer("demo", "show", project, "Expert")["segments"], labels)

    def test_notes_have_a_colour_and_a_glyph(self):
        project = self.recorded_project()
        self.edit(project, "note", "here it slips", "--from", "1", "--to", "2", "--colour", "red", "--glyph", "star", "--rating", "4")
        words = self.answer("demo", "stack", project, "Expert")["stack"][0]["words"]
        value = dict(zip(words[2::2], words[3::2]))
        self.assertEqual((value["--colour"], value["--glyph"], value["--rating"]), ("red", "star", "4"))
        self.refused("demo", "edit", project, "Expert", "note", "x", "--colour", "pink", code=USAGE, saying="plain, red, orange")

    def test_gripper_events_are_found_in_the_trace(self):
        project = self.recorded_project()
        answer = self.edit(project, "jaw-events", "--ramp", "0.3")
        self.assertNotEqual(answer["hash_before"], answer["hash_after"])
        self.refused("demo", "edit", project, "Expert", "jaw-events", "--from", "0", "--to", "0.05", code=USAGE,
                     saying="no gripper opens or closes")

    def test_an_entry_keeps_what_is_not_named(self):
        project = self.recorded_project()
        made = self.edit(project, "smooth", "--from", "1", "--to", "2", "--width", "0.3", "--arms", "left")
        self.answer("demo", "stack", project, "Expert", made["id"], "change", "smooth", "--width", "0.1")
        words = self.answer("demo", "stack", project, "Expert")["stack"][0]["words"]
        value = dict(zip(words[1::2], words[2::2]))
        self.assertEqual(value["--width"], "0.1")
        self.assertEqual(value["--from"], "1")
        self.assertEqual(value["--to"], "2")
        self.assertEqual(value["--arms"], "left")

    def test_copies_are_one_step_each_with_its_own_noise(self):
        project = self.recorded_project()
        made = self.answer("demo", "copy", project, "Expert", "--copies", "3", "--perturb-mm", "1", "--seed", "5")["copies"]
        self.assertEqual(len({copy["hash"] for copy in made}), 3)
        self.assertEqual([copy["name"] for copy in made], ["Expert copy", "Expert copy 2", "Expert copy 3"])
        self.assertEqual(self.answer("info", project)["demonstrations"], 4)
        self.answer("undo", project)
        self.assertEqual(self.answer("info", project)["demonstrations"], 1)
        one = self.answer("demo", "copy", project, "Expert", "--perturb-mm", "1", "--seed", "6")["copies"][0]
        self.assertEqual(one["hash"], made[1]["hash"])


class Sentences(CommandLineTest):
    def test_a_time_behind_the_end_is_said_with_the_end(self):
        project = self.recorded_project()
        for words in (("delete", "--from", "99", "--to", "100"), ("move", "--at", "99"), ("smooth", "--from", "99"),
                      ("rotate", "--at", "99")):
            self.refused("demo", "edit", project, "Expert", *words, code=USAGE, saying="there is nothing at 99 s: Expert ends at")

    def test_what_cannot_be_done_says_what_can(self):
        project = self.recorded_project()
        self.refused("demo", "export", project, "Expert", self.folder / "F.txt", code=USAGE, saying="end the file in .csv, .npy or .hdf5")
        self.assertIn("arm", self.refused("demo", "edit", project, "Expert", "snap", "--arms", "both", code=USAGE,
                                          saying="cannot be snapped, so snap the other one alone"))

    def test_the_history_names_where_a_splice_came_from(self):
        project = self.recorded_project()
        self.answer("demo", "copy", project, "Expert", "--name", "Twin")
        made = self.answer("demo", "edit", project, "Twin", "splice", "--source", "Expert", "--clip-from", "1", "--clip-to", "2", "--at", "1")
        self.assertIn("of Expert into Twin", made["description"])

    def test_with_nothing_wrong_there_is_nothing_to_fix(self):
        project = self.recorded_project()
        for _ in range(3):
            if not json.loads(trocar("demo", "check", project, "Expert", "--fix", "all", "--json").stdout)["fixed"]:
                break
        done = trocar("demo", "check", project, "Expert", "--fix", "all")
        self.assertTrue("There is nothing to fix" in done.stdout or "to be mended by hand" in done.stdout, done.stdout)


if __name__ == "__main__":
    unittest.main()
