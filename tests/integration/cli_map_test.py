"""Foreign tables through a map of their columns: proposed, corrected, used; and refused in one sentence."""
import json
import math
import struct
import unittest

from cli_support import DONE, USAGE, WORLD, CommandLineTest, trocar


class ColumnMaps(CommandLineTest):
    def table(self, name="hand.csv", rows=90):
        """30 Hz, millimetres, a gap, a row twice, a quaternion that changes sign, a column that nobody knows."""
        lines = ["time_s,left_x_mm,left_y_mm,left_z_mm,left_qx,left_qy,left_qz,left_qw,left_gripper_deg,remark"]
        for i in range(rows):
            t = i / 30 + (1.0 if i > rows // 2 else 0.0)
            sign = -1 if i == 10 else 1
            lines.append(f"{t:.6f},{10 * math.sin(i / 20):.4f},-20,{30 + i / 10:.3f},0,0,0,{sign},{i % 40},hello")
            if i == 20:
                lines.append(lines[-1])
        path = self.folder / name
        path.write_text("\n".join(lines) + "\n")
        return path

    def test_a_proposed_map_is_saved_corrected_and_used(self):
        project = self.empty_project()
        table = self.table()
        before = self.answer("info", project)["hash"]
        self.refused("demo", "import", project, table, code=WORLD, saying="--dry-run proposes a map")
        proposed = self.answer("demo", "import", project, table, "--dry-run")
        self.assertEqual(proposed["imported"], 0)
        self.assertEqual(proposed["map"]["left"]["position"]["unit"], "mm")
        self.assertEqual(self.answer("info", project)["hash"], before)
        self.assertIn('"left_x_mm"', trocar("demo", "import", project, table, "--dry-run").stdout)

        proposed["map"]["frame"]["mirror"] = "x"
        preset = self.folder / "hand.json"
        preset.write_text(json.dumps(proposed["map"]))
        answer = self.answer("demo", "import", project, table, "--map", preset, "--offset-mm", "0,0,5")
        self.assertEqual(answer["imported"], 1)
        text = " | ".join(answer["found"] + answer["changed"])
        for words in ("30 samples a second", "1 gap", "changes sign 2 times", "columns that nothing is made of: remark",
                      "1 row is left out, the first is line 23: the time is that of the row before"):
            self.assertIn(words, text)
        self.assertIn("the right arm (it stands at its ready pose)", answer["lossy"])
        out = self.folder / "out.csv"
        self.answer("demo", "export", project, "hand", out)
        names, first, second = (line.split(",") for line in out.read_text().splitlines()[:3])
        value = dict(zip(names, second))
        self.assertAlmostEqual(float(value["left_setpoint_x_m"]), -0.01 * math.sin(1 / 20), delta=1e-7)
        self.assertAlmostEqual(float(value["left_setpoint_z_m"]), 0.0351, delta=1e-9)

    def test_a_proposed_map_is_taken_and_kept_in_one_go(self):
        project = self.empty_project()
        table = self.table()
        kept = self.folder / "kept.json"
        answer = self.answer("demo", "import", project, table, "--map", "proposed", "--save-map", kept)
        self.assertEqual(answer["imported"], 1)
        self.assertEqual(json.loads(kept.read_text()), answer["map"])
        again = self.answer("demo", "import", project, table, "--map", kept, "--name", "Again")
        self.assertEqual(again["hash"], answer["hash"])
        # With --json there is nothing but JSON, also where the map itself is shown.
        done = trocar("demo", "import", project, table, "--dry-run", "--save-map", self.folder / "dry.json", "--json")
        self.assertEqual(json.loads(done.stdout)["map"], answer["map"])
        self.assertEqual(json.loads((self.folder / "dry.json").read_text()), answer["map"])
        own = self.folder / "own.csv"
        self.answer("demo", "export", project, answer["name"], own)
        self.refused("demo", "import", project, own, "--save-map", kept, code=USAGE, saying="no map to keep")
        self.assertEqual(self.answer("info", project)["demonstrations"], 2)

    def test_joints_of_an_array_go_through_the_arms_kinematics(self):
        project = self.empty_project()
        rows = [[0.1, 0.1, 0.12 + 0.0001 * i, 0.0, 0.1, 0.1, 0.3] for i in range(50)]
        header = f"{{'descr': '<f4', 'fortran_order': False, 'shape': ({len(rows)}, 7), }}\n".encode()
        array = self.folder / "joints.npy"
        array.write_bytes(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header +
                          b"".join(struct.pack("<f", value) for row in rows for value in row))
        preset = self.folder / "psm.json"
        preset.write_text(json.dumps({"time": {"rate_hz": 100},
                                      "right": {"joints": {"columns": [1, 2, 3, 4, 5, 6]}, "jaw": {"column": 7}}}))
        answer = self.answer("demo", "import", project, array, "--map", preset, "--name", "Joints")
        self.assertAlmostEqual(answer["duration_s"], 0.49)
        self.assertEqual(self.answer("demo", "import", project, array, "--map", preset, "--rate-hz", "50", "--dry-run")["duration_s"], 0.98)
        self.assertNotIn("the joints of the right arm", answer["lossy"])
        self.assertIn("joints", self.answer("demo", "import", project, array, "--dry-run")["map"]["left"])

    def test_wrong_maps_and_tables_are_refused_and_the_project_is_as_it_was(self):
        project = self.recorded_project()
        before = self.answer("info", project)["hash"]
        table = self.table()
        preset = self.folder / "map.json"
        good = {"time": {"column": "time_s"}, "left": {"position": {"columns": ["left_x_mm", "left_y_mm", "left_z_mm"], "unit": "mm"}}}
        cases = ({"time": {"column": "time_s"}}, {**good, "speed": 1}, {**good, "time": {"column": "when"}},
                 {**good, "left": {"position": {"columns": [1, 2], "unit": "mm"}}},
                 {**good, "left": {"position": {"columns": [1, 2, 3], "unit": "inch"}}})
        for case in cases:
            with self.subTest(case):
                preset.write_text(json.dumps(case))
                self.refused("demo", "import", project, table, "--map", preset, code=USAGE)
        preset.write_text("{")
        self.refused("demo", "import", project, table, "--map", preset, code=USAGE, saying=str(preset))
        self.refused("demo", "import", project, table, "--map", self.folder / "none.json", code=WORLD)
        preset.write_text(json.dumps(good))
        for text in ("", "time_s,left_x_mm,left_y_mm,left_z_mm\n", "time_s,left_x_mm,left_y_mm,left_z_mm\n0,1,2,three\n1,1,2,3\n",
                     "time_s,left_x_mm,left_y_mm,left_z_mm\n0,1,2,3\n0,1,2,3\n0,1,2,3\n"):
            with self.subTest(text):
                table.write_text(text)
                self.refused("demo", "import", project, table, "--map", preset, code=WORLD, saying=str(table))
        self.assertEqual(self.answer("info", project)["hash"], before)


if __name__ == "__main__":
    unittest.main()
