"""Studies of seeds, contrasts of models and views of several fields on the command line.

Usage: cli_studies_test.py
"""
import csv
import math
import unittest

from cli_support import USAGE, CommandLineTest


def values_of(path):
    with open(path, newline="") as file:
        return [float(row["value"]) if row["value"] else None for row in csv.DictReader(file)]


class Studies(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.project = self.recorded_project()
        for seed in (5, 6, 7):
            self.answer("model", "train", self.project, "Expert", "--method", "eg-maxent", "--episodes", "1000", "--seed",
                        seed, "--name", f"seed {seed}")

    def exported(self, *arguments):
        out = self.folder / "field.csv"
        self.answer("field", "export", self.project, *arguments, "--out", out)
        return values_of(out)

    def test_mean_and_spread_are_those_of_the_models_themselves(self):
        mean, spread = self.folder / "mean.csv", self.folder / "spread.csv"
        self.answer("model", "seeds", self.project, "Expert", "--method", "eg-maxent", "--episodes", "1000", "--seed", "5",
                    "--seeds", "3", "--layer", "value", "--mean", mean, "--spread", spread)
        models = [self.exported(f"seed {seed}", "--layer", "value") for seed in (5, 6, 7)]
        checked = 0
        for at, (centre, width) in enumerate(zip(values_of(mean), values_of(spread))):
            known = [model[at] for model in models if model[at] is not None]
            if len(known) < 2:
                continue
            average = sum(known) / len(known)
            self.assertAlmostEqual(centre, average, delta=1e-9 + 1e-6 * abs(average))
            deviation = math.sqrt(sum((one - average) ** 2 for one in known) / (len(known) - 1))
            self.assertAlmostEqual(width, deviation, delta=1e-6 + 1e-6 * deviation)
            checked += 1
        self.assertGreater(checked, 100)

    def test_a_contrast_is_the_second_model_less_the_first(self):
        a = self.exported("seed 5", "--layer", "reward")
        b = self.exported("seed 6", "--layer", "reward")
        apart = self.exported("seed 5", "--layer", "reward", "--against", "seed 6")
        for first, second, difference in zip(a, b, apart):
            if first is None or second is None:
                self.assertIsNone(difference)
            else:
                self.assertAlmostEqual(difference, second - first, delta=1e-6)
        policy = self.exported("seed 5", "--against", "seed 6", "--show", "policy")
        changed = self.answer("model", "compare", self.project, "seed 5", "seed 6")["policy_changed"]
        self.assertEqual(sum(1 for value in policy if value), changed)

    def test_measures_and_learning_curves_are_files(self):
        measures, curve = self.folder / "measures.csv", self.folder / "curve.csv"
        compared = self.answer("model", "compare", self.project, "seed 5", "A exact", "--out", measures)
        with open(measures, newline="") as file:
            rows = {row["measure"]: row for row in csv.DictReader(file)}
        self.assertEqual(float(rows["mean_margin"]["a"]), compared["mean_margin"]["a"])
        self.assertEqual(int(rows["arrived"]["b"]), compared["success"]["b"])
        self.assertEqual((rows["seed"]["a"], rows["seed"]["b"]), ("5", ""))
        self.answer("model", "curve", self.project, "seed 5", "seed 6", "--out", curve)
        learned = self.answer("model", "epoch", self.project, "seed 6")["curve"]
        with open(curve, newline="") as file:
            drawn = [row for row in csv.DictReader(file) if row["line"] == "seed 6"]
        self.assertEqual([float(row["value"]) for row in drawn], learned)
        self.assertEqual([float(row["epoch"]) for row in drawn], [float(i + 1) for i in range(len(learned))])
        self.answer("model", "curve", self.project, "seed 5", "--preset", "column", "--out", self.folder / "curve.pdf")
        self.assertTrue((self.folder / "curve.pdf").read_bytes().startswith(b"%PDF"))
        spread = self.folder / "spread.png"
        self.answer("model", "seeds", self.project, "Expert", "--method", "eg-maxent", "--episodes", "500", "--seeds", "2",
                    "--spread", spread)
        self.assertTrue(spread.read_bytes().startswith(b"\x89PNG"))

    def test_a_mask_leaves_its_cells_alone(self):
        whole = self.exported("A exact", "--layer", "value")
        safe = self.exported("A exact", "--layer", "safe")
        masked = self.exported("A exact", "--layer", "value", "--mask", "safe")
        self.assertEqual(masked, [value if inside else None for value, inside in zip(whole, safe)])

    def test_what_is_drawn_besides_changes_the_picture_and_what_is_not_known_is_refused(self):
        def picture(*arguments):
            out = self.folder / "view.png"
            self.answer("view", "render", self.project, "Expert", "--size", "320x240", "--samples", "1", "--model",
                        "seed 5", "--layer", "value", *arguments, "--out", out)
            return out.read_bytes()

        pictures = {picture(), picture("--also", "visits,voxels=0.2,opacity=0.5"), picture("--beside", "seed 6"),
                    picture("--mask", "expert")}
        self.assertEqual(len(pictures), 4)
        out = self.folder / "none.png"
        start = ("view", "render", self.project, "Expert", "--model", "seed 5")
        self.refused(*start, "--also", "visits,fog=1", "--out", out, code=USAGE, saying="fog=1")
        self.refused(*start, "--also", "visits,voxels=2", "--out", out, code=USAGE,
                     saying="a share of 0 to 1 after voxels=")
        self.refused(*start, "--mask", "odd", "--out", out, code=USAGE, saying="odd")
        self.assertFalse(out.exists())


if __name__ == "__main__":
    unittest.main()
