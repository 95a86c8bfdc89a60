"""HDF5 through h5py: what `demo export` writes has robomimic's layout, and what others write is read or refused."""
import json
import os
import sys
import unittest

try:
    import h5py
    import numpy
except ImportError:  # another Python than Debian's comes first: python3-h5py belongs to that
    if sys.executable == "/usr/bin/python3":
        raise
    os.execv("/usr/bin/python3", ["/usr/bin/python3", *sys.argv])

from cli_support import DONE, USAGE, WORLD, CommandLineTest, trocar


class Robomimic(CommandLineTest):
    def exported(self):
        """Three demonstrations in one file: as recorded, trimmed, and a copy of that."""
        project = self.recorded_project()
        self.answer("demo", "copy", project, "Expert", "--name", "Trimmed")
        self.answer("demo", "edit", project, "Trimmed", "trim", "--from", "0.5", "--to", "1.5")
        self.answer("demo", "copy", project, "Trimmed", "--name", "Third")
        out = self.folder / "all.hdf5"
        answer = self.answer("demo", "export", project, "Expert", "Trimmed", "Third", out, "--mask", "train=Expert",
                             "--mask", "train=Third", "--mask", "valid=Trimmed")
        return project, out, answer

    def test_the_layout_is_robomimics(self):
        _, out, answer = self.exported()
        self.assertEqual(answer["demonstrations"], 3)
        self.assertIn("equal to the bit", answer["reread"])
        self.assertTrue(answer["lossless"])
        self.assertTrue(any("gates" in part for part in answer["lossy"]))
        with h5py.File(out) as file:
            data = file["data"]
            self.assertEqual(sorted(data), ["demo_0", "demo_1", "demo_2"])
            self.assertIn("env_name", json.loads(data.attrs["env_args"]))
            self.assertEqual(data.attrs["total"], sum(data[name].attrs["num_samples"] for name in data))
            self.assertEqual(data.attrs["total"], answer["samples"])
            for demo in data.values():
                self.check_demonstration(demo)
            filters = {key: [name.decode("utf-8") for name in numpy.array(file["mask"][key][:])] for key in file["mask"]}
            self.assertEqual(filters["train"], ["demo_0", "demo_2"])
            self.assertEqual(filters["valid"], ["demo_1"])
            self.assertEqual(filters["operator_scripted"], ["demo_0", "demo_1", "demo_2"])

    def check_demonstration(self, demo):
        rows = demo.attrs["num_samples"]
        actions = demo["actions"][()]
        self.assertEqual(actions.shape, (rows, 14))
        self.assertTrue((numpy.abs(actions) <= 1.0).all())
        self.assertGreater(numpy.abs(actions).max(), 0.1)
        for key in ("states", "rewards", "dones"):
            self.assertEqual(len(demo[key]), rows)
        self.assertEqual(list(numpy.flatnonzero(demo["dones"])), [rows - 1])
        widths = {"eef_pos": 3, "eef_quat": 4, "gripper_qpos": 1, "joint_pos": 6}
        for robot in ("robot0", "robot1"):
            for key, width in widths.items():
                self.assertEqual(demo[f"obs/{robot}_{key}"].shape, (rows, width))
            quaternions = demo[f"obs/{robot}_eef_quat"]
            self.assertEqual(quaternions.attrs["quaternion_order"], "xyzw")
            numpy.testing.assert_allclose(numpy.linalg.norm(quaternions, axis=1), 1.0, atol=1e-5)
        self.assertEqual(demo["obs/object"].shape, (rows, 42))
        # What an action says is what the setpoint does: by the scale and offset that stand beside it.
        columns = list(demo["states"].attrs["columns"])
        scale, offset = demo["actions"].attrs["scale"], demo["actions"].attrs["offset"]
        for action, column in ((0, "left_setpoint_x_m"), (9, "right_setpoint_z_m")):
            path = demo["states"][:, columns.index(column)]
            numpy.testing.assert_allclose(path[:-1] + scale[action] * actions[:-1, action], path[1:], atol=1e-12)
        for action, column in ((6, "left_setpoint_jaw_rad"), (13, "right_setpoint_jaw_rad")):
            jaw = demo["states"][:, columns.index(column)]
            numpy.testing.assert_allclose(scale[action] * actions[:-1, action] + offset[action], jaw[1:], atol=1e-12)

    def test_what_was_exported_comes_back(self):
        _, out, _ = self.exported()
        other = self.folder / "other.trocar"
        self.answer("new", other)
        answer = self.answer("demo", "import", other, out)
        self.assertEqual(answer["imported"], 3)
        self.assertEqual([one["name"] for one in answer["demonstrations"]], ["Expert", "Trimmed", "Third"])
        shown = self.answer("demo", "show", other, "Expert")
        self.assertEqual(shown["hash"], self.answer("demo", "show", self.recorded_project(), "Expert")["hash"])
        self.assertTrue(self.answer("demo", "replay", other, "Expert")["verified"])
        for only, count in (("train", 2), ("demo_1", 1)):
            part = self.answer("demo", "import", other, out, "--only", only, "--dry-run")
            self.assertEqual(len(part.get("demonstrations", [part])), count)
            self.assertEqual(part["imported"], 0)
        self.refused("demo", "import", other, out, "--only", "demo_7", code=USAGE, saying="demo_7")

    def test_wrong_exports_are_refused_in_one_sentence(self):
        project = self.recorded_project()
        out = self.folder / "out.hdf5"
        self.refused("demo", "export", project, "Expert", "Expert", out, code=USAGE, saying="twice")
        self.refused("demo", "export", project, "Expert", out, "--mask", "train", code=USAGE, saying="KEY=DEMO")
        self.refused("demo", "export", project, "Expert", out, "--mask", "a/b=Expert", code=USAGE, saying="filter key")
        self.refused("demo", "export", project, "Expert", "1", "2", self.folder / "out.csv", code=USAGE)
        self.refused("demo", "export", project, "Expert", self.folder / "no" / "out.hdf5", code=WORLD)
        self.refused("demo", "export", project, "Expert", project, "--format", "hdf5", code=USAGE, saying="project itself")
        self.assertEqual(self.leftovers(), ["recorded.trocar"])


