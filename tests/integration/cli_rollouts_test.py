"""Rollouts on the command line: start sets, random errors, why they fail, where two models part, in the simulator."""
import csv
import math
import statistics
import unittest

from cli_support import USAGE, WORLD, CommandLineTest, trocar


def rows_of(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


class RolloutsTest(CommandLineTest):
    def with_paper(self):
        """A project with the exact model and one of the paper's, which fails from many starts."""
        project = self.recorded_project()
        self.answer("model", "train", project, "Expert", "--method", "eg-maxent", "--epsilon", "0.1", "--name", "paper")
        return project

    def test_every_form_of_starts(self):
        project = self.recorded_project()
        for starts, count in (("all", 22**3), ("around:1", 27), ("box:3-4,5,6-8", 6), ("face:z1", 22**2),
                              ("sphere:11,11,11,1", 7), ("gaussian:5,40,1", 40), ("latin:30,2", 30), ("latin:30,2,1", 30), ("cells:0-4,9", 6)):
            out = self.folder / "out.csv"
            answer = self.answer("rollout", "run", project, "A exact", "--starts", starts, "--out", out)
            self.assertEqual(answer["count"], count, starts)
            self.assertEqual(len(rows_of(out)), count)
            # What was written is a start file again.
            again = self.answer("rollout", "run", project, "A exact", "--starts", f"file:{out}")
            self.assertEqual((again["count"], again["arrived"]), (count, answer["arrived"]))
        for starts in ("box:3-2,0,0", "face:q1", "sphere:1,2", "gaussian:0,5,1", "gaussian:5000,5,1", "cells:10648"):
            self.refused("rollout", "run", project, "A exact", "--starts", starts, code=USAGE)

    def test_erring_at_random(self):
        project = self.with_paper()
        words = ("rollout", "run", project, "paper", "--starts", "around:2", "--epsilon", "0.1", "--runs", "50", "--seed", "3")
        one, two = self.folder / "one.csv", self.folder / "two.csv"
        found = self.answer(*words, "--threads", "1", "--out", one)["monte_carlo"]
        self.assertEqual(self.answer(*words, "--threads", "2", "--out", two)["monte_carlo"], found)
        self.assertEqual(one.read_bytes(), two.read_bytes())
        self.assertEqual((found["starts"], found["runs"]), (125, 125 * 50))
        # Wilson's interval, worked out here.
        n, p, z = found["runs"], found["arrived"] / found["runs"], 1.959963984540054
        middle = (p + z * z / (2 * n)) / (1 + z * z / n)
        half = z / (1 + z * z / n) * math.sqrt(p * (1 - p) / n + z * z / (4 * n * n))
        self.assertAlmostEqual(found["share"], p, places=12)
        self.assertAlmostEqual(found["low"], middle - half, places=9)
        self.assertAlmostEqual(found["high"], middle + half, places=9)
        rows = rows_of(one)
        self.assertEqual(sum(int(row["runs_arrived"]) for row in rows), found["arrived"])
        for row in rows:
            self.assertEqual(row["runs"], "50")
            self.assertAlmostEqual(float(row["share"]), int(row["runs_arrived"]) / 50, places=5)
            self.assertLessEqual(float(row["low"]), float(row["share"]) + 1e-6)
            self.assertEqual(row["mean_steps"] == "", row["runs_arrived"] == "0")
        self.assertNotIn("monte_carlo", self.answer("rollout", "run", project, "paper"))
        for wrong in (("--epsilon", "1.5"), ("--epsilon", "0.1", "--runs", "0"), ("--epsilon", "0.1", "--threads", "0")):
            self.refused("rollout", "run", project, "paper", *wrong, code=USAGE)

    def test_the_spread_is_that_of_the_rows(self):
        project = self.with_paper()
        out = self.folder / "out.csv"
        answer = self.answer("rollout", "run", project, "paper", "--starts", "around:3", "--spread", "--out", out)
        rows = rows_of(out)
        steps = sorted(int(row["steps"]) for row in rows if row["end"] == "arrives")
        self.assertEqual(answer["arrivals_by_step"],
                         [sum(1 for one in steps if one <= step) for step in range(steps[-1] + 1)])
        self.assertEqual(answer["arrivals_by_step"][-1], answer["arrived"])
        self.assertEqual(sum(spread["count"] for spread in answer["worst_deviation_mm"].values()), len(rows))
        for end, spread in answer["worst_deviation_mm"].items():
            values = sorted(float(row["max_deviation_mm"]) for row in rows if row["end"] == end)
            self.assertEqual(spread["count"], len(values))
            self.assertAlmostEqual(spread["least"], values[0], delta=1e-4)
            self.assertAlmostEqual(spread["most"], values[-1], delta=1e-4)
            self.assertAlmostEqual(spread["median"], statistics.median(values), delta=1e-4)
        self.assertNotIn("arrivals_by_step", self.answer("rollout", "run", project, "paper", "--starts", "around:3"))

    def test_the_band_is_that_of_the_rows(self):
        project = self.with_paper()
        out, band = self.folder / "out.csv", self.folder / "band.csv"
        self.answer("rollout", "run", project, "paper", "--starts", "around:3", "--out", out, "--band", band)
        steps = [int(row["steps"]) for row in rows_of(out)]
        rows = rows_of(band)
        self.assertEqual([int(row["step"]) for row in rows], list(range(len(rows))))
        for row in rows:
            going_on = sum(1 for one in steps if one >= int(row["step"]))
            self.assertEqual(int(row["n"]), going_on)
            self.assertAlmostEqual(float(row["share"]), going_on / len(steps), places=5)
            values = [float(row[f"{name}_mm"]) for name in ("p05", "p25", "median", "p75", "p95")]
            self.assertEqual(values, sorted(values))
        self.assertLess(sum(1 for one in steps if one >= len(rows)), 5)
        self.refused("rollout", "run", project, "paper", "--starts", "around:3", "--band", self.folder / "band.png",
                     code=USAGE)

    def test_why_it_fails_and_where_two_part(self):
        project = self.with_paper()
        out = self.folder / "out.csv"
        self.answer("rollout", "run", project, "paper", "--starts", "around:3", "--out", out)
        failing = next(row for row in rows_of(out) if row["end"] == "loops")
        cell = ",".join(failing[axis] for axis in "ijk")
        why = self.answer("rollout", "why", project, "paper", cell)
        self.assertEqual(why["end"], "loops")
        self.assertIn(why["where"], why["cycle"])
        self.assertGreaterEqual(len(why["cycle"]), 2)
        for a, b in zip(why["cycle"], why["cycle"][1:] + why["cycle"][:1]):
            self.assertEqual(sum(abs(x - y) for x, y in zip(a, b)), 1)
        self.assertEqual(set(why["q"]), {"+x", "-x", "+y", "-y", "+z", "-z"})
        parting = self.answer("rollout", "diverge", project, "paper", "A exact", cell)
        self.assertEqual((parting["end_a"], parting["end_b"]), ("loops", "arrives"))
        self.assertNotEqual(parting["action_a"], parting["action_b"])
        self.assertLessEqual(parting["step"], int(failing["steps"]))
        self.assertEqual(set(parting["q_a"]), set(parting["q_b"]))
        self.assertIsNone(self.answer("rollout", "diverge", project, "paper", "paper", cell)["step"])
        self.assertIn("lost in", trocar("rollout", "why", project, "paper", cell).stdout)
        ends = self.answer("rollout", "compare", project, "paper", "A exact", "--starts", "around:3")["ends"]
        rows = rows_of(out)
        for end in {row["end"] for row in rows}:
            self.assertEqual(sum(pair["starts"] for pair in ends if pair["a"] == end),
                             sum(1 for row in rows if row["end"] == end))
        for wrong in ("1,2", "a,b,c", "1,2,3,4", "22,0,0", "-1,0,0"):
            self.refused("rollout", "why", project, "paper", wrong, code=USAGE)

    def test_in_the_simulator_stopped_and_taken_up_again(self):
        project = self.recorded_project()
        whole, parts = self.folder / "whole.csv", self.folder / "parts.csv"
        words = ("rollout", "physics", project, "A exact", "--starts", "around:1")
        answer = self.answer(*words, "--threads", "1", "--out", whole)
        self.assertEqual((answer["count"], answer["resumed"], sum(answer["ends"].values())), (27, 0, 27))
        self.assertEqual(len(rows_of(whole)), 27)
        # As if it had been stopped after ten.
        lines = whole.read_text().splitlines(keepends=True)
        parts.write_text("".join(lines[:11]))
        again = self.answer(*words, "--threads", "2", "--out", parts, "--resume")
        self.assertEqual(again["resumed"], 10)
        self.assertEqual(parts.read_bytes(), whole.read_bytes())
        self.refused(*words, "--seed", "2", "--out", parts, "--resume", code=USAGE, saying="another model, seed")
        parts.write_text("no table\n")
        self.refused(*words, "--out", parts, "--resume", code=WORLD)

    def test_a_take_begins_in_a_cell(self):
        project = self.recorded_project()
        script = self.folder / "take.keys"
        script.write_text("0.1 hold D 0.2\n1 end\n")
        take = self.answer("demo", "record", project, "--operator", "keys", "--script", script, "--right", "still",
                           "--from-cell", "10,9,18")
        self.assertEqual(take["name"], "Corrective 1")
        out = self.folder / "take.csv"
        self.answer("demo", "export", project, take["id"], out)
        first = rows_of(out)[0]
        place = (-0.0375 + 10.5 * 0.0025, -0.0525 + 9.5 * 0.0025, 0.0025 + 18.5 * 0.0025)
        for axis, value in zip("xyz", place):
            self.assertAlmostEqual(float(first[f"left_setpoint_{axis}_m"]), value, delta=1e-6)
        self.assertTrue(self.answer("demo", "replay", project, take["id"], "--verify")["verified"])
        for cell in ("22,0,0", "1,2"):
            self.refused("demo", "record", project, "--operator", "keys", "--script", script, "--from-cell", cell, code=USAGE)
        self.refused("demo", "record", project, "--from-cell", "1,2,3", code=USAGE, saying="operator keys")


if __name__ == "__main__":
    unittest.main()
