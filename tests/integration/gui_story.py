"""The first job of workbench.md: author and trim a demonstration in the window, by mouse or by keys, and with a crash.

Usage: gui_story.py mouse | keys | kill
"""
import json
import pathlib
import signal
import subprocess
import sys
import time
import unittest

from cli_support import DONE, TROCAR, CommandLineTest, trocar

GUI = pathlib.Path(__file__).resolve().parent.parent / "gui"
PATIENCE_S = 300


class Story(CommandLineTest):
    def hash(self, project):
        return self.answer("info", project)["hash"]

    def errors(self, project):
        problems = self.answer("demo", "check", project, "Expert")["problems"]
        return sum(problem["severity"] == "error" for problem in problems)

    def author(self, script):
        """Runs the script; what it did is in the history, and undone step by step gives what was recorded."""
        project = self.recorded_project()
        original = self.hash(project)
        self.answer("ui", "run", "--project", project, "--script", script, code=DONE)
        authored = self.hash(project)
        self.assertNotEqual(authored, original)
        self.assertEqual(self.errors(project), 0)
        edits = [entry["edit"] for entry in self.answer("demo", "stack", project, "Expert")["stack"]]
        for edit in ("trim-idle", "delete", "bridge", "move", "propose-labels", "snap"):
            self.assertIn(edit, edits)
        report = trocar("demo", "diff", project, "Expert", "--against", "original", "--format", "md")
        self.assertEqual(report.returncode, DONE, report.stderr)
        self.assertIn("|", report.stdout)
        for _ in edits:
            self.answer("undo", project)
        self.assertEqual(self.hash(project), original)
        for _ in edits:
            self.answer("redo", project)
        self.assertEqual(self.hash(project), authored)

    def test_mouse(self):
        self.author(GUI / "J1_author_by_mouse.ui")

    def test_keys(self):
        self.author(GUI / "J1_author_by_keys.ui")

    def test_kill(self):
        """`kill -9` in the middle of a drag costs the drag, and nothing that was committed."""
        project = self.recorded_project()
        held = self.folder / "held.json"
        script = self.folder / "drag.ui"
        script.write_text('key Ctrl+2\nwait idle\nkey Ctrl+Shift+T\nwait idle\nkey 1\nwait idle\n'
                          f'hold "Timeline/In gate" 60 0\ndump "{held}"\nframes 1000000\n')
        window = subprocess.Popen([TROCAR, "ui", "run", "--project", project, "--script", script],
                                  stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(window.kill)
        deadline = time.monotonic() + PATIENCE_S
        while not held.exists() and window.poll() is None:
            self.assertLess(time.monotonic(), deadline, "the drag did not begin")
            time.sleep(0.05)
        self.assertIsNone(window.poll(), "the window ended by itself")
        gate = next(item for item in json.loads(held.read_text()) if item["path"].endswith("Timeline/In gate"))
        window.send_signal(signal.SIGKILL)
        window.wait()
        stack = self.answer("demo", "stack", project, "Expert")["stack"]
        self.assertEqual([entry["edit"] for entry in stack], ["trim-idle", "label"])
        shown = self.answer("demo", "show", project, "Expert")
        self.assertNotAlmostEqual(float(gate["value"]), shown["begin_s"], delta=0.01)
        # It can be worked on as if nothing had been.
        self.answer("demo", "edit", project, "Expert", "mirror")
        self.answer("undo", project)
        self.answer("undo", project)
        self.answer("undo", project)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], f"Story.test_{sys.argv[1]}"])
