"""The second job of workbench.md: inspect reward and value in the window, compare two models, and export a figure.

Usage: gui_heatmaps_story.py
"""
import csv
import json
import re
import struct
import unittest

from cli_support import TESTS, CommandLineTest

SEEDS = 10  # As many as the panel studies at first.


def rows_of(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def items_of(path):
    """Value by path of what was on screen."""
    return {item["path"]: item["value"] for item in json.loads(path.read_text())}


def shown(value):
    """A number as the window writes it."""
    return f"{value:.3g}".replace("-", "\N{MINUS SIGN}") if value else "0"


def pixels_per_metre(png):
    """What the pHYs chunk says, and the width in pixels."""
    width = struct.unpack(">I", png[16:20])[0]
    at = png.index(b"pHYs") + 4
    return width, struct.unpack(">I", png[at:at + 4])[0]


class Story(CommandLineTest):
    def test_story(self):
        project = self.recorded_project()
        for name, epsilon in (("greedy", "0"), ("exploring", "0.1")):
            self.answer("model", "train", project, "Expert", "--method", "eg-maxent", "--epsilon", epsilon, "--seed", "1",
                        "--name", name)
        compared = self.answer("model", "compare", project, "exploring", "greedy")
        expert = self.folder / "expert.csv"
        self.answer("field", "export", project, "exploring", "--layer", "steps", "--out", expert)
        goal = next(row for row in rows_of(expert) if row["value"] == "0")
        text = (TESTS / "gui" / "J2_inspect_heatmaps.ui").read_text()
        for name, axis in (("GOAL_X", "i"), ("GOAL_Y", "j"), ("GOAL_Z", "k")):
            text = text.replace(name, goal[axis])
        text = text.replace("CHANGED", f"{compared['policy_changed']:,}")
        self.play("J2_inspect_heatmaps.ui", project, text)
        self.check_probe(project, goal)
        self.check_measures(compared)
        self.check_seeds(project)
        self.check_files(project)

    def check_probe(self, project, goal):
        """Each number of the probe is the command line's, at the goal and elsewhere."""
        learned = 0
        for station in ("goal", "cell"):
            probe = items_of(self.folder / f"station_1_{station}.json")
            heading = next(path for path in probe if path.startswith("Fields/Probe/Cell "))
            cell = dict(zip("ijk", heading.removeprefix("Fields/Probe/Cell ").split(", ")))
            if station == "goal":
                self.assertEqual(cell, {axis: goal[axis] for axis in "ijk"})
            for layer, row in (("reward", "Reward θ"), ("value", "Value V"), ("q+x", "Q +x"), ("q-z", "Q −z")):
                out = self.folder / "probed.csv"
                self.answer("field", "export", project, "exploring", "--layer", layer, "--out", out)
                known = next(one for one in rows_of(out) if all(one[axis] == cell[axis] for axis in "ijk"))["value"]
                wanted = shown(float(known)) if known else "unknown"
                self.assertEqual(probe["Fields/Probe/" + row].split(" ")[-1], wanted, layer)
                learned += 1 if known and float(known) != 0.0 else 0
        self.assertGreaterEqual(learned, 2)

    def check_measures(self, compared):
        """So is each of the table of two models."""
        table = items_of(self.folder / "station_4_measures.json")
        for row, key in (("Fully explored", "fully_explored"), ("Not explored", "fully_unexplored")):
            a, b, _ = table["Models/Measures/" + row].split(" | ")
            self.assertEqual((a, b), (f"{compared[key]['a']:,}", f"{compared[key]['b']:,}"))
        for row, key in (("Mean reward θ", "mean_reward"), ("Mean margin", "mean_margin"), ("Mismatch", "mismatch")):
            a, b, _ = table["Models/Measures/" + row].split(" | ")
            self.assertEqual((a, b), (shown(compared[key]["a"]), shown(compared[key]["b"])))

    def check_seeds(self, project):
        """And of the seeds, and what they say of section V.A."""
        items = items_of(self.folder / "station_5_seeds.json")
        options = ["--method", "eg-maxent", "--epsilon", "0.1", "--seed", "1", "--seeds", SEEDS]
        seeds = self.answer("model", "seeds", project, "Expert", *options)["seeds"]
        for row in seeds:
            words = items[f"Models/Seeds/{row['seed']}"].split(" | ")
            self.assertEqual(words[0], f"{row['fully_explored']:,}")
            self.assertEqual(words[1], f"{row['fully_unexplored']:,}")
            self.assertEqual(words[3], shown(row["mismatch"]))
        findings = self.answer("model", "explore", project, "Expert", *options)["findings"]
        self.assertEqual([items[f"Models/Findings/{i + 1}"] for i in range(len(findings))], findings)

    def check_files(self, project):
        """Figure, drawing and numbers are the command line's to the byte, and as wide as a column."""
        for ending, print_options in ((".png", ["--preset", "column", "--dpi", "300"]), (".svg", ["--preset", "column"]),
                                      (".csv", [])):
            typed = self.folder / ("typed" + ending)
            self.answer("field", "export", project, "exploring", "--layer", "value", "--against", "greedy", "--show",
                        "difference", *print_options, "--out", typed)
            self.assertEqual((self.folder / ("window" + ending)).read_bytes(), typed.read_bytes(), ending)
        width, density = pixels_per_metre((self.folder / "window.png").read_bytes())
        self.assertAlmostEqual(1000.0 * width / density, 88.0, delta=0.1)
        svg = (self.folder / "window.svg").read_text()
        self.assertAlmostEqual(float(re.search(r'width="([0-9.]+)pt"', svg).group(1)) * 25.4 / 72.0, 88.0, delta=0.01)


if __name__ == "__main__":
    unittest.main()
