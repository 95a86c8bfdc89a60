"""The fifth job of workbench.md: trials by both modes in the window, stopped, replayed, judged and compared.

Usage: gui_trials_story.py
"""
import csv
import json
import unittest

from cli_support import DONE, CommandLineTest


class Story(CommandLineTest):
    def test_story(self):
        project = self.recorded_project()
        self.answer("model", "train", project, "Expert", "--segment", "C", "--method", "exact", "--name", "C exact")
        # The same order for everybody; the agent has an arm to be stopped with in the first block.
        (self.folder / "short.json").write_text(json.dumps({"name": "Short", "fixed": 2, "transfer_s": 60, "blocks": [
            {"name": "Try it", "mode": "SC", "counts": False, "transfers": 2, "rest_s": 600},
            {"name": "Manual", "mode": "MT", "transfers": 1}]}))
        self.play("J5_trials.ui", project)
        self.check_trials(project)
        self.check_release(project)
        self.check_results(project)

    def check_trials(self, project):
        trials = {trial["name"]: trial for trial in self.answer("trial", "list", project)["trials"]}
        self.assertEqual(set(trials), {"MT 1", "SC 1", "MT 2", "MT 3", "SC 2", "SC 3", "MT 4"})
        self.assertEqual(trials["MT 1"]["outcome"], "success")
        self.assertEqual(trials["SC 1"]["outcome"], "success")
        self.assertFalse(trials["SC 1"]["excluded"])
        # Stopped by Esc, and ended in the middle: both are kept as what they are.
        self.assertEqual(trials["MT 2"]["outcome"], "aborted")
        self.assertEqual(trials["MT 3"]["outcome"], "aborted")
        stopped = self.answer("trial", "show", project, "MT 2")["events"]
        self.assertIn(("incident", "incident"), [(event["kind"], event["text"]) for event in stopped])
        self.assertIn(("state", "stopped"), [(event["kind"], event["text"]) for event in stopped])
        # Of the protocol: stopped while the agent had the arm, stopped in E, and one to its end.
        self.assertEqual((trials["SC 2"]["outcome"], trials["SC 3"]["outcome"]), ("aborted", "success"))
        self.assertEqual((trials["MT 4"]["outcome"], trials["MT 4"]["placed"]), ("success", True))
        states = [e["text"] for e in self.answer("trial", "show", project, "SC 2")["events"] if e["kind"] == "state"]
        self.assertEqual(states[-2:], ["agent", "stopped"])
        for name in trials:
            self.assertTrue(self.answer("trial", "replay", project, name, "--verify", code=DONE)["verified"], name)
        # What the window ran is to the bit what the command line runs.
        for name, mode in (("MT 1", "MT"), ("SC 1", "SC")):
            again = self.answer("trial", "run", project, "--mode", mode, "--block", "0", "--seed", "3")["trials"][0]
            hashes = [self.answer("trial", "show", project, str(trial))["hash"] for trial in (name, again["id"])]
            self.assertEqual(*hashes)
            self.answer("undo", project)

    def check_release(self, project):
        """The arm is the operator's within one period of the release, or had been since the agent's segment ended. Of a
        release in the middle of the agent's way tell gui_live_trials_story and cli_link_test."""
        events = self.answer("trial", "show", project, "SC 1")["events"]
        begins = [event["t_s"] for event in events if event["text"].startswith("begins")]
        self.assertEqual(len(begins), 2)
        for begin in begins:
            operator = min(e["t_s"] for e in events if e["text"] == "operator" and e["t_s"] > begin)
            release = min(e["t_s"] for e in events if e["text"] == "agent pedal up" and e["t_s"] > begin)
            self.assertLessEqual(operator, release + 0.001)

    def check_results(self, project):
        rows = self.folder / "command.csv"
        page = self.folder / "command.html"
        results = self.answer("trial", "results", project, "--trials", rows, "--report", page)
        self.assertEqual((self.folder / "rows.csv").read_bytes(), rows.read_bytes())
        self.assertEqual((self.folder / "report.html").read_bytes(), page.read_bytes())
        report = page.read_text()
        for test in ("Shapiro-Wilk", "Paired t", "Wilcoxon signed rank", "McNemar", "no person took part"):
            self.assertIn(test, report)
        with open(rows, newline="") as file:
            self.assertEqual({row["operator"] for row in csv.DictReader(file)}, {"scripted"})
        # What was stopped tells nothing of the mode.
        self.assertEqual((results["MT"]["trials"], results["SC"]["trials"], results["paired"]["pairs"]), (2, 1, 1))
        shown = {item["path"]: item["value"] for item in json.loads((self.folder / "results.json").read_text())}
        self.assertEqual(shown["Trials/Results/MT Completion, mean"], f"{results['MT']['mean_s']:.2f} s")
        self.assertEqual(shown["Trials/Results/SC Completion, mean"], f"{results['SC']['mean_s']:.2f} s")


if __name__ == "__main__":
    unittest.main()
