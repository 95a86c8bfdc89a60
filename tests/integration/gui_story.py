"""The first job of workbench.md: author and trim a demonstration in the window, by mouse or by keys, and with a crash.

Usage: gui_story.py mouse | keys | kill | pictures_dark | pictures_light
By mouse it begins with the import of a table, by keys with a take that is recorded by keys. The pictures of the stations
are compared with tests/golden/story (TROCAR_COMPARE names the program for it); TROCAR_BLESS=1 writes them anew.
"""
import csv
import json
import math
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time
import unittest

from cli_support import DONE, TROCAR, CommandLineTest, trocar

TESTS = pathlib.Path(__file__).resolve().parent.parent
COMPARE = os.path.abspath(os.environ.get("TROCAR_COMPARE", "build/release/bin/compare_pictures"))
PATIENCE_S = 300
# Every kind of edit that the job needs.
NEEDED = ("trim-idle", "delete", "bridge", "move", "label", "snap")


def write_table(exported, path):
    """A table of another program, from one of ours: fewer columns, other names and units, every second sample."""
    with open(exported, newline="") as rows, open(path, "w", newline="") as out:
        table = csv.writer(out)
        arms = ("left", "right")
        head = ["time_s"]
        for arm in arms:
            head += [f"{arm}_{axis}_mm" for axis in "xyz"] + [f"{arm}_q{axis}" for axis in "xyzw"] + [f"{arm}_gripper_deg"]
        table.writerow(head)
        for row in list(csv.DictReader(rows))[::2]:
            values = [f"{float(row['t_s']):.3f}"]
            for arm in arms:
                values += [f"{1000 * float(row[f'{arm}_measured_{axis}_m']):.4f}" for axis in "xyz"]
                values += [f"{float(row[f'{arm}_measured_q_{axis}']):.6f}" for axis in "xyzw"]
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
        self.author(*self.prepare_import(), "Table")

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