class Foreign(CommandLineTest):
    def robosuite(self, file, rows=40, name="demo_0"):
        """A demonstration as robosuite writes it: 20 Hz, a picture that nobody asked for, quaternions x, y, z, w."""
        t = numpy.arange(rows) / 20.0
        obs = file.create_group(f"data/{name}/obs")
        obs["robot0_eef_pos"] = numpy.stack([0.01 * t, 0 * t, 0.03 + 0 * t], axis=1)
        obs["robot0_eef_quat"] = numpy.tile([1.0, 0.0, 0.0, 0.0], (rows, 1))
        obs["robot0_gripper_qpos"] = numpy.stack([0.01 * t, -0.01 * t], axis=1)
        obs["agentview_image"] = numpy.zeros((rows, 8, 8, 3), dtype="uint8")
        file[f"data/{name}/actions"] = numpy.zeros((rows, 7))
        file[f"data/{name}"].attrs["num_samples"] = rows
        file["data"].attrs["env_args"] = json.dumps({"env_name": "Lift", "type": 1, "env_kwargs": {"control_freq": 20}})

    def test_a_robosuite_file_is_read_and_says_what_was_not_known(self):
        path = self.folder / "lift.hdf5"
        with h5py.File(path, "w") as file:
            self.robosuite(file)
            self.robosuite(file, rows=60, name="demo_1")
            file["mask/train"] = numpy.array(["demo_1"], dtype="S")
        project = self.empty_project()
        answer = self.answer("demo", "import", project, path)
        self.assertEqual(answer["imported"], 2)
        first, second = answer["demonstrations"]
        self.assertEqual(first["name"], "lift demo_0")
        self.assertAlmostEqual(first["duration_s"], 39 / 20)
        text = " | ".join(first["found"] + first["changed"] + first["lossy"])
        for words in ("20 samples a second", "x, y, z, w", "the right arm", "agentview_image (it has too many dimensions)",
                      "the blocks"):
            self.assertIn(words, text)
        self.assertEqual((first["notes"], second["notes"]), (0, 1))

    def test_nothing_outside_of_the_file_is_followed(self):
        secret = self.folder / "secret.hdf5"
        with h5py.File(secret, "w") as file:
            self.robosuite(file)
        raw = self.folder / "raw.bin"
        raw.write_bytes(numpy.ones((40, 3)).tobytes())
        path = self.folder / "links.hdf5"
        with h5py.File(path, "w", libver="latest") as file:
            file.create_group("data/demo_0/obs")
            obs = file["data/demo_0/obs"]
            obs["robot0_eef_pos"] = h5py.ExternalLink(secret.name, "/data/demo_0/obs/robot0_eef_pos")
            obs["eef_pos"] = h5py.SoftLink("/data/demo_0/obs/eef_pos")
            obs["loop"] = h5py.SoftLink("/data")
            obs["again"] = file["data"]  # a hard link back up
            layout = h5py.VirtualLayout(shape=(40, 3), dtype="f8")
            layout[:] = h5py.VirtualSource(str(secret), "data/demo_0/obs/robot0_eef_pos", shape=(40, 3))
            obs.create_virtual_dataset("ee_pos", layout)
            obs.create_dataset("robot1_eef_pos", (40, 3), dtype="f8", external=[(str(raw), 0, 960)])
        project = self.empty_project()
        before = self.answer("info", project)["hash"]
        self.refused("demo", "import", project, path, code=WORLD, saying="no tool position")
        self.assertEqual(self.answer("info", project)["hash"], before)

    def test_absurd_sizes_and_broken_files_are_refused(self):
        project = self.empty_project()
        path = self.folder / "bad.hdf5"

        def huge(file):
            obs = file.create_group("data/demo_0/obs")
            obs.create_dataset("robot0_eef_pos", (1 << 50, 3), chunks=(16, 3), dtype="f8")

        def deep(file):
            group = file.create_group("data")
            for _ in range(200):
                group = group.create_group("d")

        def mute(file):
            file["data/demo_0/obs/robot0_eef_pos"] = numpy.full((10, 3), numpy.nan)

        def short(file):
            file["data/demo_0/obs/robot0_eef_pos"] = numpy.zeros((1, 3))

        def words(file):
            file["data/demo_0/obs/robot0_eef_pos"] = numpy.array(["a", "b"], dtype="S")

        for make in (huge, deep, mute, short, words, lambda file: None):
            with self.subTest(make.__name__), h5py.File(path, "w") as file:
                make(file)
                file.close()
                self.refused("demo", "import", project, path, code=WORLD)
        good = self.folder / "good.hdf5"
        with h5py.File(good, "w") as file:
            self.robosuite(file)
        whole = good.read_bytes()
        for at in range(0, len(whole), len(whole) // 25):
            path.write_bytes(whole[:at] + b"\xff" * 8 + whole[at + 8:])
            done = trocar("demo", "import", project, path, "--dry-run")
            self.assertIn(done.returncode, (DONE, WORLD), done.stderr)
            path.write_bytes(whole[:at])
            self.refused("demo", "import", project, path, code=WORLD)
        self.assertEqual(self.answer("demo", "list", project)["demonstrations"], [])


if __name__ == "__main__":
    unittest.main()
