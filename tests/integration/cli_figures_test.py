"""What figures, fields and Q-tables look like from outside: paper, VTK, HDF5, and tables that go out and come back."""
import base64
import collections
import csv
import json
import os
import re
import statistics
import struct
import sys
import unittest
import xml.etree.ElementTree as ElementTree
import zlib

try:
    import h5py
    import numpy
except ImportError:  # another Python than Debian's comes first: python3-h5py belongs to that
    if sys.executable == "/usr/bin/python3":
        raise
    os.execv("/usr/bin/python3", ["/usr/bin/python3", *sys.argv])

from cli_support import USAGE, WORLD, CommandLineTest, trocar

COLUMN_PT = 88 / 25.4 * 72


def png_size(path):
    """Pixels, and pixels an inch if the file says so."""
    data = path.read_bytes()
    width, height = struct.unpack(">II", data[16:24])
    at = data.find(b"pHYs")
    dpi = struct.unpack(">I", data[at + 4:at + 8])[0] * 0.0254 if at > 0 else None
    return width, height, dpi


def corner_alpha(path):
    """The alpha of a picture's first pixel, which no filter of its row changes."""
    data = path.read_bytes()
    colour_type = data[25]
    at, packed = 8, b""
    while at < len(data):
        length, = struct.unpack(">I", data[at:at + 4])
        if data[at + 4:at + 8] == b"IDAT":
            packed += data[at + 8:at + 8 + length]
        at += 12 + length
    return zlib.decompress(packed)[4] if colour_type == 6 else 255


def letter_sizes(pdf):
    """The sizes in points of all texts of a PDF, as it shows them."""
    sizes = set()
    for begin in re.finditer(rb"stream\r?\n", pdf):
        try:
            content = zlib.decompressobj().decompress(pdf[begin.end():])
        except zlib.error:
            continue
        found = re.findall(rb"([-\d.]+) [-\d.]+ [-\d.]+ ([-\d.]+) [-\d.]+ [-\d.]+ Tm\s*/f-\d+-\d+ ([\d.]+) Tf", content)
        sizes |= {(round(float(a) * float(size), 3), round(abs(float(d)) * float(size), 3)) for a, d, size in found}
    return sizes


class Paper(CommandLineTest):
    def test_a_column_is_88_mm_wide_in_every_kind_of_file(self):
        project = self.recorded_project()
        for what in (["--montage"], ["--slice", "z=5"]):
            base = ["field", "export", project, "A exact", "--layer", "value", *what, "--preset", "column"]
            self.answer(*base, "--out", self.folder / "a.pdf")
            pdf = (self.folder / "a.pdf").read_bytes()
            self.assertTrue(pdf.startswith(b"%PDF-"))
            box = [float(x) for x in re.search(rb"/MediaBox \[ ([^\]]*) \]", pdf)[1].split()]
            self.assertAlmostEqual(box[2], COLUMN_PT, places=3)
            self.assertEqual(letter_sizes(pdf), {(8.0, 8.0)})
            self.answer(*base, "--out", self.folder / "a.svg")
            root = ElementTree.parse(self.folder / "a.svg").getroot()
            self.assertTrue(root.get("width").endswith("pt"))
            self.assertAlmostEqual(float(root.get("width")[:-2]), COLUMN_PT, places=3)
            for dpi, pixels in ((None, 1039), (600, 2079)):
                self.answer(*base, *(["--dpi", dpi] if dpi else []), "--out", self.folder / "a.png")
                width, _, said = png_size(self.folder / "a.png")
                self.assertEqual(width, pixels)
                self.assertAlmostEqual(said, dpi or 300, delta=0.02)

    def test_curves_go_on_paper_as_well(self):
        project = self.recorded_project()
        base = ["demo", "plot", project, "Expert", "--curve", "speed,jerk,clearance", "--preset", "column"]
        self.answer(*base, "--out", self.folder / "c.pdf")
        pdf = (self.folder / "c.pdf").read_bytes()
        self.assertEqual(letter_sizes(pdf), {(8.0, 8.0)})
        self.assertIn(b"/MediaBox [ 0 0 249.448819 ", pdf)
        self.answer(*base, "--dpi", "150", "--out", self.folder / "c.png")
        self.assertEqual(png_size(self.folder / "c.png")[0], 520)

    def test_a_picture_for_the_screen_may_say_its_resolution(self):
        project = self.recorded_project()
        base = ["field", "export", project, "A exact", "--width", "800"]
        self.answer(*base, "--out", self.folder / "a.png")
        self.assertEqual(png_size(self.folder / "a.png")[::2], (800, None))
        self.answer(*base, "--dpi", "200", "--out", self.folder / "a.png")
        width, _, dpi = png_size(self.folder / "a.png")
        self.assertEqual((width, round(dpi)), (800, 200))

    def test_what_would_be_ignored_is_refused(self):
        project = self.recorded_project()
        base = ["field", "export", project, "A exact"]
        for extra, out, saying in ((["--dpi", "300"], "a.pdf", "--dpi is of a .png"),
                                   (["--preset", "column"], "a.csv", "--preset is of pictures"),
                                   (["--preset", "poster"], "a.png", "no figure preset"),
                                   (["--slice", "z=3"], "a.vti", "whole lattice"),
                                   (["--slice", "z=3"], "a.h5", "whole lattice"),
                                   (["--preset", "page", "--width", "500"], "a.png", "width"),
                                   ([], "a.txt", "must end in")):
            self.refused(*base, *extra, "--out", self.folder / out, code=USAGE, saying=saying)
            self.assertFalse((self.folder / out).exists())


