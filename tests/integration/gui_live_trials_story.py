"""The fifth job of workbench.md in real time: a person at the keys, and hand controllers that come to the window over
TCP. Every wait is for something that is seen.

Usage: gui_live_trials_story.py
"""
import json
import pathlib
import signal
import socket
import subprocess
import time
import unittest

from cli_support import DONE, TESTS, TROCAR, CommandLineTest

CONSOLE = str(pathlib.Path(TROCAR).with_name("trocar-console"))
PATIENCE_S = 300
# From the hold to the stop, in the trial's time: the window's 10 s, less what a busy machine's 1 kHz loop gives up (a
# quarter was seen), more what its window takes for a frame.
SILENT_S = (4.0, 30.0)


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
        out, err = running.communicate(timeout=PATIENCE_S)
        self.assertEqual(running.returncode, DONE, out + err)

    def dumped(self, running, name):
        """The script has come to where it writes that file."""
        deadline = time.monotonic() + PATIENCE_S
        while not (self.folder / name).exists():
            if running.poll() is not None:
                self.fail("".join(running.communicate()))
            self.assertLess(time.monotonic(), deadline, f"the script did not come to {name}")
            time.sleep(0.05)

    def console(self, port, *arguments):
        sending = subprocess.Popen([CONSOLE, "--connect", f"127.0.0.1:{port}", "--patience", "120", "--json",
                                    *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        for cleanup in (sending.stdout.close, sending.stderr.close, sending.wait, sending.kill):
            self.addCleanup(cleanup)
        return sending

    def scripted(self, port, text, *arguments):
        script = self.folder / "moves.hand"
        script.write_text(text)
        return self.console(port, "--source", "scripted", "--script", script, *arguments)

    def played(self, sending):
        """The console has sent all and was heard."""
        out, err = sending.communicate(timeout=PATIENCE_S)
        self.assertEqual(sending.returncode, DONE, err)
        self.assertGreater(json.loads(out)["answered"], 0)

    def events(self, project, name):
        return self.answer("trial", "show", project, name)["events"]

    def states(self, project, name):
        return [(event["text"], event["t_s"]) for event in self.events(project, name) if event["kind"] == "state"]

    def check_ended_by_silence(self, states):
        """The arm was held as soon as nothing was heard, and ten seconds later the transfer was stopped."""
        self.assertEqual([text for text, _ in states][-2:], ["hold", "stopped"])
        silent_s = states[-1][1] - states[-2][1]
        self.assertGreater(silent_s, SILENT_S[0])
        self.assertLess(silent_s, SILENT_S[1])
        log = [item["path"] for item in json.loads((self.folder / "log.json").read_text())]
        self.assertEqual(sum("silent for 10 s" in path for path in log), 1, log)

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
        # On its way: it had not arrived, and was not at rest.
        self.assertEqual([event["text"] for event in events if event["kind"] == "agent"], ["begins: A exact"])
        # In the same tick the arm is the operator's.
        self.assertIn(("operator", up), states)
        self.assertEqual([text for text, _ in states][-2:], ["clutch", "stopped"])
        self.assertTrue(self.answer("trial", "replay", project, trial["name"], "--verify")["verified"])

    def test_consoles_come_to_the_window_and_are_gone(self):
        project = self.empty_project()
        port = free_port()
        window = self.started(project, "J5_by_console", port)
        self.played(self.scripted(port, "0.3 move 0.05 0 0 over 0.5\n1.5 clutch down\n3 clutch up\n3.5 end\n"))
        # So long that the ten seconds are seen to begin anew.
        self.played(self.console(port, "--source", "still", "--seconds", "3"))
        self.ended(window)
        trial = self.answer("trial", "list", project)["trials"][0]
        self.assertEqual((trial["operator"], trial["outcome"], trial["clutches"]), ("scripted", "aborted", 1))
        self.assertGreater(trial["path_length_m"], 0.009)
        self.assertGreater(trial["delay_mean_s"], 0.0)
        self.assertGreaterEqual(trial["delay_worst_s"], trial["delay_mean_s"])
        states = self.states(project, trial["name"])
        self.assertEqual([text for text, _ in states][-4:-2], ["hold", "operator"])
        self.check_ended_by_silence(states)
        self.assertTrue(self.answer("trial", "replay", project, trial["name"], "--verify")["verified"])

    def test_a_console_that_is_there_but_silent_ends_its_transfer_which_has_nothing_of_what_was_before(self):
        project = self.empty_project()
        port = free_port()
        window = self.started(project, "J5_consoles", port)
        far = self.scripted(port, "1 clutch down\n300 end\n", "--delay", "60")
        self.dumped(window, "paused.json")
        far.terminate()
        far.communicate(timeout=PATIENCE_S)
        # While nobody has a transfer somebody tries the clutch.
        self.played(self.scripted(port, "0.6 clutch down\n0.8 clutch up\n1.2 end\n"))
        last = self.console(port, "--source", "still", "--seconds", "300")
        self.dumped(window, "running.json")
        # Its connection stays.
        last.send_signal(signal.SIGSTOP)
        self.ended(window)
        first, second = self.answer("trial", "list", project)["trials"]
        # Stopped by Esc in the clutch; the delay is that of the console's relay.
        self.assertEqual((first["name"], first["operator"], first["outcome"]), ("MT 1", "scripted", "aborted"))
        self.assertGreaterEqual(first["delay_mean_s"], 0.060)
        self.assertEqual([text for text, _ in self.states(project, "MT 1")][-2:], ["clutch", "stopped"])
        self.assertEqual((second["name"], second["outcome"], second["path_length_m"]), ("MT 2", "aborted", 0.0))
        self.check_ended_by_silence(self.states(project, "MT 2"))
        # Neither the clutch of the pause nor the delay of the first transfer is this one's.
        self.assertEqual([event["text"] for event in self.events(project, "MT 2") if event["kind"] == "pedal"], [])
        self.assertEqual(second["clutches"], 0)
        self.assertLess(second["delay_mean_s"], 0.030)
        for trial in (first, second):
            self.assertTrue(self.answer("trial", "replay", project, trial["name"], "--verify")["verified"])

    def test_a_file_of_manual_blocks_alone_asks_for_no_model(self):
        (self.folder / "manual.json").write_text(json.dumps(
            {"name": "Manual", "transfer_s": 60, "blocks": [{"name": "Manual", "mode": "MT", "transfers": 1}]}))
        script = self.folder / "manual.ui"
        script.write_text('click "Menu/Workspaces/Trials"\nframes 3\nclick "Tabs/Trials"\nframes 2\n'
                          'click "Trials/Page/Run"\nclick "Trials/Setup/Protocol"\nclick "Protocol/From a file"\n'
                          'frames 2\ntype "Trials/Setup/Protocol file" "manual.json"\nframes 2\n'
                          'expect "Trials/Setup/Start" enabled\n')
        self.answer("ui", "run", "--project", self.empty_project(), "--script", script, "--size", "1600x1000")


if __name__ == "__main__":
    unittest.main()
