"""A render that something is done to: its start, its end, and what must hold then."""
import dataclasses
import os
import pathlib
import signal
import subprocess
import time

from scenes import MAKERS

TOKEN = "YARTE_CHAOS"
SIZES = {".pfm": (160, 120), ".ppm": (200, 150), ".png": (180, 140), ".exr": (150, 130), ".dmp": (170, 110)}


def size_of(extension):
    return "x".join(map(str, SIZES[extension]))


class Failure(Exception):
    """Something that was promised did not hold."""


class Fixtures:
    """Undisturbed pictures, and how long they took; each is rendered once."""

    def __init__(self, program, scenes, folder):
        self.program, self.scenes, self.folder, self.known = program, scenes, folder, {}

    def of(self, maker, extension, samples):
        key = maker, extension, samples
        if key not in self.known:
            folder = self.folder / "-".join(map(str, key)).replace(".", "")
            folder.mkdir(parents=True)
            MAKERS[maker](folder, self.scenes)
            command = [self.program, "scene.yarte", "-o", f"out{extension}", "--size", size_of(extension), "--samples", str(samples),
                       "--progress", "none"]
            start = time.monotonic()
            subprocess.run([*command, "--processes", "0"], cwd=folder, check=True)
            self.known[key] = (folder / f"out{extension}").read_bytes(), time.monotonic() - start
        return self.known[key]


@dataclasses.dataclass
class JournalLayout:
    """Sizes in bytes of a checkpoint, as yarte/README.md describes it."""
    head: int
    record: int
    whole: int  # of a finished render


