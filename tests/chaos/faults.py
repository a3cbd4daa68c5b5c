"""What may happen to a render. Each takes a Trial's maker, does one fault, and checks what was promised; returns the exit codes seen
and whether a second run followed."""
import os
import resource
import shutil
import signal
import subprocess
import time

from trial import Failure

MEBI = 1 << 20


def worker_killed(make):
    trial = make()
    trial.start()
    kills = trial.rng.randint(1, 4)
    for _ in range(kills):
        trial.moment(1 / kills)
        workers = trial.workers()
        if workers:
            trial.send(trial.rng.choice(workers), signal.SIGKILL)
    code, errors = trial.end()
    trial.check_ended(code, errors, {0, 3} if kills > 1 else {0})
    if code == 3 and "died twice" not in errors and "keep dying" not in errors:
        raise Failure(errors)
    if code == 3:
        trial.again()
    return trial, code, code == 3


def worker_stopped(make):
    """For longer than a worker may be."""
    trial = make()
    trial.start()
    trial.moment(0.6)
    workers = trial.workers()
    if workers:
        trial.send(trial.rng.choice(workers), signal.SIGSTOP)
    code, errors = trial.end()
    trial.check_ended(code, errors, {0})
    return trial, code, False


def worker_paused(make):
    trial = make()
    trial.start()
    trial.moment(0.8)
    workers = trial.workers()
    if workers:
        worker = trial.rng.choice(workers)
        trial.send(worker, signal.SIGSTOP)
        time.sleep(trial.rng.uniform(0, 0.3))
        trial.send(worker, signal.SIGCONT)
    code, errors = trial.end()
    trial.check_ended(code, errors, {0})
    return trial, code, False


def all_paused(make):
    """As by Ctrl-Z and `fg`."""
    trial = make()
    trial.start()
    trial.moment()
    if trial.process.poll() is None:
        for number in (signal.SIGSTOP, signal.SIGCONT):
            os.killpg(trial.process.pid, number)
            time.sleep(trial.rng.uniform(0, 0.3))
    code, errors = trial.end()
    trial.check_ended(code, errors, {0})
    return trial, code, False


def parent_killed(make):
    trial = make()
    trial.start()
    trial.moment()
    trial.send(trial.process.pid, signal.SIGKILL)
    code, _ = trial.end()
    trial.check_nothing_runs()
    trial.check_unharmed()
    trial.again()
    return trial, code, True


def interrupted(make):
    trial = make()
    number = trial.rng.choice((signal.SIGINT, signal.SIGTERM))
    trial.start()
    trial.moment()
    trial.send(trial.process.pid, number)
    code, errors = trial.end()
    # Before the program has its handlers, the signal itself ends it, without a word.
    trial.check_ended(code, errors or "(none)", {0, 128 + number, -number})
    if code != 0:
        trial.again()
    return trial, code, code != 0


