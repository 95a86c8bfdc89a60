"""Trials from the command line: both modes, repeatable to the bit, replayed, judged, and compared."""
import csv
import json
import re
import unittest

from cli_support import DONE, USAGE, CommandLineTest, trocar


class TrialsTest(CommandLineTest):
    """One project for all: its models are those of the demonstration's own block."""

    def project(self):
        project = self.recorded_project()
        self.answer("model", "train", project, "Expert", "--segment", "C", "--method", "exact", "--name", "C exact")
        return project

    def test_both_modes_run_and_replay_and_the_agent_moves_in_one_of_them(self):
        project = self.project()
        for mode in ("MT", "SC"):
            ran = self.answer("trial", "run", project, "--mode", mode, "--operator", "scripted", "--block", "0",
                              "--transfers", "2", "--seed", "3", code=DONE)
            self.assertEqual(len(ran["trials"]), 2)
            for trial in ran["trials"]:
                self.assertIn(trial["outcome"], ("success", "dropped", "unfinished"))
                self.assertEqual(trial["operator"], "scripted")
                self.assertEqual(set(trial["segments_s"]), set("ABCDE"))
                self.assertEqual(trial["agent_share"] > 0.0, mode == "SC")
                replayed = self.answer("trial", "replay", project, str(trial["id"]), "--verify", code=DONE)
                self.assertTrue(replayed["verified"])
        listed = self.answer("trial", "list", project)["trials"]
        self.assertEqual([trial["name"] for trial in listed], ["MT 1", "MT 2", "SC 1", "SC 2"])
        self.assertEqual(self.answer("info", project)["trials"], 4)
        shown = self.answer("trial", "show", project, "SC 1")
        self.assertEqual([model["segment"] for model in shown["models"]], ["A", "C"])
        kinds = {event["kind"] for event in shown["events"]}
        self.assertLessEqual({"pedal", "state", "agent", "segment", "outcome", "guard"}, kinds)
        # A release is in the record at the tick at which the arm is the operator's, or the agent had ended before.
        events = shown["events"]
        begins = [e["t_s"] for e in events if e["kind"] == "agent" and e["text"].startswith("begins")]
        ends = [e["t_s"] for e in events if e["kind"] == "state" and e["text"] == "operator"]
        releases = [e["t_s"] for e in events if e["text"] == "agent pedal up"]
        for begin in begins:
            end = min(t for t in ends if t > begin)
            release = min(t for t in releases if t > begin)
            self.assertLessEqual(end, release)

    def test_the_same_seed_gives_the_same_trial_on_any_number_of_threads(self):
        hashes = []
        for threads in ("1", "2"):
            project = self.project()
            self.answer("trial", "run", project, "--mode", "SC", "--block", "0", "--transfers", "2", "--seed", "5",
                        "--threads", threads)
            hashes.append([self.answer("trial", "show", project, name)["hash"] for name in ("SC 1", "SC 2")])
        self.assertEqual(hashes[0], hashes[1])
        self.assertNotEqual(hashes[0][0], hashes[0][1])

    def test_a_model_serves_the_block_that_it_was_learned_at(self):
        project = self.project()
        ran = self.answer("trial", "run", project, "--mode", "SC", "--transfers", "2", "--seed", "3")["trials"]
        begun = []
        for trial in ran:
            events = self.answer("trial", "show", project, str(trial["id"]))["events"]
            begun.append([event["text"] for event in events if event["text"].startswith("begins")])
        self.assertEqual(begun[0], ["begins: A exact", "begins: C exact"])
        # On the board the model of block 0 would lead to block 0: block 1 is the operator's in A.
        self.assertNotIn("begins: A exact", begun[1])

    def test_familiarisation_is_run_and_does_not_count(self):
        project = self.project()
        protocol = self.folder / "short.json"
        protocol.write_text("""{"name": "Short", "fixed": 1, "blocks": [
            {"name": "try it", "mode": "MT", "counts": false, "transfers": 1},
            {"name": "manual", "mode": "MT", "transfers": 1}, {"name": "shared", "mode": "SC", "transfers": 1}]}""")
        ran = self.answer("trial", "run", project, "--protocol", protocol, "--block", "0")["trials"]
        self.assertEqual(sorted(trial["mode"] for trial in ran), ["MT", "MT", "SC"])
        self.assertEqual({trial["subject"] for trial in ran}, {"S1"})
        results = self.answer("trial", "results", project)
        self.assertEqual((results["MT"]["trials"], results["SC"]["trials"], results["paired"]["pairs"]), (1, 1, 1))
        self.refused("trial", "run", project, "--protocol", protocol, "--delay-ms", "20", code=USAGE, saying="delay")

    def test_results_are_tidy_say_scripted_and_leave_out_what_was_excluded(self):
        project = self.project()
        for mode in ("MT", "SC"):
            self.answer("trial", "run", project, "--mode", mode, "--block", "0", "--transfers", "3", "--session", "one")
        rows, segments, page = (self.folder / name for name in ("trials.csv", "segments.csv", "report.html"))
        results = self.answer("trial", "results", project, "--trials", rows, "--segments", segments, "--report", page)
        self.assertTrue(results["scripted"])
        self.assertEqual(results["MT"]["trials"], 3)
        self.assertEqual(results["paired"]["pairs"], 3)
        with open(rows, encoding="utf-8") as file:
            table = list(csv.DictReader(file))
        self.assertEqual(len(table), 6)
        self.assertEqual({(row["operator"], row["assistant"]) for row in table}, {("scripted", "scripted")})
        times = {mode: [float(row["completion_s"]) for row in table if row["mode"] == mode] for mode in ("MT", "SC")}
        self.assertAlmostEqual(results["MT"]["mean_s"], sum(times["MT"]) / 3, places=4)
        differences = [a - b for a, b in zip(times["MT"], times["SC"])]
        self.assertAlmostEqual(results["paired"]["mean_s"], sum(differences) / 3, places=4)
        with open(segments, encoding="utf-8") as file:
            by_segment = list(csv.DictReader(file))
        self.assertEqual(len(by_segment), 6 * 5)
        self.assertIn("no person took part", page.read_text(encoding="utf-8"))

        for name in ("bars.png", "bars.svg", "bars.pdf"):
            self.answer("trial", "results", project, "--figure", self.folder / name, "--preset", "column")
            self.assertGreater((self.folder / name).stat().st_size, 2_000)
        self.answer("trial", "judge", project, "SC 1", "--exclude", "the cat stood on the pedal")
        left = self.answer("trial", "results", project)
        self.assertEqual((left["SC"]["trials"], left["paired"]["pairs"]), (2, 2))
        self.answer("undo", project)
        self.assertEqual(self.answer("trial", "results", project)["SC"]["trials"], 3)
        self.refused("trial", "judge", project, "SC 1", code=USAGE, saying="--exclude")

    def test_each_participant_is_a_row_and_a_panel_and_one_value(self):
        project = self.recorded_project()
        for subject, seed in (("S1", 1), ("S2", 11), ("S3", 21)):
            for mode in ("MT", "SC"):
                self.answer("trial", "run", project, "--mode", mode, "--seed", seed, "--subject", subject, "--block", "0")
        rows, figure = self.folder / "p.csv", self.folder / "f.svg"
        answer = self.answer("trial", "results", project, "--participants", rows, "--figure", figure)
        self.assertEqual([each["name"] for each in answer["participants"]], [f"{s} (scripted expert)" for s in ("S1", "S2", "S3")])
        means = [each["MT"]["mean_s"] - each["SC"]["mean_s"] for each in answer["participants"]]
        self.assertEqual(answer["by_participant"]["pairs"], 3)
        self.assertAlmostEqual(answer["by_participant"]["mean_s"], sum(means) / 3, places=9)
        with open(rows, newline="") as file:
            table = list(csv.DictReader(file))
        self.assertEqual([(row["participant"], row["operator"], row["mode"]) for row in table],
                         [(f"{s} (scripted expert)", "scripted", m) for s in ("S1", "S2", "S3") for m in ("MT", "SC")])
        for row, each in zip(table[::2], answer["participants"]):
            self.assertAlmostEqual(float(row["completion_mean_s"]), each["MT"]["mean_s"], delta=1e-3)
        alone = self.folder / "one.svg"
        for trial in self.answer("trial", "list", project)["trials"]:
            if trial["subject"] != "S1":
                self.answer("trial", "judge", project, trial["id"], "--exclude", "not now")
        self.answer("trial", "results", project, "--figure", alone)
        self.assertLess(len(alone.read_text()), len(figure.read_text()))

    def test_a_delay_is_applied_and_told(self):
        project = self.project()
        ran = self.answer("trial", "run", project, "--mode", "MT", "--block", "0", "--delay-ms", "ar1:60:10")
        self.assertAlmostEqual(ran["trials"][0]["delay_mean_s"], 0.06, delta=0.02)
        self.assertGreater(ran["trials"][0]["delay_worst_s"], ran["trials"][0]["delay_mean_s"])
        self.assertEqual(self.answer("trial", "show", project, "MT 1")["delay"], "ar1:60:10")

    def test_the_tool_begins_in_the_cell_of_a_rollout(self):
        project = self.recorded_project()
        ran = self.answer("trial", "run", project, "--mode", "SC", "--block", "0", "--from-cell", "4,5,18")["trials"][0]
        self.assertEqual(ran["outcome"], "success")
        shown = self.answer("trial", "show", project, ran["id"])["begin_m"]
        below = self.answer("trial", "run", project, "--mode", "MT", "--block", "0", "--from-cell", "4,5,17")["trials"][0]
        # A cell is 2.5 mm.
        for a, b, apart in zip(shown, below["begin_m"], (0.0, 0.0, 0.0025)):
            self.assertAlmostEqual(a - b, apart, delta=1e-9)
        self.assertTrue(self.answer("trial", "replay", project, ran["id"], "--verify")["verified"])
        rows = self.folder / "rows.csv"
        self.answer("trial", "results", project, "--trials", rows)
        with open(rows, newline="", encoding="utf-8") as file:
            row = next(csv.DictReader(file))
        self.assertAlmostEqual(float(row["begin_z_m"]), shown[2], delta=1e-6)
        self.refused("trial", "run", project, "--mode", "MT", "--from-cell", "22,0,0", code=USAGE, saying="no cell")

    def test_shared_control_without_an_agent_is_told(self):
        project = self.project()
        for block, idle in ((1, True), (0, False)):
            ran = trocar("trial", "run", project, "--mode", "SC", "--block", block, "--seed", 42, "--json")
            self.assertEqual(ran.returncode, DONE)
            (trial,) = json.loads(ran.stdout)["trials"]
            self.assertEqual(trial["agent_share"] == 0.0, idle)
            told = f"the agent moved nothing in {trial['name']}: no model of A serves block {block}"
            self.assertEqual(told in ran.stderr, idle, ran.stderr)

    def test_blocks_that_no_model_serves_are_named_before_anything_runs(self):
        project = self.recorded_project()
        self.refused("trial", "run", project, "--mode", "SC", "--transfers", "3", code=USAGE, saying="serves block 1")
        self.assertEqual(self.answer("info", project)["trials"], 0)

    def test_what_makes_no_sense_is_refused_before_anything_runs(self):
        project = self.recorded_project()
        self.refused("trial", "run", project, "--protocol", "sim", "--transfers", "3", code=USAGE, saying="--transfers")
        self.refused("trial", "run", project, "--mode", "XX", code=USAGE, saying="--mode")
        self.refused("trial", "run", project, "--mode", "MT", "--delay-ms", "soon", code=USAGE, saying="a delay is")
        self.refused("trial", "run", project, "--mode", "SC", "--model-c", "A exact", code=USAGE, saying="segment A")
        self.refused("trial", "replay", project, "MT 1", code=USAGE, saying="no trial")
        self.refused("trial", "results", project, code=USAGE, saying="no trial")
        self.assertEqual(self.answer("info", project)["trials"], 0)

    def test_a_trial_is_seen_and_filmed_as_a_demonstration_is(self):
        project = self.project()
        self.answer("trial", "run", project, "--mode", "SC", "--block", "0")
        picture = self.folder / "view.png"
        self.answer("view", "render", project, "SC 1", "--size", "320x180", "--out", picture)
        self.assertGreater(picture.stat().st_size, 3000)
        listed = self.answer("history", project)
        self.assertTrue(re.search("Add trial SC 1", str(listed)))


if __name__ == "__main__":
    unittest.main()
