"""How ci/bench runs the programs that it compares."""
import contextlib
import json
import math
import os
import pathlib
import re
import subprocess
import tempfile
import time
from array import array

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
BIN = ROOT / "build/release/bin"
READ_ALONE = ROOT / "build/release/tests/read_alone"
KERNELS_BENCH = ROOT / "build/release/tests/kernels_bench"
TILE_COSTS = ROOT / "build/release/tests/tile_costs"
EMBREE_BENCH = ROOT / "build/release/tests/embree_bench"
OUT = ROOT / "build/bench"
CORES = len(os.sched_getaffinity(0))


def machine():
    """The processor and the cores that may be used."""
    info = pathlib.Path("/proc/cpuinfo").read_text()
    model = re.search(r"model name\s*: (.*)", info)
    vectors = "AVX-512" if "avx512f" in info else "AVX2" if "avx2" in info else "no AVX2"
    return f"{CORES} cores of {model[1].strip() if model else 'an unknown processor'} ({vectors})"


def run_yarte(scene, size, processes, folder, precision="double"):
    """Its statistics and its picture."""
    stats, picture = folder / "stats.json", folder / "picture.ppm"
    subprocess.run([BIN / "yarte", scene, "--size", size, "--processes", str(processes), "--progress", "none",
                    "--precision", precision, "--stats", stats, "-o", picture], check=True, stderr=subprocess.DEVNULL)
    return json.loads(stats.read_text()), picture.read_bytes()


def error_of_fast(scene, size, folder):
    """The largest and the root-mean-square difference of a picture in float from the one in double, in linear light, and the
    share of pixels beyond 2/255."""
    pictures = [folder / "fast.pfm", folder / "double.pfm"]
    for picture in pictures:
        subprocess.run([BIN / "yarte", scene, "--size", size, "--precision", picture.stem, "-o", picture], check=True,
                       stderr=subprocess.DEVNULL)
    fast, double = [array("f", picture.read_bytes().split(b"\n", 3)[3]) for picture in pictures]
    errors = [abs(a - b) for a, b in zip(fast, double)]
    worst = [max(pixel) for pixel in zip(*[iter(errors)] * 3)]
    return max(errors), math.sqrt(sum(e * e for e in errors) / len(errors)), sum(e > 2 / 255 for e in worst) / len(worst)


def run_povray(sdl, size, threads, folder):
    """Seconds of parsing and of tracing, as it states them itself, and the peak of memory in MB."""
    width, height = size.split("x")
    with tempfile.TemporaryFile() as log:
        process = subprocess.Popen(["povray", f"+I{sdl}", f"+O{folder / 'povray.ppm'}", "+FP16", f"+W{width}",
                                    f"+H{height}", "-D", "-A", "-P", f"+WT{threads}", "+Q9", "File_Gamma=1", f"+L{sdl.parent}"],
                                   stdout=subprocess.DEVNULL, stderr=log, cwd=folder)
        _, status, usage = os.wait4(process.pid, 0)
        log.seek(0)
        text = log.read().decode(errors="replace")
    if os.waitstatus_to_exitcode(status) != 0:
        raise SystemExit(f"bench: povray failed on {sdl}:\n{text[-2000:]}")
    times = {kind: float(seconds) for kind, seconds in re.findall(r"(Parse|Trace) Time:.*?\(([\d.]+) seconds\)", text)}
    return times["Parse"], times["Trace"], usage.ru_maxrss * 1024 / 1e6


@contextlib.contextmanager
def on_cores(count):
    """What is run meanwhile has so many cores: yarte builds trees on all there are, whatever its number of workers."""
    before = os.sched_getaffinity(0)
    os.sched_setaffinity(0, sorted(before)[:count])
    try:
        yield
    finally:
        os.sched_setaffinity(0, before)


def clocked(run):
    """The seconds that `run` takes, and what it returns."""
    begin = time.monotonic()
    result = run()
    return time.monotonic() - begin, result


def resources(command, folder, good=(0,)):
    """Seconds by the clock, and what the system says of the process (ru_utime, ru_maxrss, ...)."""
    begin = time.monotonic()
    process = subprocess.Popen([str(word) for word in command], cwd=folder, stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if os.waitstatus_to_exitcode(status) not in good:
        raise SystemExit(f"bench: {command} failed")
    return time.monotonic() - begin, usage


def timed(command, folder, good=(0,)):
    """Seconds and the peak of memory, in MB."""
    seconds, usage = resources(command, folder, good)
    return seconds, usage.ru_maxrss * 1024 / 1e6


def convert(scene, target, *flags):
    """By yarte-convert; returns `target`."""
    subprocess.run([BIN / "yarte-convert", scene, target, *flags], check=True, stderr=subprocess.DEVNULL)
    return target


def read_alone(what, file):
    """Seconds and the peak of memory, in MB."""
    text = subprocess.run([READ_ALONE, what, file], check=True, capture_output=True, text=True).stdout
    return tuple(map(float, text.split()))
