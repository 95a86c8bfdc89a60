"""`tools/run` writes into one folder again and again; what a user did there must survive it."""
import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]


class OwnOutputs(unittest.TestCase):
    def setUp(self):
        parent = pathlib.Path(tempfile.mkdtemp(prefix="trocar_outputs_"))
        self.addCleanup(shutil.rmtree, parent, ignore_errors=True)
        self.folder = parent / "the tour"
        self.kept = parent / "the tour-kept-1"

    def tool(self, verb):
        return subprocess.run([ROOT / "tools" / "own_outputs", verb, self.folder], check=True, capture_output=True,
                              text=True).stdout

    def make(self):
        (self.folder / "inner").mkdir(parents=True)
        for name in ("tour.trocar", "a film.mp4", "inner/x.csv", "-dash"):
            (self.folder / name).write_text(name)
        self.tool("note")

    def test_outputs_that_nobody_touched_make_way(self):
        self.assertEqual(self.tool("clear"), "")
        for _ in range(2):
            self.make()
            self.assertEqual(self.tool("clear"), "")
            self.assertFalse(self.folder.exists())
        self.assertFalse(self.kept.exists())

    def test_whatever_a_user_changed_is_kept_and_said(self):
        changes = {
            "edited": lambda: (self.folder / "tour.trocar").write_text("edited"),
            "added": lambda: (self.folder / "own.mp4").write_text("own"),
            "in use": lambda: (self.folder / "tour.trocar-wal").write_text(""),
            "removed": lambda: (self.folder / "inner/x.csv").unlink(),
            "unknown origin": lambda: (self.folder / ".made_by_run").unlink(),
        }
        for name, change in changes.items():
            with self.subTest(name):
                self.make()
                change()
                before = sorted((path.relative_to(self.folder), path.read_text())
                                for path in self.folder.rglob("*") if path.is_file())
                self.assertIn("the tour-kept-1", self.tool("clear"))
                self.assertFalse(self.folder.exists())
                after = sorted((path.relative_to(self.kept), path.read_text())
                               for path in self.kept.rglob("*") if path.is_file())
                self.assertEqual(before, after)
                shutil.rmtree(self.kept)

    def test_an_earlier_kept_folder_is_not_touched(self):
        self.kept.mkdir()
        (self.kept / "mine").write_text("mine")
        self.make()
        (self.folder / "own").write_text("own")
        self.assertIn("the tour-kept-2", self.tool("clear"))
        self.assertEqual([path.name for path in self.kept.iterdir()], ["mine"])

    def test_run_takes_its_folder_only_through_it(self):
        text = (ROOT / "tools" / "run").read_text()
        self.assertNotIn("rm -rf", text)
        self.assertLess(text.index("own_outputs clear out/tour"), text.index("--out out/tour"))
        self.assertLess(text.index("--out out/tour"), text.index("own_outputs note out/tour"))


if __name__ == "__main__":
    unittest.main()
