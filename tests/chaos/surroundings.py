"""Faults of what a render stands on: disk, memory, folders, the clock. Each takes a Trial's maker, does one fault and checks what was
promised."""
import contextlib
import json
import os
import resource
import shutil
import signal
import subprocess
import time

from trial import Failure

MEBI = 1 << 20
PAGE = 4096
LONGEST_HEAD = 2048  # bytes of a checkpoint's head, of our scenes
KEPT_NO_MORE = "the render goes on"


def file_too_large(make):
    """No file may grow beyond some size, as by `ulimit -f`."""
    trial = make()
    needed = len(trial.expected)
    size = trial.rng.randint(0, trial.rng.choice((LONGEST_HEAD, needed, 4 * needed)))
    trial.start(limit=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (size, size)))
    trial.hit = True
    code, errors = trial.end()
    fits = size >= needed and (not trial.journal or size >= LONGEST_HEAD)
    trial.check_ended(code, errors, {0} if fits else {3} if size < needed else {0, 3})
    if code == 0 and trial.journal:
        check_warning(errors, trial.journal_layout().whole > size)
    if code != 0:
        trial.again()
    return trial


def check_warning(errors, expected):
    """That what is finished is no longer kept is said where it is so, and only there."""
    if (KEPT_NO_MORE in errors) != expected:
        raise Failure(f"the checkpoint was {'cut off' if expected else 'written'}, and the program says: {errors.strip()!r}")


@contextlib.contextmanager
def small_disk(folder, size):
    """A file system of so many bytes, or None where we may not mount one. Yields what gives it more room."""
    folder.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", folder]
    if subprocess.run(mount, stderr=subprocess.DEVNULL).returncode != 0:
        yield None
        return
    try:
        yield lambda: subprocess.run(["mount", "-o", f"remount,size={64 * MEBI}", folder], check=True)
    finally:
        subprocess.run(["umount", folder], check=True)


def ended_on_small_disk(trial, size, *, check, checkpoint=False, output=False):
    """The checkpoint, the output or both lie on a disk of so many bytes, which gets more room after check(code, errors)."""
    small = trial.folder / "small"
    with small_disk(small, size) as enlarge:
        if not enlarge:
            trial.outcome = "skipped: no file system may be mounted"
            return trial
        trial.given.add(small.name)
        if checkpoint:
            trial.journal = small / "journal"
        if output:
            move_output(trial, small)
        trial.start()
        trial.hit = True
        code, errors = trial.end()
        check(code, errors)
        if output:
            check_only(small, trial.output.name, *([trial.journal.name] if checkpoint else []))
        if checkpoint or code != 0:
            enlarge()
            trial.again()
    return trial