def file_too_large(make):
    """Writing fails from some size on: the output, the checkpoint, or the picture's own memory."""
    trial = make()
    most = trial.rng.choice((len(trial.expected), 4 * len(trial.expected)))
    size = trial.rng.randint(0, most)
    trial.start(limit=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
    trial.hit = True
    code, errors = trial.end()
    trial.check_ended(code, errors, {0, 3})
    if code != 0:
        trial.again()
    return trial, code, code != 0


def disk_full(make):
    """A file system that is full, but for some bytes."""
    trial = make(checkpoint=True)
    small = trial.folder / "small"
    small.mkdir()
    trial.given.add("small")
    size = trial.rng.randint(4, 200) * 4096
    if subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", small], stderr=subprocess.DEVNULL).returncode != 0:
        return trial, "no mount", False
    try:
        trial.output = small / trial.output.name
        trial.older = None
        trial.checkpoint = False  # named here, on the small disk
        trial.start("--checkpoint", "small/journal")
        trial.hit = True
        code, errors = trial.end()
        trial.check_ended(code, errors, {0, 3})
        left = set(os.listdir(small)) - {"journal", trial.output.name}
        if left:
            raise Failure(f"files {sorted(left)} are left on the full disk")
    finally:
        subprocess.run(["umount", small], check=True)
    return trial, code, False


def no_device_space(make):
    """A device that takes nothing, beside an output that is good."""
    trial = make()
    (trial.folder / "full.ppm").symlink_to("/dev/full")
    trial.given.add("full.ppm")
    trial.start("-o", "full.ppm")
    trial.hit = True
    code, errors = trial.end()
    trial.check_ended(code, errors, {3})
    return trial, code, False


def little_memory(make):
    """All of the program's address space is limited from the start."""
    trial = make()
    size = trial.rng.randint(8, 160) * MEBI
    trial.start(limit=lambda: resource.setrlimit(resource.RLIMIT_AS, (size, size)))
    trial.hit = True
    code, errors = trial.end()
    # With too little to load its libraries it does not come to be ours.
    trial.check_ended(code, errors, {0, 3, 127})
    if code != 0:
        trial.again()
    return trial, code, code != 0


def worker_without_memory(make):
    """A worker may take no more than it has."""
    trial = make()
    trial.start()
    trial.moment(0.8)
    for worker in trial.workers():
        try:
            resource.prlimit(worker, resource.RLIMIT_AS, (MEBI, MEBI))
        except ProcessLookupError:
            pass
    code, errors = trial.end()
    trial.check_ended(code, errors, {0, 3})
    if code != 0:
        trial.again()
    return trial, code, code != 0


def folder_removed(make):
    """The folder that the picture should go to."""
    trial = make()
    sub = trial.folder / "sub"
    sub.mkdir()
    trial.given.add("sub")
    trial.output = sub / trial.output.name
    trial.older = None
    trial.start()
    trial.moment()
    shutil.rmtree(sub, ignore_errors=True)
    code, errors = trial.end()
    trial.check_nothing_runs()
    trial.check_files()
    if code not in (0, 3) or (code == 3 and trial.output.name not in errors):
        raise Failure(f"exit code {code}: {errors}")
    sub.mkdir(exist_ok=True)
    trial.again()
    return trial, code, True


def clock_jumps(make, shim):
    trial = make()
    trial.start("--stats", "stats.json", environment={"LD_PRELOAD": str(shim)})
    trial.hit = True
    code, errors = trial.end()
    trial.given.add("stats.json")
    trial.check_ended(code, errors, {0})
    return trial, code, False


def cut_short(make, limit=0.9):
    """A trial whose render was killed, and its checkpoint; nothing if none had been begun."""
    trial = make(checkpoint=True)
    trial.start()
    trial.moment(limit)
    trial.send(trial.process.pid, signal.SIGKILL)
    trial.end()
    trial.check_nothing_runs()
    # What it was just writing beside the output nobody could remove.
    trial.given |= {file.name for file in trial.folder.glob(".yarte-*.tmp")}
    journal = trial.folder / "journal"
    return trial, journal if journal.exists() and journal.stat().st_size > 0 else None


def checkpoint_damaged(make):
    trial, journal = cut_short(make)
    if journal is None:
        trial.again()
        return trial, "no checkpoint yet", True
    data = bytearray(journal.read_bytes())
    kind = trial.rng.choice(("torn", "flipped", "longer", "emptied"))
    if kind == "torn":
        del data[trial.rng.randrange(len(data)):]
    elif kind == "flipped":
        data[trial.rng.randrange(len(data))] ^= 1 << trial.rng.randrange(8)
    elif kind == "longer":
        data += trial.rng.randbytes(trial.rng.randint(1, 5000))
    else:
        data.clear()
    journal.write_bytes(data)
    trial.start("--resume")
    code, errors = trial.end()
    trial.check_ended(code, errors, {0, 1})
    return trial, f"{kind}: {code}", True


def scene_altered(make):
    """Something that the picture depends on is another when the render goes on."""
    trial, journal = cut_short(make)
    if journal is None:
        return trial, "no checkpoint yet", False
    meshes = sorted(trial.folder.glob("*.pmf"))
    kind = trial.rng.choice(("scene", "mesh", "--size", "--samples", "--precision", "--tile"))
    more = {"--size": ["--size", "99x77"], "--samples": ["--samples", "5"], "--precision": ["--precision", "fast"],
            "--tile": ["--tile", "48"]}.get(kind, [])
    if kind == "mesh" and meshes:
        text = meshes[0].read_text()
        meshes[0].write_text(text.replace("0", "1", 1) if "0" in text else text + "\n")
    elif not more:
        kind = "scene"
        with open(trial.folder / "scene.yarte", "a") as scene:
            scene.write("sphere 0 0 0 0.5\n")
    command = trial.command("--resume")
    for option, value in zip(more[::2], more[1::2]):
        if option in command:
            command[command.index(option) + 1] = value
        else:
            command += [option, value]
    done = subprocess.run(command, cwd=trial.folder, capture_output=True, text=True, env=os.environ)
    named = {"scene": "scene", "mesh": meshes[0].name if meshes else "", "--size": "size"}.get(kind, kind)
    if done.returncode != 1 or named not in done.stderr:
        raise Failure(f"{kind} altered: exit code {done.returncode}: {done.stderr.strip()}")
    trial.check_unharmed()
    return trial, f"{kind}: {done.returncode}", True


# Each as often as it says, of a hundred or so; those that wait for seconds less often.
FAULTS = {"a worker is killed, up to four times": (worker_killed, 18), "a worker is stopped": (worker_stopped, 2),
          "a worker is stopped and continued": (worker_paused, 6), "all are stopped and continued": (all_paused, 4),
          "the parent is killed": (parent_killed, 18), "SIGINT or SIGTERM": (interrupted, 12),
          "files may not grow beyond some size": (file_too_large, 6), "the disk is full": (disk_full, 5), "/dev/full": (no_device_space, 1),
          "little memory from the start": (little_memory, 6), "workers get no more memory": (worker_without_memory, 5),
          "the output's folder is removed": (folder_removed, 5), "the clock jumps by hours": (clock_jumps, 4),
          "the checkpoint is damaged": (checkpoint_damaged, 10), "the scene or the options are altered": (scene_altered, 8)}
