"""Both modes over six transfers by ten seeds: every trial ends with an outcome, and its replay is the same to the hash.

Usage: long_trials.py
"""
import collections
import unittest

from cli_support import CommandLineTest

BLOCKS, SEEDS = range(6), range(1, 11)


class BothModes(CommandLineTest):
    def test_six_transfers_by_ten_seeds(self):
        project = self.empty_project()
        for block in BLOCKS:
            self.answer("demo", "record", project, "--skill", "expert", "--seed", block + 1, "--block", block, "--goal", block,
                        "--name", f"Expert {block}")
            for segment in "AC":
                self.answer("model", "train", project, f"Expert {block}", "--segment", segment, "--method", "exact", "--name",
                            f"{segment} {block}")
        for mode in ("MT", "SC"):
            outcomes = collections.Counter()
            for seed in SEEDS:
                ran = self.answer("trial", "run", project, "--mode", mode, "--transfers", 6, "--seed", 1000 * seed, "--threads", 2)
                self.assertEqual(len(ran["trials"]), 6)
                for trial in ran["trials"]:
                    outcomes[trial["outcome"]] += 1
                    self.assertTrue(self.answer("trial", "replay", project, trial["id"], "--verify")["verified"], trial)
            print(mode, dict(outcomes), flush=True)
            self.assertEqual(sum(outcomes.values()), 60)
            self.assertTrue(set(outcomes) <= {"success", "dropped", "unfinished"}, outcomes)
        results = self.answer("trial", "results", project)
        print(*(f"{key}: {results[key]}" for key in ("MT", "SC", "paired")), sep="\n", flush=True)


if __name__ == "__main__":
    unittest.main()
