"""What the tests of the command line share: run it, read its answer, make a project once."""
import json
import os
import pathlib
import shutil
import subprocess
import tempfile
import unittest

TROCAR = os.path.abspath(os.environ.get("TROCAR", "build/release/bin/trocar"))
DONE, CHECK_FAILED, USAGE, WORLD = 0, 1, 2, 3
TESTS = pathlib.Path(__file__).resolve().parent.parent


def trocar(*arguments, **keywords):
    """Runs the program and returns the finished process with its text."""
    return subprocess.run([TROCAR, *map(str, arguments)], capture_output=True, encoding="utf-8", errors="replace", timeout=300, **keywords)


class CommandLineTest(unittest.TestCase):
    """Each test gets an empty folder; a recorded project is made once for all and copied."""

    template = None

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="trocar_cli_"))
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def answer(self, *arguments, code=DONE):
        """The JSON answer of a command that must end with `code`."""
        done = trocar(*arguments, "--json")
        self.assertEqual(done.returncode, code, f"{arguments}: {done.stderr}")
        return json.loads(done.stdout)

    def refused(self, *arguments, code, saying=""):
        """A command must end with `code` and one sentence on standard error; nothing on standard output."""
        done = trocar(*arguments)
        self.assertEqual(done.returncode, code, f"{arguments}: {done.stdout}{done.stderr}")
        self.assertEqual(done.stdout, "")
        errors = [line for line in done.stderr.splitlines() if line.startswith("trocar: ")]
        self.assertEqual(len(errors), 1, done.stderr)
        self.assertFalse(errors[0].endswith("."), errors[0])
        self.assertIn(saying, errors[0])
        return errors[0]

    def play(self, script, project, text=None):
        """Plays tests/gui/`script`, or its `text`, in the window without a display and in the test's folder, where it stays."""
        copied = self.folder / script
        copied.write_text(text or (TESTS / "gui" / script).read_text())
        here = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, here)
        self.answer("ui", "run", "--project", project.name, "--script", copied.name, "--size", "1600x1000")

    def empty_project(self):
        project = self.folder / "empty.trocar"
        self.answer("new", project)
        return project

    def recorded_project(self):
        """A project with the demonstration `Expert` (id 1) and the exact model `A exact` (id 2)."""
        cls = CommandLineTest
        if cls.template is None:
            cls.template = pathlib.Path(tempfile.mkdtemp(prefix="trocar_cli_template_")) / "recorded.trocar"
            unittest.addModuleCleanup(shutil.rmtree, cls.template.parent, ignore_errors=True)
            self.answer("new", cls.template)
            cls.recorded = self.answer("demo", "record", cls.template, "--skill", "expert", "--seed", "1", "--name", "Expert")
            cls.trained = self.answer("model", "train", cls.template, "Expert", "--segment", "A", "--method", "exact",
                                      "--name", "A exact")
        project = self.folder / "recorded.trocar"
        shutil.copy(cls.template, project)
        return project

    def leftovers(self):
        """What is in the folder, without SQLite's own companions."""
        return sorted(path.name for path in self.folder.iterdir() if not path.name.endswith(("-wal", "-shm")))
