"""The command line against a world that says no: broken projects, broken files, full folders, interrupts."""
import os
import pathlib
import random
import shutil
import signal
import sqlite3
import subprocess
import tempfile
import time
import unittest

from cli_support import DONE, TROCAR, USAGE, WORLD, CommandLineTest, trocar

READERS = (["info"], ["history"], ["undo"], ["demo", "list"], ["model", "list"])


class BrokenProjects(CommandLineTest):
    def check_refused(self, path, code, saying=""):
        before = path.read_bytes() if path.is_file() else None
        for words in READERS:
            error = self.refused(*words, path, code=code, saying=saying)
            self.assertIn(str(path), error)
        if before is not None:
            self.assertEqual(path.read_bytes(), before)

    def test_missing(self):
        self.check_refused(self.folder / "none.trocar", WORLD)
        self.assertEqual(self.leftovers(), [])

    def test_foreign(self):
        path = self.folder / "foreign.trocar"
        for content in (b"", b"x", b"This is a letter, not a project.\n" * 100, os.urandom(20000)):
            path.write_bytes(content)
            self.check_refused(path, WORLD)
        path.unlink()
        path.mkdir()
        self.check_refused(path, WORLD)

    def test_a_database_of_another_program(self):
        path = self.folder / "other.trocar"
        with sqlite3.connect(path) as database:
            database.execute("CREATE TABLE journal(id INTEGER PRIMARY KEY)")
        database.close()
        self.check_refused(path, WORLD, "another program")

    def test_truncated(self):
        whole = self.recorded_project().read_bytes()
        path = self.folder / "cut.trocar"
        for size in (50, 100, 4096, len(whole) // 2, len(whole) - 1):
            path.write_bytes(whole[:size])
            self.check_refused(path, WORLD)

    def test_a_newer_schema_is_refused_and_left_alone(self):
        path = self.empty_project()
        database = sqlite3.connect(path)
        database.execute("PRAGMA user_version = 2")
        database.execute("PRAGMA wal_checkpoint(TRUNCATE)")
        database.close()
        self.check_refused(path, WORLD, "newer")

    def test_damage_inside_is_an_error_or_a_warning_but_never_a_crash(self):
        whole = self.recorded_project().read_bytes()
        path = self.folder / "damaged.trocar"
        for number in range(1, 12):
            page = 8192 * (number * len(whole) // (8192 * 12))
            path.write_bytes(whole[:page] + b"\xa5" * 8192 + whole[page + 8192:])
            for words in READERS[:2]:
                done = trocar(*words, path)
                self.assertIn(done.returncode, (DONE, WORLD), done.stderr)

    def test_a_journal_that_does_not_apply(self):
        for sql in ("UPDATE journal SET name = 'dance' WHERE id = 1",
                    "UPDATE journal SET parameters = '{' WHERE id = 1",
                    "UPDATE journal SET parameters = '{\"recording\": 77, \"name\": \"x\"}' WHERE id = 1",
                    "UPDATE objects SET bytes = x'00'", "DELETE FROM objects"):
            path = self.recorded_project()
            database = sqlite3.connect(path)
            database.execute(sql)
            database.commit()
            database.close()
            self.refused("info", path, code=WORLD)


class TwoPrograms(CommandLineTest):
    def test_an_edit_while_another_program_records_or_trains_is_kept(self):
        project = self.recorded_project()
        log = pathlib.Path(f"{project}-wal")
        for number, words in enumerate((["demo", "record", project, "--name", "New"],
                                        ["model", "train", project, "1", "--method", "eg-maxent", "--episodes", "1000000"])):
            with self.subTest(words[1]):
                process = subprocess.Popen([TROCAR, *map(str, words)], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                           text=True)
                while process.poll() is None and not log.exists():
                    time.sleep(0.002)
                self.answer("demo", "edit", project, "1", "rename", f"Renamed {number}")
                _, error = process.communicate(timeout=300)
                self.assertEqual(process.returncode, DONE, error)
                names = [demo["name"] for demo in self.answer("demo", "list", project)["demonstrations"]]
                self.assertEqual(names, [f"Renamed {number}", "New"])
        self.assertEqual(self.answer("info", project)["models"], 2)
        self.assertEqual([node["parent"] for node in self.answer("history", project)["history"]], list(range(6)))


@unittest.skipUnless(os.geteuid() == 0, "a small disk of its own needs the right to mount one")
class FullDisk(CommandLineTest):
    def setUp(self):
        super().setUp()
        self.disk = self.folder / "disk"
        self.disk.mkdir()
        if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=12m", "none", self.disk], capture_output=True).returncode:
            self.skipTest("this machine mounts no disk")
        self.addCleanup(subprocess.run, ["umount", self.disk])
        self.project = shutil.copy(self.recorded_project(), self.disk / "p.trocar")
        self.fill()

    def fill(self, leave=0):
        """Everything but `leave` bytes of the disk is used."""
        free = os.statvfs(self.disk)
        (self.disk / "fill").write_bytes(bytes(free.f_bavail * free.f_bsize - leave))

    def test_a_recording_is_kept_as_far_as_it_came_and_nothing_false_is_said(self):
        (self.disk / "fill").unlink()
        self.fill(leave=1_000_000)
        error = self.refused("demo", "record", self.project, code=WORLD, saying="full")
        self.assertNotIn("nothing was changed", error)
        (self.disk / "fill").unlink()
        self.fill()
        done = trocar("demo", "edit", self.project, "1", "rename", "X")
        self.assertNotIn("has been recovered", done.stderr)
        (self.disk / "fill").unlink()
        self.assertEqual(self.answer("recover", self.project)["recovered"], 1)

    def test_a_film_says_that_the_disk_is_full(self):
        error = self.refused("video", "render", self.folder / "recorded.trocar", "1", "--size", "64x36", "--out", self.disk / "v.mp4",
                             code=WORLD)
        self.assertRegex(error, "disk is full|No space left")
        self.assertEqual(sorted(path.name for path in self.disk.iterdir() if not path.name.startswith("p.")), ["fill"])


READING = (["info", "P"], ["history", "P"], ["demo", "list", "P"], ["demo", "show", "P", "1"], ["demo", "check", "P", "1"],
           ["demo", "diff", "P", "1"], ["model", "list", "P"], ["model", "show", "P", "2"], ["model", "compare", "P", "2", "2"],
           ["rollout", "run", "P", "2"], ["field", "export", "P", "2", "--out", "OUT.csv"], ["demo", "export", "P", "1", "OUT.npy"])


class ReadOnly(CommandLineTest):
    """Reading needs no right to write; the folder holds nothing but the project afterwards."""

    def setUp(self):
        super().setUp()
        self.outside = pathlib.Path(tempfile.mkdtemp(prefix="trocar_cli_out_"))
        self.addCleanup(shutil.rmtree, self.outside, ignore_errors=True)
        self.addCleanup(self.folder.chmod, 0o700)
        self.outside.chmod(0o777)

    def as_somebody(self, *arguments):
        """The super-user may write everywhere, so that for him somebody else runs it."""
        keywords = {"user": "nobody", "group": "nogroup", "extra_groups": []} if os.geteuid() == 0 else {}
        try:
            return trocar(*arguments, **keywords)
        except PermissionError:
            self.skipTest(f"nobody else may look into the folder of {TROCAR}")

    def protect(self, project):
        project.chmod(0o444)
        self.folder.chmod(0o555)

    def test_every_reading_command_works(self):
        project = self.recorded_project().rename(self.folder / "read only? 100%23 #1.trocar")
        self.protect(project)
        for words in READING:
            words = [{"P": str(project)}.get(word, word.replace("OUT", str(self.outside / "out"))) for word in words]
            done = self.as_somebody(*words)
            self.assertIn(done.returncode, (DONE, 1 if words[1] == "check" else DONE), f"{words}: {done.stderr}")
            self.assertNotIn("cannot", done.stderr)
        self.assertEqual([path.name for path in self.folder.iterdir()], [project.name])

    def test_changing_commands_say_why_not(self):
        project = self.recorded_project()
        self.protect(project)
        for words in (["undo", project], ["demo", "edit", project, "1", "rename", "X"]):
            done = self.as_somebody(*words)
            self.assertEqual(done.returncode, WORLD, done.stderr)
            self.assertIn("read-only", done.stderr)

    def test_a_log_that_cannot_be_read_is_said(self):
        project = self.recorded_project()
        process = subprocess.Popen([TROCAR, "demo", "record", str(project)], stdout=subprocess.DEVNULL)
        log = pathlib.Path(f"{project}-wal")
        while process.poll() is None and not (log.exists() and log.stat().st_size > 100000):
            time.sleep(0.002)
        process.kill()
        process.wait()
        pathlib.Path(f"{project}-shm").unlink()
        log.chmod(0o444)
        self.protect(project)
        done = self.as_somebody("info", project)
        self.assertEqual(done.returncode, WORLD, done.stderr)
        self.assertIn("in a log", done.stderr)


class BrokenFiles(CommandLineTest):
    def test_demonstrations_that_are_none(self):
        project = self.recorded_project()
        good = self.folder / "good.csv"
        self.answer("demo", "export", project, "1", good)
        lines = good.read_text().splitlines()
        header = next(i for i, line in enumerate(lines) if not line.startswith("#"))
        columns = lines[header].split(",")
        row = lines[header + 1].split(",")
        before = self.answer("info", project)["hash"]
        x = next(i for i, name in enumerate(columns) if name.endswith("x_m") or name.endswith("_x") or "p_x" in name)
        nan_row = ",".join(row[:x] + ["nan"] + row[x + 1:])
        cases = {
            "empty": "",
            "header only": "\n".join(lines[:header + 1]) + "\n",
            "one sample": "\n".join(lines[:header + 2]) + "\n",
            "not a number": "\n".join(lines[:header + 2] + [nan_row]) + "\n",
            "words": "\n".join(lines[:header + 1] + [",".join(["word"] * len(columns))] * 3) + "\n",
            "short rows": "\n".join(lines[:header + 1] + ["1,2,3"] * 3) + "\n",
            "backwards": "\n".join(lines[:header + 1] + lines[header + 1:header + 4][::-1]) + "\n",
            "unknown columns": "a,b\n1,2\n3,4\n",
            "binary": "\0\1\2\xff" * 50,
        }
        for name, text in cases.items():
            with self.subTest(name):
                path = self.folder / "bad.csv"
                path.write_text(text, encoding="latin-1")
                done = trocar("demo", "import", project, path)
                self.assertIn(done.returncode, (USAGE, WORLD), done.stderr)
                self.assertEqual(self.answer("info", project)["hash"], before)
        self.refused("demo", "import", project, self.folder / "none.csv", code=WORLD)
        (self.folder / "folder.csv").mkdir()
        self.refused("demo", "import", project, self.folder / "folder.csv", code=WORLD)

    def test_what_was_exported_comes_back(self):
        project = self.recorded_project()
        for suffix in ("csv", "npy"):
            with self.subTest(suffix):
                path = self.folder / f"round.{suffix}"
                self.answer("demo", "export", project, "1", path)
                answer = self.answer("demo", "import", project, path)
                self.assertIn("lossy", answer)
                shown = self.answer("demo", "show", project, str(answer["id"]))
                original = self.answer("demo", "show", project, "1")
                self.assertAlmostEqual(shown["duration_s"], original["duration_s"], delta=1e-6)
                self.assertAlmostEqual(shown["path_length_m"], original["path_length_m"], delta=1e-5)
                self.assertEqual(shown["provenance"]["operator"], "imported")


class Outputs(CommandLineTest):
    def test_an_answer_that_does_not_arrive_is_an_error(self):
        project = self.recorded_project()
        script = self.folder / "two.trocar"
        script.write_text(f"info {project}\ninfo {project}\n")
        for words in (["info", project], ["--json", "demo", "list", project], ["--help"], ["run", script]):
            with open("/dev/full", "w") as full:  # Opened, never replaced: writing to it fails as on a full disk.
                done = subprocess.run([TROCAR, *map(str, words)], stdout=full, stderr=subprocess.PIPE, text=True)
            self.assertEqual(done.returncode, WORLD, words)
            self.assertIn("could not be printed", done.stderr)

    def test_a_path_that_cannot_be_written(self):
        project = self.recorded_project()
        for out in (self.folder / "no" / "such", pathlib.Path("/proc/trocar")):
            self.refused("new", f"{out}.trocar", code=WORLD)
            self.refused("field", "export", project, "2", "--out", f"{out}.png", code=WORLD)
            self.refused("field", "export", project, "2", "--out", f"{out}.npy", code=WORLD)
            self.refused("rollout", "run", project, "2", "--out", f"{out}.csv", code=WORLD)
            self.refused("demo", "export", project, "1", f"{out}.csv", code=WORLD)
            self.refused("view", "render", project, "1", "--size", "64x36", "--out", f"{out}.png", code=WORLD)
            self.refused("video", "render", project, "1", "--size", "64x36", "--out", f"{out}.mp4", code=WORLD)
        (self.folder / "folder.png").mkdir()
        self.refused("field", "export", project, "2", "--out", self.folder / "folder.png", code=WORLD)
        self.assertEqual(self.leftovers(), ["folder.png", "recorded.trocar"])


    def test_the_project_itself_is_never_overwritten(self):
        project = self.recorded_project()
        before = self.answer("info", project)["hash"]
        link = self.folder / "link.csv"
        link.symlink_to(project)
        hard = self.folder / "hard.csv"
        os.link(project, hard)
        relative = f"{self.folder}/../{self.folder.name}/{project.name}"
        for out in (project, relative, link, hard, f"{project}-wal", f"{project}-shm"):
            with self.subTest(out=str(out)):
                self.refused("rollout", "run", project, "2", "--out", out, code=USAGE, saying="project itself")
                self.refused("demo", "export", project, "1", out, "--format", "csv", code=USAGE, saying="project itself")
                self.refused("field", "export", project, "2", "--out", out, code=USAGE)
                self.refused("view", "render", project, "1", "--out", out, code=USAGE)
                self.refused("video", "render", project, "1", "--out", out, code=USAGE)
                self.refused("ui", "run", "--project", project, "--screenshot", out, code=USAGE)
                self.refused("ui", "dump", "--project", project, "--out", out, code=USAGE)
        self.assertEqual(self.answer("info", project)["hash"], before)

    def test_no_output_takes_the_name_of_a_project(self):
        project = self.recorded_project()
        other = self.folder / "other.trocar"
        self.answer("new", other)
        before = other.read_bytes()
        self.refused("demo", "export", project, "1", other, "--format", "csv", code=USAGE, saying=".trocar")
        self.refused("rollout", "run", project, "2", "--out", other, code=USAGE)
        self.refused("rollout", "run", project, "2", "--out", self.folder / "rows", code=USAGE, saying=".csv")
        self.assertEqual(other.read_bytes(), before)

    def test_what_is_no_file_is_not_replaced_and_links_are_written_through(self):
        project = self.recorded_project()
        pipe = self.folder / "pipe.csv"
        os.mkfifo(pipe)
        film = self.folder / "pipe.mp4"
        os.mkfifo(film)
        self.refused("rollout", "run", project, "2", "--out", pipe, code=WORLD, saying="not a file")
        self.refused("demo", "export", project, "1", pipe, code=WORLD, saying="not a file")
        self.refused("video", "render", project, "1", "--size", "64x36", "--out", film, code=WORLD, saying="not a file")
        self.assertTrue(pipe.is_fifo() and film.is_fifo())
        target, link = self.folder / "target.csv", self.folder / "link.csv"
        link.symlink_to(target.name)
        self.answer("rollout", "run", project, "2", "--out", link)
        self.assertTrue(link.is_symlink())
        self.assertTrue(target.read_text().startswith("i,j,k,"))


class Crashes(CommandLineTest):
    def test_the_calls_that_led_to_it_are_printed_and_the_signal_stays_what_it_was(self):
        """Not under the sanitizers, which print their own."""
        process = subprocess.Popen([TROCAR, "model", "train", str(self.recorded_project()), "1", "--method", "eg-maxent",
                                    "--episodes", "10000000"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 60
        while not Interrupts.catches_interrupts(process.pid) and time.monotonic() < deadline:
            time.sleep(0.005)
        process.send_signal(signal.SIGSEGV)
        _, error = process.communicate(timeout=60)
        if "AddressSanitizer" in error or "ThreadSanitizer" in error:
            self.skipTest("sanitized")
        self.assertEqual(process.returncode, -signal.SIGSEGV)
        self.assertRegex(error, r"trocar: crashed \(SIGSEGV\)")
        self.assertRegex(error, r"trocar\(.*\)\[0x")


class Interrupts(CommandLineTest):
    """A signal in the middle: exit code 3, no half-written file, an unharmed project."""

    @staticmethod
    def catches_interrupts(pid):
        """True once the program has begun to listen; on a busy machine that takes a while."""
        try:
            status = pathlib.Path(f"/proc/{pid}/status").read_text()
        except OSError:
            return False
        caught = next(line for line in status.splitlines() if line.startswith("SigCgt:"))
        return bool(int(caught.split()[1], 16) >> (signal.SIGINT - 1) & 1)

    def interrupt(self, *arguments, wait_for=lambda: True, after_s=0.0):
        process = subprocess.Popen([TROCAR, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   text=True)
        deadline = time.monotonic() + 60
        for happened in (lambda: self.catches_interrupts(process.pid), wait_for):
            while process.poll() is None and not happened() and time.monotonic() < deadline:
                time.sleep(0.005)
        time.sleep(after_s)
        process.send_signal(signal.SIGINT)
        out, error = process.communicate(timeout=60)
        return process.returncode, error

    def test_a_film(self):
        project = self.recorded_project()
        film = self.folder / "film.mp4"
        code, error = self.interrupt("video", "render", project, "1", "--size", "640x360", "--fps", "60", "--out", film,
                                     wait_for=lambda: len(self.leftovers()) > 1)
        self.assertEqual(code, WORLD, error)
        self.assertEqual(self.leftovers(), ["recorded.trocar"])
        self.assertEqual(self.answer("info", project)["demonstrations"], 1)

    def test_training(self):
        project = self.recorded_project()
        before = self.answer("info", project)["hash"]
        code, error = self.interrupt("model", "train", project, "1", "--method", "eg-maxent", "--episodes", "10000000",
                                     after_s=0.5)
        self.assertEqual(code, WORLD, error)
        self.assertEqual(self.answer("info", project)["hash"], before)

    def test_trials_that_are_stopped_are_kept(self):
        project = self.empty_project()
        code, error = self.interrupt("trial", "run", project, "--mode", "MT", "--transfers", "1000", "--seed", "1",
                                     after_s=3.0)
        self.assertEqual(code, WORLD, error)
        kept = self.answer("trial", "list", project)["trials"]
        self.assertIn(f"{len(kept)} transfer", error)
        self.assertGreaterEqual(len(kept), 1)
        # The last one was under way, if only in E, where its outcome is known already.
        events = self.answer("trial", "show", project, kept[-1]["id"])["events"]
        self.assertIn(("outcome", "stopped"), [(event["kind"], event["text"]) for event in events])
        for trial in kept:
            self.assertTrue(self.answer("trial", "replay", project, trial["id"], "--verify")["verified"])

    def test_a_recording_that_is_stopped_is_discarded_and_says_so(self):
        project = self.recorded_project()
        self.answer("undo", project)
        log = pathlib.Path(f"{project}-wal")
        code, error = self.interrupt("demo", "record", project, "--skill", "novice",
                                     wait_for=lambda: log.exists() and log.stat().st_size > 300000)
        self.assertEqual(code, WORLD, error)
        self.assertRegex(error, r"the recording was stopped; its \d+\.\d s were discarded")
        done = trocar("demo", "list", project)
        self.assertEqual((done.stdout.count("\n"), done.stderr), (1, ""))
        self.answer("redo", project)

    def test_the_window_without_a_display(self):
        """One signal ends it, also while a script waits for a film; the film's temporary file goes with it."""
        project = self.recorded_project()
        script = self.folder / "film.ui"
        script.write_text('click "Toolbar/Export video…"\nframes 2\nclick "Export video/Export"\nwait idle 300\n')
        code, error = self.interrupt("ui", "run", "--project", project, "--script", script,
                                     wait_for=lambda: any(".part." in name for name in self.leftovers()))
        self.assertEqual(code, WORLD, error)
        self.assertIn("stopped by the user", error)
        self.assertEqual(self.leftovers(), ["film.ui", "recorded.trocar"])

    def test_a_picture(self):
        project = self.recorded_project()
        out = self.folder / "view.png"
        code, error = self.interrupt("view", "render", project, "1", "--size", "4096x4096", "--out", out, after_s=0.2)
        self.assertEqual(code, WORLD, error)
        self.assertEqual(self.leftovers(), ["recorded.trocar"])

    def test_killed_at_any_moment(self):
        """The program itself, anywhere from its start to its end; what was there before stays, and it opens."""
        project = self.recorded_project()
        before = self.answer("demo", "show", project, "1")["hash"]
        chance = random.Random(20261122)
        count = 1
        for _ in range(12):  # One more demonstration at most, each time.
            process = subprocess.Popen([TROCAR, "demo", "record", str(project), "--time-limit", "4"],
                                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            try:
                process.wait(chance.uniform(0.0, 0.5))
            except subprocess.TimeoutExpired:
                process.kill()
            whole = process.wait() == DONE
            recovered = self.answer("recover", project)["recovered"]
            now = len(self.answer("demo", "list", project)["demonstrations"])
            self.assertIn(now - count, (1,) if whole or recovered else (0, 1))
            count = now
        self.assertEqual(self.answer("demo", "show", project, "1")["hash"], before)
        self.assertEqual(self.answer("info", project)["models"], 1)

    def test_killed_without_warning(self):
        project = self.recorded_project()
        self.answer("undo", project)
        log = pathlib.Path(f"{project}-wal")
        process = subprocess.Popen([TROCAR, "demo", "record", str(project)], stdout=subprocess.DEVNULL)
        while process.poll() is None and not (log.exists() and log.stat().st_size > 300000):
            time.sleep(0.002)
        process.kill()
        process.wait()
        # Reading says that there is something; only an edit or `recover` takes it in, so that redo still works.
        for words in (["demo", "list"], ["history"], ["undo"], ["redo"], ["redo"]):
            done = trocar(*words, project)
            self.assertEqual(done.returncode, DONE, done.stderr)
            self.assertIn("was cut off", done.stderr)
        self.assertEqual(self.answer("recover", project)["recovered"], 1)
        self.assertEqual(self.answer("recover", project)["recovered"], 0)
        listed = self.answer("demo", "list", project)["demonstrations"]
        self.assertEqual(len(listed), 2)
        self.assertGreater(listed[1]["samples"], 100)
        self.assertTrue(listed[1]["name"].startswith("Recovered ("))


if __name__ == "__main__":
    unittest.main()
