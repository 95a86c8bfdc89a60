"""The fourth job of workbench.md, in the workspace Export: a film queued, held and let go on, others given up, and the
same job by the command line.

Usage: gui_film_queue_story.py
"""
import json
import os
import pathlib
import unittest

from cli_support import CommandLineTest
from gui_films_story import frame_hashes


class Queue(CommandLineTest):
    def test_queue(self):
        project = self.recorded_project()
        self.answer("demo", "edit", project, "1", "trim", "--from", "1", "--to", "3")
        self.play("J4_export_queue.ui", project)
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
