"""Films of several sources, from options and from jobs, as a user meets them."""
import json
import shutil
import subprocess
import unittest

from cli_support import USAGE, WORLD, CommandLineTest, trocar


class Films(CommandLineTest):
    def trimmed_project(self):
        project = self.recorded_project()
        self.answer("demo", "edit", project, "1", "trim", "--from", "1", "--to", "3")
        return project

    def test_options_mean_a_job_and_the_job_gives_the_same_film(self):
        project = self.trimmed_project()
        job = self.folder / "film.json"
        options = ["Expert", "Expert", "--layout", "top-bottom", "--sync", "segment", "--size", "320x360", "--fps", "5",
                   "--overlays", "title,authority,captions", "--camera", "top"]
        told = self.answer("video", "render", project, *options, "--write-job", job)
        self.assertEqual(told["sources"], 2)
        self.assertEqual(self.leftovers(), ["film.json", "recorded.trocar"])
        written = json.loads(job.read_text())
        self.assertEqual(written["layout"], "top-bottom")
        self.assertEqual(written["overlays"], ["title", "authority", "captions"])
        self.assertEqual(written["sources"][0], {"kind": "recording", "of": "Expert", "camera": {"view": "top"}})
        first = self.answer("video", "render", project, *options, "--out", self.folder / "a_%02d.png")
        second = self.answer("video", "render", project, job, "--out", self.folder / "b_%02d.png")
        self.assertEqual(first["frames"], second["frames"])
        self.assertEqual(first["codec"], "png")
        self.assertEqual(first["srt"], str(self.folder / "a.srt"))
        for i in range(first["frames"]):
            self.assertEqual((self.folder / f"a_{i:02}.png").read_bytes(), (self.folder / f"b_{i:02}.png").read_bytes())
        for ending in (".srt", ".vtt"):
            self.assertEqual((self.folder / f"a{ending}").read_text(), (self.folder / f"b{ending}").read_text())

    def test_presets_begin_and_options_go_on(self):
        project = self.trimmed_project()
        film = self.folder / "film.mp4"
        answer = self.answer("video", "render", project, "1", "1", "--preset", "mt-vs-sc", "--size", "321x181", "--fps", "5",
                             "--out", film)
        self.assertEqual((answer["width"], answer["height"]), (322, 182))
        self.assertEqual(answer["srt"], str(self.folder / "film.srt"))
        small = self.answer("video", "render", project, "1", "--preset", "thumbnail", "--out", self.folder / "small.mp4")
        self.assertEqual((small["width"], small["height"], small["srt"]), (320, 180, None))

    def test_a_webm_and_a_gif_are_what_their_names_say_and_captions_lie_beside_them_for_players_and_pages(self):
        project = self.trimmed_project()
        small = ("--size", "64x36", "--fps", "7", "--speed", "4", "--overlays", "captions")
        for name, codec in (("film.webm", "vp9"), ("film.gif", "gif")):
            film = self.folder / name
            done = trocar("video", "render", project, "1", *small, "--json", "--out", film)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            answer = json.loads(done.stdout)
            self.assertEqual(answer["codec"], codec)
            self.assertEqual((answer["srt"], answer["vtt"]), (str(film.with_suffix(".srt")), str(film.with_suffix(".vtt"))))
            self.assertTrue(film.with_suffix(".srt").read_text().startswith("1\n00:00:00,000 --> "))
            self.assertTrue(film.with_suffix(".vtt").read_text().startswith("WEBVTT\n\n00:00:00.000 --> "))
            if shutil.which("ffprobe") is None:
                continue
            probe = subprocess.run(["ffprobe", "-v", "warning", "-count_frames", "-of", "csv=p=0", "-show_entries",
                                    "stream=codec_name,width,height,nb_read_frames", film],
                                   capture_output=True, text=True, check=True)
            self.assertEqual((probe.stdout, probe.stderr), (f"{codec},64,36,{answer['frames']}\n", ""))
        self.assertEqual(self.leftovers(), ["film.gif", "film.srt", "film.vtt", "film.webm", "recorded.trocar"])
        self.refused("video", "render", project, "1", "--fps", "60", "--out", self.folder / "fast.gif", code=USAGE, saying="50")
        self.refused("video", "render", project, "1", "--codec", "gif", "--out", self.folder / "a.webm", code=USAGE, saying=".gif")

    def test_a_film_says_who_made_what_it_shows_and_carries_the_job_that_makes_it_again(self):
        if shutil.which("ffprobe") is None:
            self.skipTest("no ffprobe")
        project = self.trimmed_project()
        job, film = self.folder / "film.json", self.folder / "film.mp4"
        options = ["Expert", "--size", "128x72", "--fps", "5", "--speed", "2", "--codec", "av1", "--crf", "40"]
        self.answer("video", "render", project, *options, "--write-job", job)
        self.assertEqual(self.answer("video", "render", project, *options, "--out", film)["codec"], "av1")
        probe = subprocess.run(["ffprobe", "-v", "warning", "-of", "json", "-show_entries", "format_tags=title,comment", film],
                               capture_output=True, text=True, check=True)
        self.assertEqual(probe.stderr, "")
        tags = json.loads(probe.stdout)["format"]["tags"]
        self.assertEqual(tags["title"], "Expert")
        credit, said = tags["comment"].split("trocar video render, job: ")
        self.assertRegex(credit, r"^Expert: scripted expert, seed \d+, trocar [\d.]+, [0-9a-f]{16}\n$")
        kept = json.loads(job.read_text())
        self.assertEqual(kept["crf"], 40)
        kept.pop("path", None)
        self.assertEqual(json.loads(said), kept)

    def test_what_a_codec_cannot_lose_is_refused(self):
        project = self.trimmed_project()
        for name, crf, saying in (("a.mp4", 52, "1 to 51"), ("a.mp4", 0, "1 to 63"), ("a.gif", 20, "gif has no crf"), ("a_%02d.png", 20, "leave the crf out"),
                                  ("a.webm", 64, "1 to 63")):
            self.refused("video", "render", project, "1", "--crf", crf, "--out", self.folder / name, code=USAGE, saying=saying)
        self.assertEqual(self.leftovers(), ["recorded.trocar"])

    def test_fields_and_curves_are_sources_of_a_job(self):
        project = self.trimmed_project()
        job = self.folder / "film.json"
        job.write_text(json.dumps({"width": 640, "height": 360, "fps": 2, "layout": "2x2", "path": str(self.folder / "film.mkv"),
                                   "sources": [{"of": "Expert"}, {"of": "Expert", "kind": "curve"},
                                               {"of": "A exact", "kind": "field", "slice": "x=9"}]}))
        answer = self.answer("video", "render", project, job)
        self.assertEqual(answer["frames"], 5)
        self.assertEqual(answer["out"], str(self.folder / "film.mkv"))

    def test_a_rollout_beside_its_demonstration_by_options_and_as_a_job(self):
        project = self.trimmed_project()
        job = self.folder / "film.json"
        options = ["Expert", "--rollout", "A exact@9,9,15", "--size", "320x180", "--fps", "5", "--layout", "side-by-side"]
        self.answer("video", "render", project, *options, "--write-job", job)
        written = json.loads(job.read_text())
        self.assertEqual(written["sources"][1], {"kind": "rollout", "of": "A exact", "start": [9, 9, 15]})
        first = self.answer("video", "render", project, *options, "--out", self.folder / "a_%02d.png")
        # Its field in the scene, faded in, and the whole come from black.
        written["sources"][1]["field"] = {"of": "A exact", "slice": "z=11"}
        written["sources"][1]["tracks"] = [{"property": "field.opacity", "keys": [{"t": 0, "value": 0, "ease": "spline"},
                                                                                 {"t": 1, "value": 1}]},
                                           {"property": "brightness", "keys": [{"t": 0, "value": 0}, {"t": 0.5, "value": 1}]}]
        job.write_text(json.dumps(written))
        second = self.answer("video", "render", project, job, "--out", self.folder / "b_%02d.png")
        self.assertEqual(first["frames"], second["frames"])
        for i in range(first["frames"]):
            self.assertNotEqual((self.folder / f"a_{i:02}.png").read_bytes(), (self.folder / f"b_{i:02}.png").read_bytes())
        # Wherever the option stands, what comes after it is a demonstration.
        before = self.answer("video", "render", project, "--rollout", "A exact", "Expert", "--size", "160x90", "--fps", "5",
                             "--write-job", self.folder / "before.json")
        self.assertEqual(before["sources"], 2)
        alone = self.answer("video", "render", project, "--rollout", "A exact", "--size", "160x90", "--fps", "5", "--out",
                            self.folder / "alone.mp4")
        self.assertGreater(alone["frames"], 5)
        out = ["--out", self.folder / "none.mp4"]
        self.refused("video", "render", project, "--rollout", "A exact@99,0,0", *out, code=USAGE, saying="outside")
        self.refused("video", "render", project, "--rollout", "A exakt", *out, code=USAGE, saying="A exact")
        self.refused("video", "render", project, *out, code=USAGE, saying="what is filmed")
        self.refused("video", "render", project, job, "--rollout", "A exact", *out, code=USAGE, saying="lists its rollouts")

    def test_jobs_that_cannot_be_are_refused_and_leave_nothing(self):
        project = self.trimmed_project()
        job = self.folder / "film.json"
        out = ["--out", self.folder / "film.mp4"]
        self.refused("video", "render", project, job, *out, code=WORLD)
        for text, code, saying in (("{", WORLD, "JSON"), ('{"sources": [{"of": "1"}], "fsp": 3}', WORLD, "fsp"),
                                   ('{"sources": [{"of": "Expret"}]}', USAGE, "Expert"),
                                   ('{"sources": [{"of": "1"}], "fps": 0}', USAGE, "frames")):
            job.write_text(text)
            self.refused("video", "render", project, job, *out, code=code, saying=saying)
        job.write_text('{"sources": [{"of": "1"}]}')
        self.refused("video", "render", project, job, code=USAGE, saying="--out")
        self.refused("video", "render", project, job, "--out", project, code=USAGE)
        self.assertEqual(self.leftovers(), ["film.json", "recorded.trocar"])

    def test_a_film_of_one_trial_stands_for_all_of_its_session(self):
        project = self.recorded_project()
        ran = ("trial", "run", project, "--mode", "MT", "--block", "0", "--time-limit", "1")
        self.answer(*ran, "--transfers", "3", "--session", "one")
        self.answer(*ran, "--session", "two")
        self.answer("trial", "judge", project, "MT 2", "--exclude", "a rehearsal")
        small = ("--size", "64x36", "--fps", "5", "--speed", "4")
        made = self.answer("video", "render", project, "MT 1", *small, "--all-of-session", "--out", self.folder / "film.mp4")
        self.assertEqual([film["out"] for film in made["films"]],
                         [str(self.folder / name) for name in ("film_MT_1.mp4", "film_MT_3.mp4")])
        for film in made["films"]:
            self.assertGreater(film["frames"], 0)
        self.assertEqual([name for name in self.leftovers() if name.endswith(".mp4")], ["film_MT_1.mp4", "film_MT_3.mp4"])
        self.refused("video", "render", project, "Expert", *small, "--all-of-session", "--out", self.folder / "no.mp4",
                     code=USAGE, saying="one of its trials")

    def test_an_odd_size_is_said(self):
        project = self.trimmed_project()
        done = trocar("video", "render", project, "1", "--size", "161x91", "--fps", "2", "--out", self.folder / "film.mp4")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("became 162×92", done.stderr)


if __name__ == "__main__":
    unittest.main()
