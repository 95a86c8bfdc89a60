"""A trial by a console over TCP, both programs as a user starts them. Nothing here depends on how fast the machine is.

Usage: cli_link_test.py
"""
import json
import os
import pathlib
import signal
import struct
import subprocess
import time
import unittest

from cli_support import DONE, TROCAR, USAGE, WORLD, CommandLineTest

CONSOLE = str(pathlib.Path(TROCAR).with_name("trocar-console"))


def start(*arguments):
    return subprocess.Popen(list(map(str, arguments)), stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


class Link(CommandLineTest):
    def run_over_the_link(self, project, *console, trial=(), mode="MT"):
        """The answers of `trocar trial run --operator tcp` and of the console."""
        running = start(TROCAR, "trial", "run", project, "--mode", mode, "--operator", "tcp", "--listen",
                        self.free_port(), "--json", *trial)
        self.addCleanup(running.kill)
        waiting = running.stderr.readline()
        self.assertTrue(waiting.startswith("waiting for a console at port "), waiting)
        port = waiting.split()[-1]
        sent = subprocess.run([CONSOLE, "--connect", f"127.0.0.1:{port}", "--json", *map(str, console)],
                              capture_output=True, text=True, timeout=300)
        out, err = running.communicate(timeout=300)
        self.assertEqual(running.returncode, DONE, err)
        self.assertEqual(sent.returncode, DONE, sent.stderr)
        return json.loads(out), json.loads(sent.stdout)

    def free_port(self):
        import socket
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            return free.getsockname()[1]

    def test_a_scripted_hand_moves_the_tool_and_is_never_a_person(self):
        project = self.empty_project()
        script = self.folder / "moves.hand"
        script.write_text("0.3 move 0.05 0 0 over 0.5\n1 clutch down\n1.2 clutch up\n30 end\n")
        log = self.folder / "relay.csv"
        trial, console = self.run_over_the_link(
            project, "--source", "scripted", "--script", script, "--delay", "ar1:20:5", "--relay-log", log,
            trial=("--time-limit", 3))
        kept = trial["trials"][0]
        self.assertEqual((kept["operator"], kept["outcome"]), ("scripted", "unfinished"))
        self.assertEqual(kept["clutches"], 1)
        self.assertGreater(kept["path_length_m"], 0.009)
        self.assertGreaterEqual(trial["loop"]["ticks"], 3000)
        self.assertEqual(sum(row["ticks"] for row in trial["loop"]["classes"]), trial["loop"]["ticks"])
        self.assertEqual(trial["link"]["malformed"], 0)
        self.assertGreater(trial["link"]["frames"], 0)
        self.assertGreater(trial["link"]["delay_p50_ms"], 5.0)
        self.assertEqual(console["relay"]["delay"], "ar1:20:5")
        self.assertGreater(console["relay"]["applied"]["mean_ms"], 5.0)
        self.assertEqual(len(log.read_text().splitlines()) - 1, console["relay"]["relayed"])
        # What was recorded replays to the same hashes, however late the network and the loop were.
        self.assertTrue(self.answer("trial", "replay", project, kept["id"], "--verify")["verified"])
        self.assertEqual(self.answer("trial", "list", project)["trials"][0]["operator"], "scripted")

    def test_a_gamepad_is_a_person(self):
        project = self.empty_project()
        device = self.folder / "js0"
        os.mkfifo(device)
        # What the kernel sends of a pad whose left stick is pushed all the way to the right.
        pad = os.open(device, os.O_RDWR)
        self.addCleanup(os.close, pad)
        os.write(pad, struct.pack("<IhBB", 0, 32767, 2, 0))
        trial, _ = self.run_over_the_link(project, "--source", "gamepad", "--device", device,
                                          trial=("--time-limit", 3))
        kept = trial["trials"][0]
        self.assertEqual((kept["operator"], kept["outcome"]), ("person", "unfinished"))
        self.assertGreater(kept["path_length_m"], 0.005)
        none = subprocess.run([CONSOLE, "--connect", "127.0.0.1:9", "--source", "gamepad", "--device",
                               str(self.folder / "none")], capture_output=True, text=True, timeout=60)
        self.assertEqual(none.returncode, WORLD)
        self.assertIn("none is plugged in there", none.stderr)

    def test_a_replayed_demonstration_leads_the_tool_along_its_path(self):
        project = self.recorded_project()
        trial, console = self.run_over_the_link(project, "--source", "replay", "--replay", project, "Expert",
                                                trial=("--time-limit", 4, "--block", 0))
        self.assertGreater(trial["trials"][0]["path_length_m"], 0.01)
        self.assertGreater(console["sent"], 0)

    def test_the_right_hand_of_a_console_has_the_right_arm(self):
        project = self.empty_project()
        script = self.folder / "still.hand"
        script.write_text("30 end\n")
        trial, _ = self.run_over_the_link(project, "--source", "scripted", "--script", script,
                                          trial=("--assist", "--time-limit", 2))
        kept = trial["trials"][0]
        self.assertEqual((kept["operator"], kept["assistant"], kept["placed"]), ("scripted", "scripted", False))
        self.assertTrue(self.answer("trial", "replay", project, kept["id"], "--verify")["verified"])
        self.refused("trial", "run", project, "--mode", "MT", "--assist", code=USAGE, saying="--assist")

    def test_a_release_in_the_middle_of_the_agents_way_is_the_operators_in_the_same_tick(self):
        project = self.recorded_project()
        script = self.folder / "feet.hand"
        script.write_text("0.5 agent down\n0.9 agent up\n1.6 agent down\n2 agent up\n30 end\n")
        running = ("--source", "scripted", "--script", script)
        trial, _ = self.run_over_the_link(project, *running, trial=("--time-limit", 4, "--block", 0), mode="SC")
        events = self.answer("trial", "show", project, trial["trials"][0]["id"])["events"]
        ups = [e["t_s"] for e in events if e["text"] == "agent pedal up"]
        self.assertEqual(len(ups), 2)
        for up in ups:
            before = [e["text"] for e in events if e["kind"] == "state" and e["t_s"] < up]
            self.assertEqual(before[-1], "agent")
            self.assertIn(("operator", up), [(e["text"], e["t_s"]) for e in events if e["kind"] == "state"])
        self.assertGreater(trial["trials"][0]["agent_share"], 0.05)

    def test_a_trial_that_is_ended_by_a_signal_is_kept_as_what_it_is(self):
        project = self.empty_project()
        script = self.folder / "long.hand"
        script.write_text("0.2 move 0.05 0 0 over 0.5\n60 end\n")
        running = start(TROCAR, "trial", "run", project, "--mode", "MT", "--operator", "tcp", "--listen", self.free_port(),
                        "--json")
        self.addCleanup(running.kill)
        port = running.stderr.readline().split()[-1]
        console = start(CONSOLE, "--connect", f"127.0.0.1:{port}", "--source", "scripted", "--script", script, "--patience",
                        "1")
        self.addCleanup(console.kill)
        time.sleep(2.0)
        running.send_signal(signal.SIGTERM)
        running.communicate(timeout=60)
        console.communicate(timeout=60)
        kept = self.answer("trial", "list", project)["trials"]
        self.assertEqual([trial["outcome"] for trial in kept], ["aborted"])
        self.assertGreater(kept[0]["path_length_m"], 0.0)
        self.assertTrue(self.answer("trial", "replay", project, kept[0]["id"], "--verify")["verified"])

    def test_what_makes_no_sense_is_refused(self):
        project = self.empty_project()
        tcp = ("trial", "run", project, "--mode", "MT", "--operator", "tcp")
        self.refused(*tcp, code=USAGE, saying="--listen")
        self.refused(*tcp, "--listen", "0", code=USAGE, saying="no place")
        self.refused(*tcp, "--listen", self.free_port(), "--transfers", "2", code=USAGE, saying="one transfer")
        self.refused("trial", "run", project, "--protocol", "sim", "--operator", "tcp", "--listen", "5005", code=USAGE,
                     saying="for the window")
        self.refused("trial", "run", project, "--mode", "MT", "--listen", "5005", code=USAGE, saying="--operator tcp")
        nobody = self.answer(*tcp, "--listen", self.free_port(), "--wait", "0.1", code=WORLD)
        self.assertIn("no console came", nobody["error"])
        done = subprocess.run([CONSOLE, "--connect", f"127.0.0.1:{self.free_port()}", "--patience", "0"],
                              capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, WORLD)
        self.assertTrue(done.stderr.startswith("trocar-console: could not connect"), done.stderr)


if __name__ == "__main__":
    unittest.main()
