"""The first job of workbench.md: author and trim a demonstration in the window, by mouse or by keys, and with a crash.

Usage: gui_story.py mouse | keys | kill | pictures_dark | pictures_light
By mouse it begins with the import of a table, by keys with a take that is recorded by keys. The pictures of the stations
are compared with tests/golden/story (TROCAR_COMPARE names the program for it); TROCAR_BLESS=1 writes them anew.
"""
import bisect
import csv
import json
import math
import os
import random
import shutil
import signal
import subprocess
import sys
import time
import unittest

from cli_support import DONE, TESTS, TROCAR, CommandLineTest, trocar

COMPARE = os.path.abspath(os.environ.get("TROCAR_COMPARE", "build/release/bin/compare_pictures"))
PATIENCE_S = 300
ARMS = ("left", "right")
# What the import says of the table; the frame that comes twice is on a line of its own.
FOUND_TWICE = 403
FOUND = ("30 samples a second", "samples come unevenly: 9 of 10 are 30 to 37 ms after the one before",
         "1 gap, the longest 0.43 s at 23.97 s", "neither tool moves in", "the left tool's quaternion changes sign 7 times",
         "the right tool's quaternion changes sign 7 times",
         f"1 row is left out, the first is line {FOUND_TWICE}: the time is that of the row before",
         "times count from the first sample, in whole milliseconds")
# Every kind of edit that the job needs.
NEEDED = ("trim-idle", "delete", "bridge", "move", "label", "snap")


# What a camera's clock and a person do to a recording, in seconds of the table.
FRAME_S = 1 / 30
JITTER_S = 0.0015
WAITS_S = 2.0
HESITATES_AT_S, HESITATES_FOR_S = 5.2, 0.6
LOST_S = (24.0, 24.37)
FLIPPED_FRAMES = 130
TWICE = 400


def expert_time(stamp_s):
    """When in the expert's motion a frame is taken: it waits before it begins, and hesitates once."""
    moving_s = min(stamp_s, HESITATES_AT_S) + max(stamp_s - HESITATES_AT_S - HESITATES_FOR_S, 0.0)
    return max(moving_s - WAITS_S, 0.0)


def hard_frames(rows):
    """(stamp, row, signs of the quaternions) as a 30 Hz tracker writes them: stamps that jitter, frames that are lost, one
    that comes twice, and quaternions that change sign, each arm's at other times."""
    jitter = random.Random(1)
    times = [float(row["t_s"]) for row in rows]
    for frame in range(int((times[-1] + WAITS_S + HESITATES_FOR_S) / FRAME_S)):
        stamp = max(frame * FRAME_S + min(max(jitter.gauss(0.0, JITTER_S), -2 * JITTER_S), 2 * JITTER_S), 0.0)
        if LOST_S[0] < stamp < LOST_S[1]:
            continue
        row = rows[bisect.bisect_left(times, expert_time(stamp))]
        flipped = frame // FLIPPED_FRAMES % 2 == 1
        taken = (stamp, row, {"left": -1 if flipped else 1, "right": 1 if flipped else -1})
        yield taken
        if frame == TWICE:
            yield taken


def write_table(exported, path):
    """A table of another program, from one of ours: fewer columns, other names and units, and hard as real ones are."""
    with open(exported, newline="") as rows, open(path, "w", newline="") as out:
        table = csv.writer(out)
        head = ["time_s"]
        for arm in ARMS:
            head += [f"{arm}_{axis}_mm" for axis in "xyz"] + [f"{arm}_q{axis}" for axis in "xyzw"] + [f"{arm}_gripper_deg"]
        table.writerow(head)
        for stamp, row, signs in hard_frames(list(csv.DictReader(rows))):
            values = [f"{stamp:.4f}"]
            for arm in ARMS:
                values += [f"{1000 * float(row[f'{arm}_measured_{axis}_m']):.4f}" for axis in "xyz"]
                values += [f"{signs[arm] * float(row[f'{arm}_measured_q_{axis}']):.6f}" for axis in "xyzw"]
                values.append(f"{math.degrees(float(row[f'{arm}_jaw_rad'])):.3f}")
            table.writerow(values)


