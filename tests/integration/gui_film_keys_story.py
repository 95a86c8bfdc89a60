"""The fourth job of workbench.md, in the workspace Export: what changes in a film by keys, a rollout, a field in the scene,
and the same job by the command line.

Usage: gui_film_keys_story.py
"""
import json
import pathlib
import subprocess
import unittest

from cli_support import CommandLineTest
from gui_films_story import frame_hashes


class Keys(CommandLineTest):
    def test_keys(self):
        project = self.recorded_project()
        self.answer("demo", "edit", project, "1", "trim", "--from", "1", "--to", "3")
        self.play("J4_export_keys.ui", project)
        job = json.loads(pathlib.Path("keys.json").read_text(encoding="utf-8"))
        self.assertEqual((job["codec"], job["crf"]), ("auto", 17))
        recording, rollout = job["sources"]
        self.assertEqual((recording["kind"], rollout["kind"]), ("recording", "rollout"))
        self.assertEqual((rollout["field"]["slice"], rollout["out_s"]), ("z=9", 1.5))
        tracks = {track["property"]: track["keys"] for track in rollout["tracks"]}
        self.assertEqual(sorted(tracks), ["brightness", "field.opacity"])
        self.assertEqual([(key["t"], round(key["value"], 6)) for key in tracks["field.opacity"]], [(0, 0), (1, 0.9)])
        self.assertEqual([(key["t"], round(key["value"], 6)) for key in tracks["brightness"]], [(0, 0), (1, 1)])
        self.assertEqual(tracks["field.opacity"][0]["ease"], "spline")
        self.assertEqual([round(hold["for_s"], 6) for hold in job["time"]["holds"]], [0.4])
        made = self.answer("video", "render", project, "keys.json", "--out", "typed.mp4")
        # Two seconds of the demonstration and the hold, ten frames each second, both ends seen.
        self.assertEqual(made["frames"], 25)
        frames = frame_hashes("keys.mp4")
        self.assertEqual(len(frames), 25)
        self.assertEqual(frames, frame_hashes("typed.mp4"))
        # The rollout's half comes from black; the other does not.
        for half, dark in (("crop=300:340:330:10", True), ("crop=300:340:10:10", False)):
            done = subprocess.run(["ffmpeg", "-v", "error", "-i", "keys.mp4", "-frames:v", "1", "-vf", half, "-f", "rawvideo",
                                   "-pix_fmt", "gray", "-"], capture_output=True, check=True)
            self.assertEqual(max(done.stdout) < 40, dark)


if __name__ == "__main__":
    unittest.main()