def full_for_output(make):
    trial = make()
    needed = len(trial.expected)
    size = PAGE * trial.rng.randint(1, needed * 3 // 2 // PAGE + 2)
    # The older picture needs a page.
    allowed = {3} if size < needed else {0} if size >= needed + 2 * PAGE else {0, 3}
    return ended_on_small_disk(trial, size, output=True, check=lambda code, errors: trial.check_ended(code, errors, allowed))


def full_for_checkpoint(make):
    """It costs a warning, not the render. What was kept before is good."""
    trial = make(checkpoint=True)
    size = PAGE * trial.rng.randint(1, 120)

    def check(code, errors):
        trial.check_ended(code, errors, {0})
        check_warning(errors, trial.journal_layout().whole > size)

    return ended_on_small_disk(trial, size, checkpoint=True, check=check)


def full_for_both(make):
    """Of the two, the checkpoint may take the output's place: then that is said, and with more room the render goes on."""
    trial = make(checkpoint=True)
    size = PAGE * trial.rng.randint(1, 120)
    return ended_on_small_disk(trial, size, checkpoint=True, output=True,
                               check=lambda code, errors: trial.check_ended(code, errors, {0, 3}))


def move_output(trial, folder):
    trial.output = folder / trial.output.name
    if trial.older:
        trial.output.write_bytes(trial.older)


def check_only(folder, *names):
    left = set(os.listdir(folder)) - set(names)
    if left:
        raise Failure(f"files {sorted(left)} are left in {folder}")


def no_device_space(make):
    """A device that takes nothing, beside an output that is good."""
    trial = make()
    (trial.folder / "full.ppm").symlink_to("/dev/full")
    trial.given.add("full.ppm")
    trial.start("-o", "full.ppm")
    trial.hit = True
    code, errors = trial.end()
    trial.check_ended(code, errors, {3})
    trial.check_picture()
    if "full.ppm" not in errors:
        raise Failure(f"the message does not name the file: {errors.strip()}")
    trial.again()
    return trial


def little_memory(make):
    """All of the program's address space is limited from the start."""
    trial = make()
    size = trial.rng.randint(4, 120) * MEBI
    trial.start(limit=lambda: resource.setrlimit(resource.RLIMIT_AS, (size, size)))
    trial.hit = True
    # With too little to be loaded the program does not come to say anything: the loader ends it, or the system does.
    trial.end_or_again({0, 3, 127, -signal.SIGSEGV} if size < 24 * MEBI else {0, 3})
    return trial


def workers_without_memory(make):
    """Some workers may take no more than they have."""
    trial = make()
    trial.start()
    trial.moment_of_work(0.8)
    workers = trial.workers()
    workers = trial.rng.sample(workers, trial.rng.randint(min(1, len(workers)), len(workers)))
    limited = sum(trial.strike(worker, lambda pid: resource.prlimit(pid, resource.RLIMIT_AS, (MEBI, MEBI))) for worker in workers)
    trial.end_or_again({0, 3} if limited > 1 else {0})
    return trial


def folder_lost(make):
    """The folder that the picture should go to."""
    trial = make()
    folder, elsewhere = trial.folder / "sub", trial.folder / "elsewhere"
    folder.mkdir()
    move_output(trial, folder)
    trial.given |= {"sub", "elsewhere"}
    way = trial.rng.choice(("removed", "renamed", "replaced by a file") + (("made read-only",) if os.geteuid() != 0 else ()))
    trial.start()
    trial.moment()
    trial.hit = trial.running()
    if way == "removed":
        shutil.rmtree(folder, ignore_errors=True)
    elif way == "made read-only":
        folder.chmod(0o555)
    else:
        folder.rename(elsewhere)
        if way == "replaced by a file":
            folder.write_bytes(b"")
    code, errors = trial.end()
    trial.check_nothing_runs()
    trial.check_files()
    if code not in (0, 3) or (code == 3 and trial.output.name not in errors):
        raise Failure(f"{way}: exit code {code}: {errors.strip()}")
    if folder.is_file():
        folder.unlink()
    folder.mkdir(exist_ok=True)
    folder.chmod(0o755)
    if elsewhere.exists():
        there = elsewhere / trial.output.name
        if (there.read_bytes() if there.exists() else None) not in (trial.older, trial.expected):
            raise Failure("the picture in the renamed folder is neither as it was before nor complete")
    trial.outcome = f"{way}: {code}"
    trial.again()
    return trial


def clock_jumps(make, shim):
    """Of a render and, where it has a checkpoint, of the one that goes on after a kill."""
    environment = {"LD_PRELOAD": str(shim)}
    told = int(subprocess.run(["date", "+%s"], env=os.environ | environment, check=True, capture_output=True, text=True).stdout)
    if abs(told - time.time()) < 3600:
        raise Failure("the clock does not jump")
    trial = make()
    statistics = trial.folder / "statistics.json"
    trial.given.add(statistics.name)
    if trial.journal:
        trial.start(environment=environment)
        trial.moment()
        trial.signal(trial.process.pid, signal.SIGKILL)
        trial.end()
        trial.given |= trial.half_written()
    start = time.monotonic()
    errors = trial.again("--progress", "json", "--stats", statistics, environment=environment)
    seconds = time.monotonic() - start
    trial.hit = True
    check_times([json.loads(line) for line in errors.splitlines() if line.startswith("{")], json.loads(statistics.read_text()), seconds)
    return trial


def check_times(progress, statistics, seconds):
    elapsed = [line["elapsed_s"] for line in progress]
    if not elapsed or elapsed != sorted(elapsed) or elapsed[0] < 0 or elapsed[-1] > seconds:
        raise Failure(f"the progress tells {elapsed} seconds, of {seconds:.3f}")
    if any(line["eta_s"] is not None and not 0 <= line["eta_s"] <= line["total"] * seconds for line in progress):
        raise Failure(f"the progress expects {[line['eta_s'] for line in progress]} seconds more")
    times = {name: value for name, value in statistics.items() if name.endswith("_s")}
    if any(not 0 <= value <= seconds for value in times.values()):
        raise Failure(f"the statistics tell {times}, of {seconds:.3f} seconds")
