"""What is done in the window is, to the bit, what its own "Copy as command" does: the commands are run on a copy of the
project, and both have one hash after every step."""
import json
import shlex
import shutil
import subprocess
import unittest

from cli_support import DONE, TROCAR, CommandLineTest

# Each step is one command of its own; free drags end wherever the mouse happens to be.
STEPS = [
    ["key Shift+Right", "key G", "frames 3", 'drag "View/Gizmo/Y" 37 3', "wait idle", "key Escape"],
    ["key Shift+Right", "key T", "frames 3", 'drag "View/Gizmo/Turn Z" 20 10', "wait idle", "key Escape"],
    ["key Shift+Right", "key Shift+Right", "key Shift+K"],
    ["key M"],
    ["key 3"],
    ["key ;"],
    ["key Shift+Right", "key '"],
    ['type "Timeline/Selection/From" "4.013"', 'type "Timeline/Selection/To" "6.021"', "key Ctrl+C", "wait idle",
     "key End", "key Ctrl+V"],
    ['drag "Timeline/In gate" 40 0'],
    ["key End", "key Shift+Left", "key O"],
    ['type "Timeline/Selection/From" "5.0"', 'type "Timeline/Selection/To" "6.0"', "key Delete"],
    ["key Ctrl+Z"],
    ['click "Tabs/Inspector"', "wait idle", """type "Inspector/Demonstration/Name" "odd $HOME 'name'\""""],
]


class SameAsCommandLine(CommandLineTest):
    def hash(self, project):
        return self.answer("info", project)["hash"]

    def commands(self, project):
        """What the status line offers to copy after each step."""
        dumps = [self.folder / f"step_{i}.json" for i in range(len(STEPS))]
        script = self.folder / "steps.ui"
        lines = ["key Ctrl+2", "wait idle"]
        for step, dump in zip(STEPS, dumps):
            lines += [*step, "wait idle", f'dump "{dump}"']
        script.write_text("\n".join(lines) + "\n")
        self.answer("ui", "run", "--project", project, "--script", script, code=DONE)
        copied = []
        for dump in dumps:
            items = json.loads(dump.read_text())
            command = next(item["value"] for item in items if item["path"] == "Status/Last command")
            self.assertNotIn(command, copied, "the step was no command of its own")
            copied.append(command)
        return copied

    def test_copied_commands(self):
        window = self.recorded_project()
        typed = window.rename(self.folder / "typed.trocar")
        window = self.folder / "window.trocar"
        shutil.copy(typed, window)
        for command in self.commands(window):
            words = [str(typed) if word.endswith("window.trocar") else word for word in shlex.split(command)]
            self.assertEqual(words[0], "trocar")
            done = subprocess.run([TROCAR, *words[1:]], capture_output=True, text=True, timeout=120)
            self.assertEqual(done.returncode, DONE, command + "\n" + done.stderr)
        self.assertEqual(self.hash(typed), self.hash(window))
        # Not the end alone: on the way back, too.
        for _ in range(6):
            for project in (typed, window):
                self.answer("undo", project)
            self.assertEqual(self.hash(typed), self.hash(window))


if __name__ == "__main__":
    unittest.main()
