"""A render that something is done to: its scenes, its start, its end, and what must hold then."""
import os
import pathlib
import random
import shutil
import signal
import subprocess
import time

TOKEN = "YARTE_CHAOS"
SIZES = {".pfm": "160x120", ".ppm": "200x150", ".png": "180x140", ".exr": "150x130", ".dmp": "170x110"}


def spheres(folder, scenes):
    rng = random.Random(5)
    text = "camera_position 0 0 6\nfocus_point 0 0 0\ncamera_apertures 40 32\nlight_source 5 9 6 1\nlight_source -7 4 5 0.4\n"
    text += "material 0.1 0.1 0.1 0.5 0.4 0.3 0.3 0.3 0.3 30 0.3 0 0\n"
    text += "".join(f"sphere {rng.uniform(-2, 2):.4f} {rng.uniform(-1.6, 1.6):.4f} {rng.uniform(-2, 2):.4f} 0.2\n" for _ in range(120))
    (folder / "scene.yarte").write_text(text)


def from_scenes(name):
    def make(folder, scenes):
        shutil.copytree(scenes / name, folder, dirs_exist_ok=True)
        (folder / f"{name}.yarte").rename(folder / "scene.yarte")
    return make


MAKERS = {"spheres": spheres, "paper": from_scenes("paper"), "glass": from_scenes("nested_glass"), "mesh": from_scenes("smooth_mesh")}


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
            command = [self.program, "scene.yarte", "-o", f"out{extension}", "--size", SIZES[extension], "--samples", str(samples),
                       "--progress", "none"]
            start = time.monotonic()
            subprocess.run([*command, "--processes", "1"], cwd=folder, check=True)
            self.known[key] = (folder / f"out{extension}").read_bytes(), time.monotonic() - start
        return self.known[key]


class Trial:
    """One render in a folder of its own. `rng` decides all that is left to chance."""

    def __init__(self, fixtures, folder, rng, checkpoint=None, processes=None):
        self.rng, self.folder, self.program = rng, folder, fixtures.program
        self.maker, self.extension = rng.choice(sorted(MAKERS)), rng.choice(sorted(SIZES))
        self.samples = rng.choice((2, 3, 4))
        self.processes = processes or rng.randint(1, 4)
        self.checkpoint = rng.random() < 0.5 if checkpoint is None else checkpoint
        self.expected, self.seconds = fixtures.of(self.maker, self.extension, self.samples)
        folder.mkdir()
        MAKERS[self.maker](folder, fixtures.scenes)
        self.output = folder / f"out{self.extension}"
        self.older = b"an older picture" if rng.random() < 0.5 else None
        if self.older:
            self.output.write_bytes(self.older)
        self.given = set(os.listdir(folder))
        self.token = f"{TOKEN}={folder}"
        self.hit = False  # whether the render ran when it was struck
        self.process = None

    def command(self, *more):
        command = [self.program, "scene.yarte", "-o", self.output, "--size", SIZES[self.extension], "--samples", str(self.samples),
                   "--processes", str(self.processes), "--tile", str(self.tile), "--progress", "none"]
        return command + (["--checkpoint", "journal"] if self.checkpoint else []) + list(more)

    @property
    def tile(self):
        return (16, 32, 64)[len(str(self.folder)) % 3] if self.checkpoint else 16

    def start(self, *more, environment=None, limit=None):
        self.process = subprocess.Popen(self.command(*more), cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                                        env=os.environ | {TOKEN: str(self.folder)} | (environment or {}), preexec_fn=limit,
                                        start_new_session=True)

    def moment(self, most=1.1):
        """Waits for some part of the time that a render takes."""
        time.sleep(self.rng.uniform(0, most * self.seconds / min(self.processes, 2) + 0.01))
        self.hit = self.hit or self.process.poll() is None

    def workers(self):
        try:
            return [int(word) for word in pathlib.Path(f"/proc/{self.process.pid}/task/{self.process.pid}/children").read_text().split()]
        except OSError:
            return []

    def send(self, pid, number):
        try:
            os.kill(pid, number)
        except ProcessLookupError:
            pass

    def end(self):
        """Waits; returns the exit code (minus the signal's number) and the messages."""
        try:
            _, errors = self.process.communicate(timeout=120)
        except subprocess.TimeoutExpired:
            os.killpg(self.process.pid, signal.SIGKILL)
            raise Failure("did not end within two minutes") from None
        return self.process.returncode, errors

    def alive(self):
        """Processes of this trial."""
        found = []
        for entry in pathlib.Path("/proc").iterdir():
            if entry.name.isdigit():
                try:
                    if self.token.encode() in (entry / "environ").read_bytes().split(b"\0"):
                        found.append(int(entry.name))
                except OSError:
                    pass
        return found

    def check_nothing_runs(self):
        deadline = time.monotonic() + 1
        while self.alive():
            if time.monotonic() > deadline:
                raise Failure(f"processes {self.alive()} are left after a second")
            time.sleep(0.005)

    def check_picture(self):
        if not self.output.exists() or self.output.read_bytes() != self.expected:
            raise Failure("the picture is not that of an undisturbed render")

    def check_unharmed(self):
        """What was there before is there still; nothing half-written took its place."""
        now = self.output.read_bytes() if self.output.exists() else None
        if now not in (self.older, self.expected):
            raise Failure("the output is neither as it was before nor complete")

    def check_files(self, *more):
        left = set(os.listdir(self.folder)) - self.given - {self.output.name, "journal", *more}
        if left:
            raise Failure(f"files {sorted(left)} are left")

    def check_ended(self, code, errors, allowed):
        """Of a render that ended by itself: its exit code, and that the picture is what the code says."""
        if code not in allowed:
            raise Failure(f"exit code {code}, not one of {sorted(allowed)}: {errors.strip()}")
        if code != 0 and not errors.strip():
            raise Failure(f"exit code {code} without a message")
        self.check_nothing_runs()
        self.check_files()
        if code == 0:
            self.check_picture()
        else:
            self.check_unharmed()

    def again(self, *more):
        """The same render, gone on with where there is a checkpoint: it must end well and give the picture."""
        self.start(*(["--resume"] if self.checkpoint else []), *more)
        code, errors = self.end()
        if code != 0:
            raise Failure(f"the second run ended with {code}: {errors.strip()}")
        self.check_nothing_runs()
        self.check_picture()
        return errors