class Trial:
    """One render in a folder of its own. `rng` decides all that is left to chance."""

    def __init__(self, fixtures, folder, rng, checkpoint=None, maker=None):
        self.rng, self.folder, self.program, self.scenes = rng, folder, fixtures.program, fixtures.scenes
        self.maker, self.extension = maker or rng.choice(sorted(MAKERS)), rng.choice(sorted(SIZES))
        self.tile, samples = rng.choice((8, 16, 24, 32, 64)), rng.choice((2, 4, 6))
        self.options = {"--size": size_of(self.extension), "--samples": str(samples), "--tile": str(self.tile)}
        self.processes = rng.randint(1, 4)
        self.expected, self.seconds = fixtures.of(self.maker, self.extension, samples)
        folder.mkdir()
        MAKERS[self.maker](folder, fixtures.scenes)
        self.output = folder / f"out{self.extension}"
        self.journal = folder / "journal" if (rng.random() < 0.6 if checkpoint is None else checkpoint) else None
        self.older = b"an older picture" if rng.random() < 0.5 else None
        if self.older:
            self.output.write_bytes(self.older)
        self.given = set(os.listdir(folder))
        self.token = f"{TOKEN}={folder}".encode()
        self.process = None
        self.hit = False  # whether the render ran when it was struck
        self.outcome = None  # the exit code of the first run, or what a fault says of it
        self.ran_again = False

    # The run.

    def command(self, *more):
        command = [self.program, "scene.yarte", "-o", self.output, "--processes", str(self.processes)]
        command += [word for option in self.options.items() for word in option]
        command += ["--checkpoint", self.journal] if self.journal else []
        return [*command, *(more if "--progress" in more else ["--progress", "none", *more])]

    def start(self, *more, environment=None, limit=None):
        self.process = subprocess.Popen(self.command(*more), cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                                        env=os.environ | {TOKEN: str(self.folder)} | (environment or {}), preexec_fn=limit,
                                        start_new_session=True)

    def moment(self, most=1.1):
        """Waits for some part of the time that a render takes."""
        time.sleep(self.rng.uniform(0, most * self.seconds / min(self.processes, os.cpu_count()) + 0.02))

    def moment_of_work(self, most):
        """The same, of the time when there are workers."""
        self.until(self.workers)
        self.moment(most)

    def moment_of_writing(self):
        """Waits for the file that becomes the output."""
        self.until(self.half_written)

    def until(self, condition):
        """Waits until it holds or the render has ended; not for ever, since that is for end() to tell."""
        for _ in range(100000):
            if condition() or not self.running():
                return
            time.sleep(0.001)

    def half_written(self):
        return {name for name in os.listdir(self.folder) if name.startswith(".yarte-")}

    def running(self):
        return self.process.poll() is None

    def workers(self):
        try:
            return [int(word) for word in pathlib.Path(f"/proc/{self.process.pid}/task/{self.process.pid}/children").read_text().split()]
        except OSError:
            return []

    def any_worker(self):
        workers = self.workers()
        return self.rng.choice(workers) if workers else None

    def strike(self, pid, action):
        """Does `action(pid)`; true if the render ran and there still was such a process."""
        if pid is None or not self.running():
            return False
        try:
            action(pid)
        except ProcessLookupError:
            return False
        self.hit = True
        return True

    def signal(self, pid, number):
        return self.strike(pid, lambda process: os.kill(process, number))

    def signal_all(self, number):
        return self.strike(self.process.pid, lambda group: os.killpg(group, number))

    def end(self):
        """Waits; returns the exit code (minus the signal's number) and the messages."""
        try:
            _, errors = self.process.communicate(timeout=240)
        except subprocess.TimeoutExpired:
            os.killpg(self.process.pid, signal.SIGKILL)
            raise Failure("did not end within four minutes") from None
        if self.outcome is None:
            self.outcome = str(self.process.returncode)
        return self.process.returncode, errors

    def end_or_again(self, allowed):
        """Ends with one of these codes; if that is no success, a second run must give the picture. Returns as end()."""
        code, errors = self.end()
        self.check_ended(code, errors, allowed)
        if code != 0:
            self.again()
        return code, errors

    def again(self, *more, environment=None):
        """The same render, gone on with where there is a checkpoint, by any number of workers: it must give the picture."""
        self.ran_again = True
        self.processes = self.rng.randint(0, 4)
        self.start(*(["--resume"] if self.journal else []), *more, environment=environment)
        code, errors = self.end()
        if code != 0:
            raise Failure(f"the second run ended with {code}: {errors.strip()}")
        self.check_ended(code, errors, {0})
        return errors

    # What must hold.

    def alive(self):
        """Processes of this trial."""
        found = []
        for entry in pathlib.Path("/proc").iterdir():
            if entry.name.isdigit():
                try:
                    if self.token in (entry / "environ").read_bytes().split(b"\0"):
                        found.append(int(entry.name))
                except OSError:
                    pass
        return found

    def check_nothing_runs(self):
        """After a second, which is not told by a clock: all of us may be stopped meanwhile."""
        for _ in range(200):
            if not self.alive():
                return
            time.sleep(0.005)
        raise Failure(f"processes {self.alive()} are left after a second")

    def check_picture(self):
        if not self.output.exists() or self.output.read_bytes() != self.expected:
            raise Failure("the picture is not that of an undisturbed render")

    def check_unharmed(self):
        """What was there before is there still; nothing half-written took its place."""
        now = self.output.read_bytes() if self.output.exists() else None
        if now not in (self.older, self.expected):
            raise Failure("the output is neither as it was before nor complete")

    def check_files(self):
        left = set(os.listdir(self.folder)) - self.given - {self.output.name, self.journal.name if self.journal else None}
        if left:
            raise Failure(f"files {sorted(left)} are left")

    def check_ended(self, code, errors, allowed):
        """Of a render that ended by itself: its exit code, that it says why, and that the picture is what the code says."""
        if code not in allowed:
            raise Failure(f"exit code {code}, not one of {sorted(allowed)}: {errors.strip()}")
        if code in (1, 2, 3) and "yarte: " not in errors:
            raise Failure(f"exit code {code} without a reason: {errors.strip()!r}")
        self.check_nothing_runs()
        self.check_files()
        if code == 0:
            self.check_picture()
        else:
            self.check_unharmed()

    def journal_layout(self):
        width, height = SIZES[self.extension]
        record = 8 + 8 + 4 * 8 + 3 * 8 * min(self.tile, width) * min(self.tile, height)
        head = self.journal.read_bytes().find(b"\n\n") + 2 + 16 + 1
        return JournalLayout(head, record, head + record * -(-width // self.tile) * -(-height // self.tile))
