"""The window: every script of tests/gui without a display, and once a real window under a virtual X server."""
import os
import pathlib
import re
import shutil
import subprocess
import time
import unittest

from cli_support import DONE, TROCAR, CommandLineTest

# Those of the acceptance stories need more than a project: programs of their own run them.
SCRIPTS = sorted(script for script in (pathlib.Path(__file__).resolve().parent.parent / "gui").glob("*.ui")
                 if not re.match(r"J\d_", script.name))
# Ends what hangs; how long a window takes on a busy machine is not what is tested.
PATIENCE_S = 300
WORKBENCH = pathlib.Path(TROCAR).with_name("trocar-workbench")


class GuiScriptsTest(CommandLineTest):
    def test_every_script_runs_to_its_end(self):
        self.assertTrue(SCRIPTS)
        for script in SCRIPTS:
            with self.subTest(script=script.name):
                picture = self.folder / (script.stem + ".png")
                self.answer("ui", "run", "--project", self.recorded_project(), "--script", script, "--screenshot", picture,
                            code=DONE)
                self.assertGreater(picture.stat().st_size, 10_000)


class ManualTest(CommandLineTest):
    def test_the_manual_is_written_with_a_picture_of_every_panel(self):
        folder = self.folder / "manual"
        answer = self.answer("ui", "manual", "--out", folder, "--project", self.recorded_project(), code=DONE)
        pictures = re.findall(r"\]\((panels/.*\.png)\)", (folder / "panels.md").read_text())
        self.assertEqual(len(pictures), answer["panels"])
        for picture in pictures:
            self.assertGreater((folder / picture).stat().st_size, 5_000)
        self.assertIn("`trocar undo P`", (folder / "commands.md").read_text())
        self.assertIn("Blender-like", (folder / "keys.md").read_text())
        for link in re.findall(r"\]\((\w+\.md)\)", (folder / "index.md").read_text()):
            self.assertTrue((folder / link).exists())

    def test_a_manual_has_no_place_in_a_file(self):
        blocked = self.folder / "file"
        blocked.write_text("mine")
        self.refused("ui", "manual", "--out", blocked / "manual", "--project", self.recorded_project(), code=3,
                     saying="manual")
        self.assertEqual(blocked.read_text(), "mine")


@unittest.skipUnless(WORKBENCH.exists() and shutil.which("Xvfb") and shutil.which("xdotool"),
                     "needs trocar-workbench, Xvfb and xdotool")
class RealWindowTest(CommandLineTest):
    def setUp(self):
        super().setUp()
        read_end, write_end = os.pipe()
        # A server that resets when its last client leaves, as xdotool does at each look, turns away who comes meanwhile.
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(write_end), "-screen", "0", "1280x800x24", "-nolisten", "tcp",
                                        "-noreset"],
                                       pass_fds=[write_end], stderr=subprocess.DEVNULL)
        os.close(write_end)
        self.addCleanup(self.server.wait)
        self.addCleanup(self.server.terminate)
        with os.fdopen(read_end) as answer:
            self.display = ":" + answer.readline().strip()

    def xdotool(self, *arguments):
        return subprocess.run(["xdotool", *arguments], capture_output=True, text=True, timeout=60,
                              env={**os.environ, "DISPLAY": self.display})

    def test_a_window_that_is_told_to_end_ends_in_order(self):
        environment = {**os.environ, "DISPLAY": self.display, "XDG_CONFIG_HOME": str(self.folder)}
        project = self.recorded_project()
        window = subprocess.Popen([WORKBENCH, project], env=environment)
        self.addCleanup(window.kill)
        deadline = time.monotonic() + PATIENCE_S
        # Its title names the project once it runs.
        name = pathlib.Path(project).name
        while window.poll() is None and not self.xdotool("search", "--name", name).stdout.strip():
            self.assertLess(time.monotonic(), deadline, "no window appeared")
            time.sleep(0.2)
        window.terminate()
        self.assertEqual(window.wait(timeout=PATIENCE_S), 0)

    def test_a_window_opens_and_closes_on_its_key(self):
        environment = {**os.environ, "DISPLAY": self.display, "XDG_CONFIG_HOME": str(self.folder)}
        window = subprocess.Popen([WORKBENCH, self.recorded_project()], env=environment)
        self.addCleanup(window.kill)
        found = ""
        deadline = time.monotonic() + PATIENCE_S
        while not found and time.monotonic() < deadline and window.poll() is None:
            found = self.xdotool("search", "--onlyvisible", "--name", "rocar").stdout.strip()
            time.sleep(0.2)
        self.assertTrue(found, "no window appeared")
        # There is no window manager to tell when the window listens: ask again until it has heard.
        while window.poll() is None and time.monotonic() < deadline:
            self.xdotool("windowfocus", found.splitlines()[0])
            self.xdotool("key", "--delay", "100", "ctrl+q")
            time.sleep(1.0)
        self.assertEqual(window.poll(), 0, "the window did not close on Ctrl+Q")


if __name__ == "__main__":
    unittest.main()
