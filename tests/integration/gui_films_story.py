"""The fourth job of workbench.md: films of two trials from the window, which are those of the command line.

Usage: gui_films_story.py
"""
import os
import subprocess
import unittest

from cli_support import CommandLineTest


def frame_hashes(film):
    """Of every decoded frame."""
    done = subprocess.run(["ffmpeg", "-v", "error", "-i", film, "-f", "framemd5", "-"], capture_output=True, text=True,
                          check=True)
    assert done.stderr == "", done.stderr
    return [line.split(",")[-1].strip() for line in done.stdout.splitlines() if not line.startswith("#")]


class Story(CommandLineTest):
    def test_story(self):
        project = self.recorded_project()
        self.answer("model", "train", project, "Expert", "--segment", "C", "--method", "exact", "--name", "C exact")
        for mode in ("MT", "SC"):
            self.answer("trial", "run", project, "--mode", mode, "--block", "0", "--seed", "3")
        self.play("J4_export_films.ui", project)
        self.assertEqual(sorted(path.name for path in self.folder.glob("given_up*")), [])
        self.assertEqual([name for name in os.listdir(".") if ".part" in name], [])

        trials = {trial["name"]: str(trial["id"]) for trial in self.answer("trial", "list", project)["trials"]}
        made = self.answer("video", "render", project, trials["MT 1"], trials["SC 1"], "--out", "typed.mp4", "--fps", "25",
                           "--size", "640x360", "--layout", "side-by-side", "--sync", "segment", "--speed", "8",
                           "--overlays", "all")
        # The film says which models moved the arm, by their hashes.
        comment = subprocess.run(["ffprobe", "-v", "error", "-of", "csv=p=0", "-show_entries", "format_tags=comment", "typed.mp4"],
                                 capture_output=True, text=True, check=True).stdout
        used = self.answer("trial", "show", project, "SC 1")["models"]
        self.assertEqual(len(used), 2)
        for model in used:
            self.assertIn(f"model {model['name']} {model['hash']}", comment)
        frames = frame_hashes("pair.mp4")
        self.assertEqual(len(frames), made["frames"])
        self.assertEqual(frames, frame_hashes("again.mp4"))
        self.assertEqual(frames, frame_hashes("typed.mp4"))
        self.assertNotEqual(frames, frame_hashes("inset.mp4"))
        captions = (self.folder / "pair.srt").read_text(encoding="utf-8")
        self.assertRegex(captions, r"(?m)^1\n00:00:00,000 --> ")
        probe = subprocess.run(["ffprobe", "-v", "error", "-show_entries", "stream=width,height,avg_frame_rate", "-of",
                                "csv=p=0", "pair.mp4"], capture_output=True, text=True, check=True)
        self.assertEqual((probe.stdout.strip(), probe.stderr), ("640,360,25/1", ""))


if __name__ == "__main__":
    unittest.main()
