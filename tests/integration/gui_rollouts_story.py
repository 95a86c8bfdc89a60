"""The third job of workbench.md: compare rollouts in the window, and put one right that fails.

Usage: gui_rollouts_story.py
"""
import csv
import os
import pathlib
import unittest

from cli_support import DONE, CommandLineTest

TESTS = pathlib.Path(__file__).resolve().parent.parent


def rows_of(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


class Story(CommandLineTest):
    def place(self, row):
        return tuple(int(row[axis]) for axis in "ijk")

    def test_story(self):
        project = self.recorded_project()
        self.answer("model", "train", project, "Expert", "--method", "eg-maxent", "--epsilon", "0.1", "--name", "paper")
        everything = self.answer("rollout", "run", project, "paper", "--starts", "all")
        self.assertEqual(everything["count"], 22**3)
        # One that fails, among the first that the window shows by how they end.
        exact = self.folder / "exact.csv"
        self.answer("rollout", "run", project, "paper", "--starts", "around:3", "--out", exact)
        rows = rows_of(exact)
        ends = ["arrives", "loops", "dead end", "outside the safe set"]
        shown = sorted(rows, key=lambda row: -ends.index(row["end"]))[:24]
        failing = next(row for row in shown if row["end"] == "loops")
        cell = self.place(failing)
        text = (TESTS / "gui" / "J3_compare_rollouts.ui").read_text().replace("FAILING/", "{}, {}, {}/".format(*cell))
        script = self.folder / "story.ui"
        script.write_text(text)
        here = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, here)
        self.answer("ui", "run", "--project", project.name, "--script", script.name, "--size", "1600x1000", code=DONE)
        # The same bytes as the command line's.
        typed = self.folder / "typed.csv"
        self.answer("rollout", "run", project, "paper", "--starts", "around:3", "--epsilon", "0.1", "--runs", "50",
                    "--seed", "1", "--out", typed)
        self.assertEqual((self.folder / "window.csv").read_bytes(), typed.read_bytes())
        # The correction begins in the cell that failed.
        out = self.folder / "corrective.csv"
        self.answer("demo", "export", project, "Corrective 1", out)
        first = rows_of(out)[0]
        origin = (-0.0375, -0.0525, 0.0025)
        for axis, index, low in zip("xyz", cell, origin):
            self.assertAlmostEqual(float(first[f"left_setpoint_{axis}_m"]), low + 0.0025 * (index + 0.5), delta=1e-5)
        for station in ("station_1_pictures", "station_2_both_models", "station_3_chance"):
            self.assertTrue((self.folder / f"{station}.png").exists())


if __name__ == "__main__":
    unittest.main()
