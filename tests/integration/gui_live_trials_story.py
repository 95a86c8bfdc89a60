"""The fifth job of workbench.md in real time: a person at the keys, and a hand controller that comes to the window over
TCP. Every wait is for something that is seen.

Usage: gui_live_trials_story.py
"""
import os
import pathlib
import socket
import subprocess
import unittest

from cli_support import DONE, TROCAR, CommandLineTest

TESTS = pathlib.Path(__file__).resolve().parent.parent
CONSOLE = str(pathlib.Path(TROCAR).with_name("trocar-console"))


def free_port():
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        return free.getsockname()[1]


class Live(CommandLineTest):
    def started(self, project, name, port=0):
        """The window with that script, running."""
        script = self.folder / f"{name}.ui"
        script.write_text((TESTS / "gui" / f"{name}.ui").read_text().replace("PORT", str(port)))
        running = subprocess.Popen([TROCAR, "ui", "run", "--project", str(project), "--script", str(script), "--size",
                                    "1600x1000"], cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(running.kill)
        return running

    def ended(self, running):
        out, err = running.communicate(timeout=300)
        self.assertEqual(running.returncode, DONE, out + err)

    def events(self, project, name):
        return self.answer("trial", "show", project, name)["events"]

    def test_a_person_lets_go_in_the_middle_and_stops_in_the_clutch(self):
        project = self.recorded_project()
        self.answer("model", "train", project, "Expert", "--segment", "C", "--method", "exact", "--name", "C exact")
        self.ended(self.started(project, "J5_by_hand"))
        trial = self.answer("trial", "list", project)["trials"][0]
        self.assertEqual((trial["operator"], trial["outcome"]), ("person", "aborted"))
        self.assertGreater(trial["path_length_m"], 0.001)
        events = self.events(project, trial["name"])
        states = [(event["text"], event["t_s"]) for event in events if event["kind"] == "state"]
        (up,) = [event["t_s"] for event in events if event["text"] == "agent pedal up"]
        before = [text for text, at_s in states if at_s < up]
        self.assertEqual(before[-1], "agent")
        # In the same tick the arm is the operator's.
        self.assertIn(("operator", up), states)
        self.assertEqual([text for text, _ in states][-2:], ["clutch", "stopped"])
        self.assertTrue(self.answer("trial", "replay", project, trial["name"], "--verify")["verified"])

    def test_a_console_comes_to_the_window_and_falls_silent(self):
        project = self.empty_project()
        port = free_port()
        hand = self.folder / "moves.hand"
        hand.write_text("0.3 move 0.05 0 0 over 0.5\n1.5 clutch down\n3 clutch up\n3.5 end\n")
        window = self.started(project, "J5_by_console", port)
        sent = subprocess.run([CONSOLE, "--connect", f"127.0.0.1:{port}", "--source", "scripted", "--script", str(hand),
                               "--patience", "120"], capture_output=True, text=True, timeout=300)
        self.assertEqual(sent.returncode, DONE, sent.stderr)
        self.ended(window)
        trial = self.answer("trial", "list", project)["trials"][0]
        self.assertEqual((trial["operator"], trial["outcome"], trial["clutches"]), ("scripted", "aborted", 1))
        self.assertGreater(trial["path_length_m"], 0.009)
        self.assertGreater(trial["delay_mean_s"], 0.0)
        self.assertIn("silent for 10 s", (self.folder / "log.json").read_text())
        # Who was silent has moved nothing for ten seconds.
        states = [event for event in self.events(project, trial["name"]) if event["kind"] == "state"]
        self.assertGreater(states[-1]["t_s"], 10.0)
        self.assertTrue(self.answer("trial", "replay", project, trial["name"], "--verify")["verified"])


if __name__ == "__main__":
    unittest.main()
