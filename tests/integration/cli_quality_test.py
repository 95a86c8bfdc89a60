"""What the exact method must reach on every demonstration that is shipped and on ten seeded others (METHODS.md).

Usage: cli_quality_test.py
"""
import unittest

from cli_support import CommandLineTest

# Seed, block, goal peg: the tour's three, and ten more that use every block and several pegs.
SHIPPED = [(1, 0, 0), (2, 3, 2), (3, 5, 4)]
OTHERS = [(seed, (5 * seed + 1) % 6, (3 * seed + 2) % 6) for seed in range(11, 21)]


class Quality(CommandLineTest):
    def test_arrival_and_the_approach_from_above(self):
        project = self.empty_project()
        for seed, block, goal in SHIPPED + OTHERS:
            with self.subTest(seed=seed, block=block, goal=goal):
                name = f"Expert {seed}"
                self.answer("demo", "record", project, "--seed", seed, "--block", block, "--goal", goal, "--name", name)
                for segment in "AC":
                    model = f"{seed} {segment}"
                    self.answer("model", "train", project, name, "--segment", segment, "--method", "exact", "--name",
                                model)
                    everywhere = self.answer("rollout", "run", project, model, "--starts", "all")
                    self.assertEqual((everywhere["count"], everywhere["arrived"]), (22**3, 22**3))
                near = self.answer("rollout", "run", project, f"{seed} A")["around"]
                above = {row["k"]: row["from_above"] / row["count"] for row in near}
                self.assertGreaterEqual(above[3], 0.95)
                self.assertGreaterEqual(above[5], 0.90)


if __name__ == "__main__":
    unittest.main()
