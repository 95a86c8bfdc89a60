"""The fourth job of workbench.md, in the workspace Export: a film queued, held and let go on, others given up, and the
same job by the command line.

Usage: gui_film_queue_story.py
"""
import json
import os
import pathlib
import unittest

from cli_support import DONE, CommandLineTest
from gui_films_story import TESTS, frame_hashes


class Queue(CommandLineTest):
    def test_queue(self):
        project = self.recorded_project()
        self.answer("demo", "edit", project, "1", "trim", "--from", "1", "--to", "3")
        script = self.folder / "queue.ui"
        script.write_text((TESTS / "gui" / "J4_export_queue.ui").read_text())
        here = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, here)
        self.answer("ui", "run", "--project", project.name, "--script", script.name, "--size", "1600x1000", code=DONE)
        for name in ("held", "half"):
            self.assertEqual([path.name for path in self.folder.glob(name + "*")], [])
        self.assertEqual([name for name in os.listdir(".") if ".part" in name], [])
        job = json.loads(pathlib.Path("queued.json").read_text(encoding="utf-8"))
        self.assertEqual(job["sources"][1]["camera"]["view"], "poses")
        made = self.answer("video", "render", project, "queued.json", "--out", "typed.mp4")
        frames = frame_hashes("queued.mp4")
        self.assertEqual(len(frames), made["frames"])
        self.assertEqual(frames, frame_hashes("typed.mp4"))


if __name__ == "__main__":
    unittest.main()