class Rollouts(CommandLineTest):
    KINDS = ("arrivals", "band", "boxes", "axes", "multiples", "map")

    def setUp(self):
        super().setUp()
        self.project = self.recorded_project()
        self.answer("model", "train", self.project, "Expert", "--method", "eg-maxent", "--episodes", "1000", "--seed", "5",
                    "--name", "paper")

    def plot(self, *arguments, kind, out):
        return self.answer("rollout", "plot", self.project, *arguments, "--kind", kind, "--out", self.folder / out)

    def test_every_kind_is_drawn_in_a_column_and_on_a_page_with_letters_of_8_pt(self):
        for kind in self.KINDS:
            for preset, width_mm in (("column", 88), ("page", 180)):
                with self.subTest(kind=kind, preset=preset):
                    base = ["paper", "A exact", *([] if kind == "map" else ["--starts", "around:2"]), "--preset", preset,
                            *(["--pictures", "12"] if kind == "multiples" else [])]
                    self.plot(*base, kind=kind, out="r.pdf")
                    pdf = (self.folder / "r.pdf").read_bytes()
                    box = [float(x) for x in re.search(rb"/MediaBox \[ ([^\]]*) \]", pdf)[1].split()]
                    self.assertAlmostEqual(box[2], width_mm / 25.4 * 72, delta=0.02)
                    self.assertLess(box[3], 297 / 25.4 * 72)  # a sheet is no higher
                    self.assertEqual(letter_sizes(pdf), {(8.0, 8.0)})
                    self.plot(*base, kind=kind, out="r.svg")
                    root = ElementTree.parse(self.folder / "r.svg").getroot()
                    self.assertAlmostEqual(float(root.get("width")[:-2]), width_mm / 25.4 * 72, delta=0.02)
                    self.plot(*base, "--dpi", "150", kind=kind, out="r.png")
                    width, _, said = png_size(self.folder / "r.png")
                    self.assertEqual(width, round(width_mm / 25.4 * 150))
                    self.assertAlmostEqual(said, 150, delta=0.02)

    def test_a_thick_slice_is_written_as_it_is_shown(self):
        whole, thick = self.folder / "w.csv", self.folder / "t.csv"
        self.answer("field", "export", self.project, "A exact", "--layer", "value", "--out", whole)
        values = {}
        with open(whole, newline="") as file:
            for row in csv.DictReader(file):
                values[tuple(int(row[axis]) for axis in "ijk")] = row["value"]
        for through, of in (("largest", max), ("mean", statistics.fmean)):
            self.answer("field", "export", self.project, "A exact", "--layer", "value", "--slice", "z=10", "--slab", "3",
                        "--through", through, "--out", thick)
            with open(thick, newline="") as file:
                rows = list(csv.DictReader(file))
            self.assertEqual(len(rows), 22 * 22)
            for row in rows:
                i, j = int(row["i"]), int(row["j"])
                known = [float(values[i, j, k]) for k in (9, 10, 11) if values[i, j, k]]
                self.assertAlmostEqual(float(row["value"]), of(known), places=9)
        self.refused("field", "export", self.project, "A exact", "--slab", "3", "--out", thick, code=USAGE)
        self.refused("field", "export", self.project, "A exact", "--layer", "safe", "--slice", "z=3", "--slab", "3",
                     "--out", thick, code=USAGE, saying="no thick slices")

    def test_a_figure_without_ground_is_clear_where_it_was_white(self):
        for words in (["field", "export", self.project, "A exact"], ["demo", "plot", self.project, "Expert"],
                      ["model", "curve", self.project, "paper"],
                      ["rollout", "plot", self.project, "paper", "--kind", "boxes"]):
            with self.subTest(words=words[:2]):
                self.answer(*words, "--out", self.folder / "white.svg")
                self.answer(*words, "--transparent", "--out", self.folder / "clear.svg")
                white, clear = ((self.folder / name).read_text().replace(" ", "") for name in ("white.svg", "clear.svg"))
                self.assertGreater(white.count("100%,100%,100%"), clear.count("100%,100%,100%"))
                self.answer(*words, "--transparent", "--out", self.folder / "clear.png")
                self.assertEqual(corner_alpha(self.folder / "clear.png"), 0)
                self.answer(*words, "--out", self.folder / "white.png")
                self.assertEqual(corner_alpha(self.folder / "white.png"), 255)

    def test_the_same_command_writes_the_same_bytes(self):
        for kind in ("boxes", "axes", "multiples"):
            self.plot("paper", kind=kind, out="a.pdf")
            self.plot("paper", kind=kind, out="b.PDF")
            self.assertEqual((self.folder / "a.pdf").read_bytes(), (self.folder / "b.PDF").read_bytes())

    def test_arrivals_and_band_are_numbers_as_well_and_those_of_the_run(self):
        told = self.answer("rollout", "run", self.project, "paper", "--starts", "around:2", "--spread")
        self.plot("paper", "--starts", "around:2", kind="arrivals", out="a.csv")
        with open(self.folder / "a.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        counts = [round(float(row["value"]) * told["count"] / 100) for row in rows]
        arrivals = told["arrivals_by_step"]
        self.assertEqual(counts[:len(arrivals)], arrivals)
        self.assertEqual(counts[-1], told["arrived"])
        self.plot("paper", "--starts", "around:2", kind="band", out="b.csv")
        with open(self.folder / "b.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        by_line = {name: [float(row["value"]) for row in rows if row["line"] == name]
                   for name in ("paper p05", "paper p25", "paper", "paper p75", "paper p95")}
        by_line["paper"] = [float(row["value"]) for row in rows
                            if row["line"] == "paper" and row["curve"] == "Deviation from the expert"]
        self.assertTrue(by_line["paper"])
        for values in zip(*by_line.values()):
            self.assertEqual(list(values), sorted(values))
        # The same as the run's, and so is how many go on.
        self.answer("rollout", "run", self.project, "paper", "--starts", "around:2", "--band", self.folder / "run.csv")
        with open(self.folder / "run.csv", newline="") as file:
            run = list(csv.DictReader(file))
        going_on = [float(row["value"]) for row in rows if row["curve"] == "Still going on"]
        self.assertEqual(len(run), len(going_on))
        for row, share, p05, p25, median, p75, p95 in zip(run, going_on, *by_line.values()):
            for name, value in (("share", share / 100), ("p05_mm", p05), ("p25_mm", p25), ("median_mm", median),
                                ("p75_mm", p75), ("p95_mm", p95)):
                self.assertAlmostEqual(float(row[name]), value, delta=1e-5 * max(1.0, abs(value)))

    def test_the_numbers_of_boxes_are_those_of_all_rows_on_a_fine_lattice_too(self):
        self.answer("model", "train", self.project, "Expert", "--method", "exact", "--grid", "44", "--name", "fine")
        self.answer("rollout", "run", self.project, "fine", "--starts", "all", "--out", self.folder / "all.csv",
                    "--band", self.folder / "run.csv")
        with open(self.folder / "all.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 44**3)
        self.plot("fine", "--starts", "all", kind="boxes", out="boxes.csv")
        with open(self.folder / "boxes.csv", newline="") as file:
            boxes = list(csv.DictReader(file))
        columns = {"steps": "steps", "length": "length_mm", "straightness": "straightness",
                   "max_deviation": "max_deviation_mm", "mean_deviation": "mean_deviation_mm", "frechet": "frechet_mm",
                   "hausdorff": "hausdorff_mm", "dtw": "dtw_mm", "reward": "reward_sum", "outside": "outside_steps",
                   "divergence": "divergence_step", "clearance": "clearance_mm"}
        self.assertEqual({box["measure"] for box in boxes}, set(columns))
        for box in boxes:
            values = sorted(float(row[columns[box["measure"]]]) for row in rows if row["end"] == box["end"] and
                            not (box["measure"] == "divergence" and float(row["divergence_step"]) < 0))
            self.assertEqual(int(box["n"]), len(values))
            for name, value in (("least", values[0]), ("median", statistics.median(values)), ("most", values[-1])):
                self.assertAlmostEqual(float(box[name]), value, delta=2e-5 * max(1.0, abs(value)))
        self.plot("fine", "--starts", "all", kind="band", out="band.csv")
        with open(self.folder / "band.csv", newline="") as file:
            drawn = [float(row["value"]) for row in csv.DictReader(file)
                     if row["curve"] == "Deviation from the expert" and row["line"] == "fine"]
        with open(self.folder / "run.csv", newline="") as file:
            run = [float(row["median_mm"]) for row in csv.DictReader(file)]
        self.assertEqual(len(drawn), len(run))
        for one, other in zip(drawn, run):
            self.assertAlmostEqual(one, other, delta=1e-5 * max(1.0, other))

    def test_a_report_is_one_page_with_the_numbers_of_the_command_line_and_all_figures_in_it(self):
        out = self.folder / "r.html"
        self.answer("rollout", "report", self.project, "paper", "A exact", "--starts", "around:2", "--out", out)
        page = out.read_text()
        self.assertEqual(page.count("<svg"), 4)
        root = ElementTree.fromstring(re.sub(r"<!doctype html>|<meta[^>]*>", "", page))
        ids = [one.get("id") for one in root.iter() if one.get("id")]
        self.assertEqual(len(ids), len(set(ids)))
        told = self.answer("rollout", "run", self.project, "paper", "--starts", "around:2")
        self.assertIn(f"<td>A: paper</td><td>{told['count']}</td><td>{told['arrived']}</td>", page)
        pair = self.answer("rollout", "compare", self.project, "paper", "A exact", "--starts", "around:2")
        self.assertIn(f"only A arrives {pair['wins_a']} times, only B {pair['wins_b']} times", page)
        self.assertNotIn("http://", re.sub(r"http://www.w3.org/[^\"]*", "", page))  # nothing is fetched
        self.answer("rollout", "report", self.project, "paper", "A exact", "--starts", "around:2",
                    "--out", self.folder / "again.html")
        self.assertEqual(page, (self.folder / "again.html").read_text())
        # Of too few starts for a band it says so, and the rest is there.
        self.answer("rollout", "report", self.project, "paper", "--starts", "cells:1", "--out", out)
        self.assertIn("Not drawn: a band needs", out.read_text())
        self.refused("rollout", "report", self.project, "paper", "--out", self.folder / "r.pdf", code=USAGE)

    def test_what_is_kept_or_chosen_changes_the_figure(self):
        def drawn(*arguments, kind):
            self.plot("paper", *arguments, kind=kind, out="k.svg")
            return (self.folder / "k.svg").read_bytes()
        for kind in ("axes", "multiples"):
            self.assertNotEqual(drawn(kind=kind), drawn("--keep", "steps:0..6", kind=kind))
        self.assertNotEqual(drawn(kind="multiples"), drawn("--ascending", kind="multiples"))
        self.assertNotEqual(drawn(kind="boxes"), drawn("--measure", "steps,length", kind="boxes"))

    def test_what_would_be_ignored_or_is_unknown_is_refused(self):
        for extra, kind, out, saying in ((["--measure", "steps"], "axes", "a.pdf", "--measure is not for --kind axes"),
                                         (["--starts", "all"], "map", "a.pdf", "--starts is not for --kind map"),
                                         (["--measure", "end"], "boxes", "a.pdf", "no box is drawn of end"),
                                         (["--measure", "speed"], "boxes", "a.pdf", "is no measure of a rollout"),
                                         (["--keep", "steps"], "axes", "a.pdf", "is no range of a measure"),
                                         ([], "pie", "a.pdf", "is no plot of rollouts"),
                                         ([], "axes", "a.csv", "drawn as .png, .svg or .pdf"),
                                         (["--dpi", "300"], "axes", "a.pdf", "--dpi is of a .png"),
                                         (["--preset", "poster"], "axes", "a.pdf", "no figure preset"),
                                         (["--keep", "steps:9000..9001"], "multiples", "a.pdf", "there is no picture"),
                                         (["--starts", "around"], "axes", "a.pdf", "file:F.csv")):
            with self.subTest(kind=kind, extra=extra):
                self.refused("rollout", "plot", self.project, "paper", *extra, "--kind", kind, "--out", self.folder / out,
                             code=USAGE, saying=saying)
                self.assertFalse((self.folder / out).exists())

    def test_an_ending_in_capitals_is_the_same_kind_of_file(self):
        self.answer("field", "export", self.project, "A exact", "--out", self.folder / "F.PNG")
        self.assertTrue((self.folder / "F.PNG").read_bytes().startswith(b"\x89PNG"))
        self.answer("demo", "plot", self.project, "Expert", "--dpi", "100", "--out", self.folder / "C.PNG")
        self.assertTrue((self.folder / "C.PNG").read_bytes().startswith(b"\x89PNG"))
        self.answer("model", "curve", self.project, "paper", "--out", self.folder / "C.Csv")
        self.assertTrue((self.folder / "C.Csv").read_text().startswith("epoch,"))

    def test_rollouts_are_the_same_numbers_in_csv_json_and_hdf5(self):
        texts = {"end", "last_moves", "state_hash", "model_hash", "seed"}
        base = ["rollout", "run", self.project, "paper", "--starts", "around:2"]
        for erring in ([], ["--epsilon", "0.2", "--runs", "3"]):
            for ending in ("csv", "json", "h5"):
                self.answer(*base, *erring, "--out", self.folder / f"r.{ending}")
            with open(self.folder / "r.csv", newline="") as file:
                rows = list(csv.DictReader(file))
            stored = json.loads((self.folder / "r.json").read_text())
            self.assertEqual((stored["model"], stored["starts"]), ("paper", "around:2"))
            self.assertEqual(stored["columns"], list(rows[0]))
            self.assertEqual(len(stored["rollouts"]), len(rows))
            with h5py.File(self.folder / "r.h5") as file:
                self.assertEqual(file.attrs["model"], "paper")
                self.assertEqual(set(file), set(rows[0]))
                for name in rows[0]:
                    column = file[name].asstr()[()] if name in texts else file[name][()]
                    for row, one, value in zip(rows, stored["rollouts"], column):
                        if name in texts:
                            self.assertEqual((one[name], value), (row[name], row[name]))
                        elif row[name] == "":
                            self.assertIsNone(one[name])
                            self.assertTrue(numpy.isnan(value))
                        else:
                            self.assertEqual((one[name], float(value)), (float(row[name]), float(row[name])))
                self.assertEqual(file["steps"].dtype, numpy.int64)

    def test_rollouts_of_the_simulator_are_such_files_too_but_only_a_csv_goes_on(self):
        base = ["rollout", "physics", self.project, "A exact", "--starts", "cells:5566"]
        for ending in ("csv", "json", "h5"):
            self.answer(*base, "--out", self.folder / f"p.{ending}")
        with open(self.folder / "p.csv", newline="") as file:
            row, = csv.DictReader(file)
        one, = json.loads((self.folder / "p.json").read_text())["rollouts"]
        self.assertEqual((one["state_hash"], one["duration_s"]), (row["state_hash"], float(row["duration_s"])))
        with h5py.File(self.folder / "p.h5") as file:
            self.assertEqual(file["state_hash"].asstr()[0], row["state_hash"])
            self.assertEqual(file["length_m"][0], float(row["length_m"]))
        self.refused(*base, "--resume", "--out", self.folder / "p.json", code=USAGE, saying="only")

    def test_ends_add_up_and_arrivals_are_told_by_step(self):
        told = self.answer("rollout", "run", self.project, "paper", "--starts", "all", "--out", self.folder / "all.csv")
        self.assertEqual(told["arrived"] + told["looped"] + told["dead_end"] + told["outside"], told["count"])
        with open(self.folder / "all.csv", newline="") as file:
            ends = collections.Counter(row["end"] for row in csv.DictReader(file))
        self.assertEqual((ends["dead end"], ends["outside the safe set"]), (told["dead_end"], told["outside"]))
        self.assertGreater(told["outside"], 0)
        words = trocar("rollout", "run", self.project, "A exact", "--spread").stdout
        self.assertRegex(words, r"arrived by step: .*\(100\.0 %\) within \d+ steps")


class Numbers(CommandLineTest):
    def test_every_file_of_numbers_holds_the_same_field(self):
        project = self.recorded_project()
        for layer in ("value", "q+x", "basin"):
            for ending in ("npy", "vti", "h5"):
                self.answer("field", "export", project, "A exact", "--layer", layer, "--out", self.folder / f"f.{ending}")
            field = numpy.load(self.folder / "f.npy")
            self.assertEqual(field.shape, (22, 22, 22))

            image = ElementTree.parse(self.folder / "f.vti").getroot().find("ImageData")
            self.assertEqual(image.get("WholeExtent"), "0 22 0 22 0 22")
            self.assertEqual(image.get("Spacing"), "2.5 2.5 2.5")
            self.assertEqual(image.get("Origin"), "-37.5 -52.5 2.5")
            array = image.find("Piece/CellData/DataArray")
            self.assertEqual((array.get("type"), array.get("Name"), array.get("format")), ("Float64", layer, "binary"))
            raw = base64.b64decode(array.text, validate=True)
            self.assertEqual(struct.unpack("<I", raw[:4])[0], len(raw) - 4)
            # VTK's x runs fastest.
            numpy.testing.assert_array_equal(numpy.frombuffer(raw[4:], "<f8").reshape(22, 22, 22).transpose(2, 1, 0), field)

            with h5py.File(self.folder / "f.h5") as file:
                stored = file[layer]
                numpy.testing.assert_array_equal(stored[()], field)
                self.assertEqual(list(stored.attrs["origin_mm"]), [-37.5, -52.5, 2.5])
                self.assertEqual(stored.attrs["cell_mm"], 2.5)
                self.assertEqual(stored.attrs["model"], "A exact")
                self.assertEqual(stored.attrs["layer"], layer)
                self.assertEqual("categories" in stored.attrs, layer == "basin")
                self.assertEqual(file["z_mm"][0], 3.75)
                self.assertEqual(file["x_mm"][21], 16.25)


class Tables(CommandLineTest):
    def fields(self, project, model, layers):
        fields = []
        for layer in layers:
            self.answer("field", "export", project, model, "--layer", layer, "--out", self.folder / "field.npy")
            fields.append(numpy.load(self.folder / "field.npy"))
        return fields

    def test_a_q_table_goes_out_and_comes_back_the_same(self):
        project = self.recorded_project()
        layers = ("q+x", "q-x", "q+y", "q-y", "q+z", "q-z", "margin", "policy", "basin", "steps")
        before = self.fields(project, "A exact", layers)
        for ending in ("npy", "csv"):
            table = self.folder / f"q.{ending}"
            told = self.answer("model", "export", project, "A exact", "--kind", "q", "--out", table)
            self.assertIn("+x -x +y -y +z -z", told["order"])
            made = self.answer("model", "import", project, table, "--kind", "q", "--demo", "Expert", "--name", f"back {ending}")
            self.assertEqual(made["method"], "imported")
            self.assertTrue(made["arrival_from_start"])
            for layer, one, other in zip(layers, before, self.fields(project, f"back {ending}", layers)):
                numpy.testing.assert_array_equal(one, other, err_msg=layer)
        table = numpy.load(self.folder / "q.npy")
        self.assertEqual(table.shape, (22, 22, 22, 6))
        numpy.testing.assert_array_equal(table[..., 4], before[4])
        # The flat shape is taken, too, and the model is one as any other.
        numpy.save(self.folder / "flat.npy", table.reshape(-1, 6))
        self.answer("model", "import", project, self.folder / "flat.npy", "--kind", "q", "--demo", "Expert")
        compared = self.answer("model", "compare", project, "A exact", "flat")
        self.assertEqual(compared["policy_changed"], 0)
        self.assertEqual(compared["success"]["change_percent"], 0)
        self.assertIsNone(compared["mean_reward"]["b"])  # a Q-table says nothing of it
        self.assertEqual(compared["mean_margin"]["b"], compared["mean_margin"]["a"])
        rolled = self.answer("rollout", "run", project, "flat", "--starts", "around:1")
        expected = self.answer("rollout", "run", project, "A exact", "--starts", "around:1")
        self.assertEqual(rolled["arrived"], expected["arrived"])
        self.answer("field", "export", project, "flat", "--layer", "value", "--preset", "column", "--out", self.folder / "v.png")

    def test_rewards_come_back_from_a_table_and_from_a_field(self):
        project = self.recorded_project()
        reward, = self.fields(project, "A exact", ["reward"])
        self.answer("model", "export", project, "A exact", "--kind", "theta", "--out", self.folder / "theta.npy")
        self.answer("field", "export", project, "A exact", "--layer", "reward", "--out", self.folder / "field.csv")
        for name in ("theta.npy", "field.csv"):
            self.answer("model", "import", project, self.folder / name, "--kind", "theta", "--demo", "Expert", "--name", name)
            back, = self.fields(project, name, ["reward"])
            numpy.testing.assert_array_equal(back, reward)

    def test_what_is_no_such_table_is_refused_in_one_sentence(self):
        project = self.recorded_project()

        def refused(array, kind, saying, code=WORLD):
            numpy.save(self.folder / "bad.npy", array)
            self.refused("model", "import", project, self.folder / "bad.npy", "--kind", kind, "--demo", "Expert", code=code,
                         saying=saying)

        refused(numpy.zeros((22, 22, 6)), "q", "expected 22x22x22x6 or 10648x6, found 22x22x6; the order is x, y, z, action")
        refused(numpy.zeros((44, 44, 44)), "theta", "expected 22x22x22 or 10648, found 44x44x44")
        refused(numpy.full((22, 22, 22, 6), numpy.nan), "q", "all is NaN", code=USAGE)
        refused(numpy.full((22, 22, 22), 0.5), "theta", "above 0 the agent would go round", code=USAGE)
        refused(numpy.zeros((22, 22, 22), dtype=">f8"), "theta", "little-endian")
        (self.folder / "bad.txt").write_text("1,2,3\n")
        self.refused("model", "import", project, self.folder / "bad.txt", "--kind", "q", "--demo", "Expert", code=USAGE,
                     saying="a table is a .npy or a .csv")
        self.refused("model", "import", project, self.folder / "bad.npy", "--kind", "v", "--demo", "Expert", code=USAGE,
                     saying="use q or theta")
        self.assertEqual(len(self.answer("model", "list", project)["models"]), 1)


if __name__ == "__main__":
    unittest.main()