class Story(CommandLineTest):
    def hash(self, project):
        return self.answer("info", project)["hash"]

    def errors(self, project, name):
        problems = self.answer("demo", "check", project, name)["problems"]
        return sum(problem["severity"] == "error" for problem in problems)

    def prepare_import(self):
        """An empty project, the script with its table beside it; stations go into the test's own folder."""
        recorded = self.recorded_project()
        self.answer("demo", "export", recorded, "Expert", self.folder / "exported.csv")
        write_table(self.folder / "exported.csv", self.folder / "table.csv")
        script = self.folder / "story.ui"
        shutil.copy(TESTS / "gui" / "J1_author_by_mouse.ui", script)
        here = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, here)
        return self.empty_project(), script

    def author(self, project, script, name):
        """Runs the script; what it did is in the history, and undone step by step gives what was there before."""
        original = self.hash(project)
        self.answer("ui", "run", "--project", project, "--script", script, code=DONE)
        authored = self.hash(project)
        self.assertNotEqual(authored, original)
        self.assertEqual(self.errors(project, name), 0)
        edits = [entry["edit"] for entry in self.answer("demo", "stack", project, name)["stack"]]
        for edit in NEEDED:
            self.assertIn(edit, edits)
        self.assertEqual(edits.count("label"), 5)
        segments = self.answer("demo", "show", project, name)["segments"]
        self.assertEqual("".join(segment["label"] for segment in segments), "ABCDE")
        report = trocar("demo", "diff", project, name, "--against", "original", "--format", "md")
        self.assertEqual(report.returncode, DONE, report.stderr)
        self.assertIn("|", report.stdout)
        # The last one takes back that it was added.
        steps = len(edits) + 1
        for _ in range(steps):
            self.assertNotEqual(self.hash(project), original)
            self.answer("undo", project)
        self.assertEqual(self.hash(project), original)
        for _ in range(steps):
            self.answer("redo", project)
        self.assertEqual(self.hash(project), authored)

    def test_mouse(self):
        project, script = self.prepare_import()
        self.told_by_import(project)
        self.author(project, script, "Table")

    def told_by_import(self, project):
        """What is hard about the table is said before anything is done; what is imported is the table as it stands."""
        before = self.hash(project)
        table = self.folder / "table.csv"
        dry = self.answer("demo", "import", project, table, "--dry-run")
        self.assertEqual(self.hash(project), before)
        found = " | ".join(dry["found"] + dry["changed"])
        for words in FOUND:
            self.assertIn(words, found)
        self.assertEqual(dry["errors"], 1)  # The gap.
        copy = self.folder / "copy.trocar"
        shutil.copy(project, copy)
        answer = self.answer("demo", "import", copy, table, "--map", "proposed", "--name", "Table")
        self.assertEqual(answer["found"], dry["found"])
        shown = self.answer("demo", "show", copy, "Table")
        self.assertEqual(shown["rate_hz"], 30)
        self.assertIn(f"{shown['rate_hz']:.6g} samples a second", dry["found"])
        out = self.folder / "imported.csv"
        self.answer("demo", "export", copy, "Table", out)
        with open(table, newline="") as rows, open(out, newline="") as read:
            given, taken = list(csv.DictReader(rows)), list(csv.DictReader(read))
        # But for the frame that came twice, whose line was said.
        del given[FOUND_TWICE - 2]
        self.assertEqual(len(taken), len(given))
        for theirs, ours in zip(given, taken):
            self.assertAlmostEqual(float(ours["t_s"]), float(theirs["time_s"]) - float(given[0]["time_s"]), delta=0.00051)
            for arm in ARMS:
                for axis in "xyz":
                    self.assertAlmostEqual(1000 * float(ours[f"{arm}_setpoint_{axis}_m"]), float(theirs[f"{arm}_{axis}_mm"]), delta=1e-4)
                for axis in "xyzw":
                    self.assertAlmostEqual(float(ours[f"{arm}_setpoint_q_{axis}"]), float(theirs[f"{arm}_q{axis}"]), delta=1e-5)

    def test_keys(self):
        self.author(self.recorded_project(), TESTS / "gui" / "J1_author_by_keys.ui", "By hand 1")

    def compare_stations(self, theme, scale, size):
        project, script = self.prepare_import()
        # By name: the window says where a project lies, and this folder has another name each time.
        self.answer("ui", "run", "--project", project.name, "--script", script.name, "--theme", theme, "--scale", scale,
                    "--size", size)
        stations = sorted(self.folder.glob("station_*.png"))
        self.assertEqual(len(stations), 5)
        for station in stations:
            golden = TESTS / "golden" / "story" / f"{station.stem}_{theme}_{round(100 * scale)}.png"
            with self.subTest(station=golden.name):
                compared = subprocess.run([COMPARE, station, golden], capture_output=True, text=True, timeout=PATIENCE_S)
                self.assertEqual(compared.returncode, 0, compared.stdout + compared.stderr)

    def test_pictures_dark(self):
        self.compare_stations("dark", 1.0, "1280x800")

    def test_pictures_light(self):
        self.compare_stations("light", 2.0, "2200x1400")

    def killed_in_a_drag(self, name, *lines):
        """A project after two edits, killed while the last of `lines` holds the mouse; and what the window showed then."""
        # By a name of its own: what a killed program leaves beside a project belongs to that project alone.
        project = self.recorded_project().rename(self.folder / f"{name}.trocar")
        held = self.folder / f"{name}.json"
        script = self.folder / "drag.ui"
        script.write_text("\n".join(["key Ctrl+2", "wait idle", "key Ctrl+Shift+T", "wait idle", "key 1", "wait idle",
                                     *lines, f'dump "{held}"', "frames 1000000", ""]))
        window = subprocess.Popen([TROCAR, "ui", "run", "--project", project, "--script", script],
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(window.kill)
        deadline = time.monotonic() + PATIENCE_S
        while not held.exists() and window.poll() is None:
            self.assertLess(time.monotonic(), deadline, "the drag did not begin")
            time.sleep(0.05)
        self.assertIsNone(window.poll(), "the window ended by itself")
        items = json.loads(held.read_text())
        window.send_signal(signal.SIGKILL)
        window.wait()
        stack = self.answer("demo", "stack", project, "Expert")["stack"]
        self.assertEqual([entry["edit"] for entry in stack], ["trim-idle", "label"])
        return project, items

    def test_kill(self):
        """`kill -9` in the middle of a drag costs the drag, and nothing that was committed."""
        # Of a waypoint, by an arrow of the tool.
        project, items = self.killed_in_a_drag("waypoint", "key Ctrl+Right", "key Ctrl+Right", "key G", "frames 3",
                                               'hold "View/Gizmo/Y" 60 0')
        arrow = next(item for item in items if item["path"].endswith("View/Gizmo/Y"))
        self.assertNotIn("+0.00  +0.00  +0.00 mm", arrow["value"])
        self.answer("undo", project)
        self.answer("redo", project)
        # Of a gate.
        project, items = self.killed_in_a_drag("gate", 'hold "Timeline/In gate" 60 0')
        gate = next(item for item in items if item["path"].endswith("Timeline/In gate"))
        shown = self.answer("demo", "show", project, "Expert")
        self.assertNotAlmostEqual(float(gate["value"]), shown["begin_s"], delta=0.01)
        # It is opened again in the window as it was, and worked on as if nothing had been.
        self.answer("ui", "run", "--project", project, "--script", self.reopened())
        self.answer("undo", project)
        self.answer("undo", project)
        self.answer("undo", project)

    def reopened(self):
        script = self.folder / "reopened.ui"
        script.write_text('click "Menu/Workspaces/Author"\nclick "Tabs/Edits"\nwait idle\n'
                          'expect "Edits/Stack/1/Trim idle" value on\nexpect "Edits/Stack/2/Label" value on\n'
                          'click "Menu/Modify"\nclick "Modify/Mirror"\nwait idle\nclick "Edits/Draft/Apply"\nwait idle\n'
                          'expect "Edits/Stack/3/Mirror" value on\n')
        return script


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], f"Story.test_{sys.argv[1]}"])
