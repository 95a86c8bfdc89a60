"""The library from the command line: rows, filters, marks, batches, trash, checkpoints, what replays found."""
import json
import unittest

from cli_support import DONE, USAGE, CommandLineTest, trocar

try:
    import h5py
except ImportError:
    h5py = None


class LibraryTest(CommandLineTest):
    def three(self):
        """The recorded project with two copies of its demonstration, one of them shorter; their ids."""
        project = self.recorded_project()
        ids = [1] + [self.answer("demo", "copy", project, 1, "--name", name)["copies"][0]["id"] for name in ("Twin", "Short")]
        self.answer("demo", "edit", project, "Short", "trim", "--from", 1, "--to", 4)
        return project, ids

    def batch(self, project, *arguments):
        """Words after -- are the act's, so that --json comes first."""
        done = trocar("demo", "batch", project, "--json", *arguments)
        self.assertEqual(done.returncode, DONE, done.stderr)
        return json.loads(done.stdout)

    def names(self, *arguments):
        return [one["name"] for one in self.answer("demo", "list", *arguments)["demonstrations"]]

    def test_a_list_is_filtered_and_sorted_and_says_the_measures_when_they_are_asked_for(self):
        project, _ = self.three()
        self.assertEqual(self.names(project), ["Expert", "Twin", "Short"])
        self.assertEqual(self.names(project, "--filter", "duplicate"), ["Expert", "Twin"])
        self.assertEqual(self.names(project, "--filter", "length<3.5"), ["Short"])
        self.assertEqual(self.names(project, "--sort", "length"), ["Short", "Expert", "Twin"])
        self.assertEqual(self.names(project, "--filter", "clearance<1000 and not duplicate"), ["Short"])
        row = self.answer("demo", "list", project)["demonstrations"][0]
        self.assertNotIn("idle_share", row)
        self.assertEqual(row["models"], ["A exact"])
        self.assertFalse(row["models_stale"])
        row = self.answer("demo", "list", project, "--measures")["demonstrations"][0]
        for key in ("path_lengths_m", "mean_smoothed_jerk_m_s3", "peak_smoothed_jerk_m_s3", "idle_share", "clearance_m", "grid_error_m"):
            self.assertIn(key, row)
        # A steady hand: the tremor of 0.1 mm at 10 Hz alone would be 16 m/s³ in the mean.
        self.assertLess(row["mean_smoothed_jerk_m_s3"], 5.0)

    def test_a_wrong_filter_or_column_is_refused_in_one_sentence(self):
        project = self.recorded_project()
        self.refused("demo", "list", project, "--filter", "length>", code=USAGE, saying="nothing follows length>")
        self.refused("demo", "list", project, "--filter", "lenght>3", code=USAGE, saying="there is no column")
        self.refused("demo", "list", project, "--sort", "jrk", code=USAGE, saying="did you mean jerk")
        self.refused("demo", "list", project, "--saved", "none", code=USAGE, saying="no filter none")
        self.refused("demo", "tag", project, 1, code=USAGE, saying="say what to mark")
        self.refused("demo", "tag", project, 1, "--flag", "ugly", code=USAGE, saying="good, bad or unsure")
        self.refused("demo", "tag", project, 1, "--add", "two words", code=USAGE, saying="one word")
        self.refused("demo", "batch", project, "flag", "bad", code=USAGE, saying="--filter")
        self.refused("demo", "batch", project, "--filter", "x", "melt", code=USAGE, saying="melt")

    def test_a_batch_of_bridges_by_policy_finds_its_way_as_a_single_one_does(self):
        project = self.recorded_project()
        words = ("bridge", "--from", 1.0, "--to", 3.0, "--arms", "left", "--shape", "policy")
        single = trocar("demo", "edit", project, "Expert", *words, "--model", "A exact")
        self.assertEqual(single.returncode, DONE, single.stderr)
        alone = self.answer("demo", "show", project, "Expert")["hash"]
        self.answer("undo", project)
        for model in ((), ("--model", "A exact"), ("--model=2",)):
            with self.subTest(model):
                done = self.batch(project, "--demo", "Expert", "--", *words, *model)
                self.assertEqual(done["changed"], 1, done)
                self.assertEqual(self.answer("demo", "show", project, "Expert")["hash"], alone)
                self.answer("undo", project)
        self.refused("demo", "batch", project, "--demo", "Expert", "--", *words, "--model", "B exact", code=USAGE, saying="B exact")

    def test_marks_stay_and_undo_takes_them_back(self):
        project = self.recorded_project()
        before = self.answer("info", project)["hash"]
        answer = self.answer("demo", "tag", project, 1, "--add", "slow", "--add", "first", "--flag", "bad", "--rating", 2)
        self.assertEqual((answer["tags"], answer["flag"], answer["rating"]), (["first", "slow"], "bad", 2))
        self.assertEqual(self.names(project, "--filter", "tag:slow and flag:bad and rating<3"), ["Expert"])
        self.answer("demo", "tag", project, 1, "--remove", "slow", "--flag", "none")
        self.assertEqual(self.names(project, "--filter", "tag:slow or flag:bad"), [])
        self.answer("undo", project)
        self.answer("undo", project)
        self.assertEqual(self.answer("info", project)["hash"], before)

    def test_a_batch_says_what_it_would_do_does_it_in_one_step_and_is_undone_in_one(self):
        project, ids = self.three()
        before = self.answer("info", project)
        would = self.batch(project, "--filter", "name:t", "--dry-run", "--", "trim", "--from", 1, "--to", 4)
        self.assertEqual(would["changed"], 2)
        self.assertEqual(self.answer("info", project)["hash"], before["hash"])
        done = self.batch(project, "--filter", "name:t", "--", "trim", "--from", 1, "--to", 4)
        self.assertEqual(done["changed"], 2)
        self.assertIn("changes nothing", done["demonstrations"][2]["problem"])
        self.assertEqual(self.answer("info", project)["edits"], before["edits"] + 1)
        self.assertEqual(self.answer("undo", project)["description"], "Trim --from 1 --to 4: 2 demonstrations")
        self.assertEqual(self.answer("info", project)["hash"], before["hash"])
        self.answer("demo", "batch", project, "--demo", ids[1], "--demo", "Short", "remove")
        self.assertEqual(self.names(project), ["Expert"])

    def test_what_is_removed_is_in_the_trash_and_comes_back(self):
        project, ids = self.three()
        before = self.answer("info", project)["hash"]
        self.answer("demo", "remove", project, "Twin")
        self.assertEqual([one["id"] for one in self.answer("demo", "trash", project)["trash"]], [ids[1]])
        self.refused("demo", "restore", project, "Expert", code=USAGE, saying="trash")
        self.answer("demo", "restore", project, "Twin")
        self.assertEqual(self.answer("info", project)["hash"], before)
        self.assertEqual(self.answer("demo", "trash", project)["trash"], [])

    @unittest.skipUnless(h5py, "needs h5py")
    def test_saved_filters_are_masks_of_an_export(self):
        project, _ = self.three()
        self.answer("demo", "filter", project, "twins", "duplicate")
        self.assertEqual(self.answer("demo", "filter", project)["filters"], {"twins": "duplicate"})
        self.assertEqual(self.names(project, "--saved", "twins"), ["Expert", "Twin"])
        out = self.folder / "out.hdf5"
        self.answer("demo", "export", project, "Short", "Twin", "Expert", out)
        with h5py.File(out) as file:
            self.assertEqual([name.decode() for name in file["mask/twins"][:]], ["demo_1", "demo_2"])
        self.answer("demo", "filter", project, "twins", "--remove")
        self.refused("demo", "filter", project, "twins", "length>", code=USAGE, saying="nothing follows")

    def test_a_checkpoint_is_a_name_that_stays(self):
        project, _ = self.three()
        self.answer("history", project, "--checkpoint", "Three of them")
        self.answer("history", project, "--checkpoint", "First", "--at", 1)
        self.answer("undo", project)
        names = {node["id"]: node["checkpoint"] for node in self.answer("history", project)["history"]}
        self.assertEqual([name for name in names.values() if name], ["First", "Three of them"])
        self.assertIn("[First]", trocar("history", project).stdout)
        self.refused("history", project, "--checkpoint", "x", "--at", 99, code=USAGE, saying="no point 99")
        self.refused("history", project, "--at", 1, code=USAGE, saying="--checkpoint")

    def test_what_a_replay_found_is_known_afterwards(self):
        project = self.recorded_project()
        self.assertEqual(self.names(project, "--filter", "replay:unknown"), ["Expert"])
        self.answer("demo", "replay", project, 1, "--verify", code=DONE)
        self.assertEqual(self.names(project, "--filter", "replay:verified"), ["Expert"])
        self.answer("undo", project)
        self.answer("redo", project)
        self.assertEqual(self.answer("demo", "list", project)["demonstrations"][0]["replay"], "verified")


if __name__ == "__main__":
    unittest.main()
