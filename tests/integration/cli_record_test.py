"""Recording by a script of key presses: the same session that a person drives in the window."""
import unittest

from cli_support import DONE, USAGE, WORLD, CommandLineTest


class RecordByKeysTest(CommandLineTest):
    def script(self, text):
        path = self.folder / "take.keys"
        path.write_text(text)
        return path

    def test_a_take_by_keys_is_recorded_and_verifies(self):
        project = self.empty_project()
        script = self.script("0 tap D\n0.2 tap D\n0.5 tap W\n0.8 tap C\n1.5 end\n")
        take = self.answer("demo", "record", project, "--operator", "keys", "--script", script, "--mode", "step",
                           "--right", "still", "--name", "Keys")
        self.assertAlmostEqual(take["duration_s"], 1.5, delta=0.02)
        self.assertEqual(take["provenance"]["operator"], "scripted")
        self.assertEqual(take["provenance"]["device"], "key script; right arm still")
        self.assertEqual(take["unreachable_samples"], 0)
        self.assertTrue(self.answer("demo", "replay", project, "Keys", "--verify")["verified"])

    def test_one_arm_is_replayed_while_the_other_is_driven(self):
        project = self.recorded_project()
        script = self.script("0 hold I 0.5\n1 end\n")
        take = self.answer("demo", "record", project, "--operator", "keys", "--script", script, "--left", "replay",
                           "--right", "hand", "--replay", "Expert")
        self.assertIn("left arm replay of Expert", take["provenance"]["device"])
        self.assertTrue(self.answer("demo", "replay", project, take["id"], "--verify")["verified"])

    def test_a_part_is_replaced_and_undone(self):
        project = self.recorded_project()
        before = self.answer("demo", "show", project, "Expert")["hash"]
        script = self.script("0 hold W 0.2\n5 end\n")
        take = self.answer("demo", "record", project, "--operator", "keys", "--script", script, "--right", "scripted",
                           "--replay", "Expert", "--from", "1", "--to", "1.5")
        self.assertNotEqual(take["hash"], before)
        self.assertEqual(take["id"], self.answer("demo", "show", project, "Expert")["id"])
        self.answer("undo", project)
        self.assertEqual(self.answer("demo", "show", project, "Expert")["hash"], before)

    def test_what_makes_no_sense_is_refused_and_leaves_the_project(self):
        project = self.empty_project()
        broken = self.script("0 press D\n")
        self.refused("demo", "record", project, "--operator", "keys", "--script", broken, code=USAGE, saying="line 1")
        self.refused("demo", "record", project, "--operator", "keys", code=USAGE, saying="--script")
        self.refused("demo", "record", project, "--script", broken, code=USAGE, saying="operator keys")
        self.refused("demo", "record", project, "--operator", "keys", "--script", self.folder / "none", code=WORLD)
        fine = self.script("0 tap D\n")
        self.refused("demo", "record", project, "--operator", "keys", "--script", fine, "--left", "still", code=USAGE,
                     saying="neither arm")
        self.refused("demo", "record", project, "--operator", "keys", "--script", fine, "--from", "1", code=USAGE)
        self.assertEqual(self.answer("info", project, code=DONE)["demonstrations"], 0)


if __name__ == "__main__":
    unittest.main()
