"""ci/bench processes: what a second process brings, beside what the machine gives two programs that have nothing to do with each
other: cores that share a clock, a cache or a memory bus are not two machines."""
import json
import pathlib
import statistics
import subprocess
import tempfile

from cases import find_scene
from measure import BIN, machine, run_yarte

SCENES = ("paper", "spheres")


def two_at_once(scene, size, folder):
    """Seconds to trace, of the slower of two programs with a process each."""
    stats = [folder / f"stats{i}.json" for i in range(2)]
    running = [subprocess.Popen([BIN / "yarte", scene, "--size", size, "--processes", "1", "--progress", "none", "--stats", file,
                                 "-o", file.with_suffix(".ppm")], stderr=subprocess.DEVNULL) for file in stats]
    if any([program.wait() for program in running]):
        raise SystemExit(f"bench: yarte failed on {scene}")
    return max(json.loads(file.read_text())["trace_s"] for file in stats)


def table(options):
    lines = [f"Pictures of {options.size}, seconds to trace (medians of {options.runs} runs in turn), {machine()}. `two at once`: two "
             "programs of one process each, the slower; the ceiling is what two processes could reach if dealing tiles cost nothing.",
             "", "| scene | one process | two processes | speed-up | two at once | ceiling | of the ceiling |", "|---" * 7 + "|"]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for name in SCENES:
            _, scene = find_scene(name, options.size, folder)
            runs = [(run_yarte(scene, options.size, 1, folder)[0]["trace_s"], run_yarte(scene, options.size, 2, folder)[0]["trace_s"],
                     two_at_once(scene, options.size, folder)) for _ in range(options.runs)]
            one, two, at_once = (statistics.median(column) for column in zip(*runs))
            gained = statistics.median(a / b for a, b, _ in runs)
            ceiling = 2 * statistics.median(a / c for a, _, c in runs)
            lines.append(f"| {name} | {one:.3f} | {two:.3f} | {gained:.2f} | {at_once:.3f} | {ceiling:.2f} | {100 * gained / ceiling:.0f} % |")
    return lines
