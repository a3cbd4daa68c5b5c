"""ci/bench mesh: a large mesh from file to picture, flat and smooth, beside POV-Ray and its mesh2; and reading it alone."""
import pathlib
import statistics
import subprocess
import tempfile

import height_field
from height_field import scene_of, side_of
from measure import BIN, OUT, clocked, convert, machine, on_cores, read_alone, run_povray, run_yarte
from plot import bars

median = statistics.median


def seconds(times):
    return f"{median(times):.3f} ({min(times):.3f}-{max(times):.3f})"


def disagreement(scenes, size, folder):
    """What yarte-validate says of the first scene whose picture is not POV-Ray's; None: all are equal."""
    for scene in scenes:
        run = subprocess.run([BIN / "yarte-validate", scene, "--size", size, "-o", folder / "report"], capture_output=True,
                             text=True)
        if run.returncode != 0:
            return run.stdout.splitlines()[0] if run.stdout else run.stderr
    return None


def table(options):
    side = side_of(options.triangles * 1e6)
    lines = [f"{2 * side * side} triangles at {options.size}, seconds (medians of {options.runs} runs in turn), "
             f"{options.workers} process(es), thread(s) and core(s) of {machine()}. POV-Ray reads a mesh2 with a plain texture. Whole: "
             "from the start of the program to its end, from file to picture.", "",
             "| mesh | YARTE trace (min-max) | POV-Ray trace (min-max) | ratio | whole: .glb | ratio | whole: .pmf | ratio "
             "| whole: POV-Ray |", "|---" * 9 + "|"]
    reading = ["", "Reading alone:", "", "| file | MB | s (min-max) | MB/s | peak memory, MB |", "|---" * 5 + "|"]
    ratios = {}
    for kind in ("flat", "smooth"):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            files = {extension: folder / f"{kind}.{extension}" for extension in ("glb", "pmf")}
            scenes = {}
            for extension, file in files.items():
                height_field.make(file, side, kind == "smooth")
                scenes[extension] = folder / f"{kind}-{extension}.yarte"
                scenes[extension].write_text(scene_of(file.name))
            if problem := disagreement(scenes.values(), options.size, folder):
                lines.append(f"| {kind} | no ratio: the pictures differ: {problem} |")
                continue
            sdl = convert(scenes["pmf"], folder / "plain.pov", "--plain-textures")
            ours, reads, theirs = {"glb": [], "pmf": []}, {"glb": [], "pmf": []}, []
            with on_cores(options.workers):
                for _ in range(options.runs):
                    for extension, scene in scenes.items():
                        ours[extension].append(clocked(lambda: run_yarte(scene, options.size, options.workers, folder)[0]))
                        reads[extension].append(read_alone("mesh", files[extension]))
                    theirs.append(clocked(lambda: run_povray(sdl, options.size, options.workers, folder)))
            trace = [stats["trace_s"] for runs in ours.values() for _, stats in runs]
            their_trace = [t for _, (_, t, _) in theirs]
            whole = {extension: [s for s, _ in runs] for extension, runs in ours.items()}
            their_whole = [s for s, _ in theirs]
            found = {"trace": median(their_trace) / median(trace)}
            found |= {f".{extension}": median(their_whole) / median(whole[extension]) for extension in whole}
            ratios |= {f"{kind}: {what}": ratio for what, ratio in found.items()}
            lines.append(f"| {kind} | {seconds(trace)} | {seconds(their_trace)} | {found['trace']:.1f} "
                         f"| {seconds(whole['glb'])} | {found['.glb']:.1f} | {seconds(whole['pmf'])} | {found['.pmf']:.1f} "
                         f"| {seconds(their_whole)} |")
            for extension, runs in reads.items():
                size, times = files[extension].stat().st_size / 1e6, [s for s, _ in runs]
                reading.append(f"| {kind} .{extension} | {size:.1f} | {seconds(times)} | {size / median(times):.0f} "
                               f"| {median(mb for _, mb in runs):.0f} |")
    if ratios:
        title = f"POV-Ray's time over YARTE's, {2 * side * side} triangles, {options.size}"
        (OUT / "mesh-table.svg").write_text(bars(title, ratios))
    return lines + reading
