"""ci/bench scaling: time and memory against the number of objects, ten times as many at a step, of one picture."""
import pathlib
import random
import statistics
import tempfile

import height_field
from measure import OUT, machine, run_yarte
from plot import lines as plot_lines


def triangles(count, scene):
    """One surface, cut more finely the more triangles there are; returns how many there are."""
    side = height_field.side_of(count)
    mesh = scene.with_suffix(".glb")
    height_field.make(mesh, side, smooth=False)
    scene.write_text(height_field.scene_of(mesh.name))
    return 2 * side * side


def spheres(count, scene):
    """In a cube, the smaller the more there are: what they cover stays the same."""
    rng, radius = random.Random(1), 1.5 / count ** 0.5
    with open(scene, "w") as out:
        out.write("camera_position 0 0 6\nfocus_point 0 0 0\ncamera_apertures 14 14\nlight_source 9 12 8 1\n"
                  "material 0.05 0.05 0.05 0.8 0.6 0.3 0.3 0.3 0.3 40 0 0 0\n")
        for _ in range(count):
            x, y, z = (rng.uniform(-1, 1) for _ in range(3))
            out.write(f"sphere {x:.6f} {y:.6f} {z:.6f} {radius:.6g}\n")
    return count


def decades(largest):
    """100, 1000, ... up to `largest`."""
    return [10 ** k for k in range(2, 10) if 10 ** k <= largest]


def table(options):
    largest = round(options.triangles * 1e6)
    lines = [f"One picture of {options.size} of more and more objects, seconds (medians of {options.runs} runs in turn), "
             f"{options.workers} process(es), {machine()}. Factor: of the time to trace, against a tenth of the objects. Bytes an "
             "object: of the peak of memory, against that of the first row.", "",
             "| objects | rays, millions | read | build | trace (min-max) | factor | peak memory, MB | bytes an object |",
             "|---" * 8 + "|"]
    curves = {}
    for kind, make, counts in (("triangles", triangles, decades(largest)), ("spheres", spheres, decades(largest / 10))):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            files = [folder / f"{count}.yarte" for count in counts]
            scenes = {make(count, file): file for count, file in zip(counts, files)}
            runs = {count: [] for count in scenes}
            for _ in range(options.runs):
                for count, scene in scenes.items():
                    runs[count].append(run_yarte(scene, options.size, options.workers, folder)[0])
        median = {count: {key: statistics.median(stats[key] for stats in found)
                          for key in ("parse_s", "build_s", "trace_s", "peak_rss_bytes")} for count, found in runs.items()}
        curves |= {f"{kind}: {what}": [(count, m[f"{what}_s"]) for count, m in median.items()] for what in ("build", "trace")}
        first, before = next(iter(median.values())), None
        for count, m in median.items():
            traces = [stats["trace_s"] for stats in runs[count]]
            rays = sum(runs[count][0]["rays"].values()) / 1e6
            factor = f"{m['trace_s'] / before['trace_s']:.2f}" if before else ""
            each = f"{(m['peak_rss_bytes'] - first['peak_rss_bytes']) / count:.0f}" if before else ""
            lines.append(f"| {count} {kind} | {rays:.2f} | {m['parse_s']:.3f} | {m['build_s']:.3f} | {m['trace_s']:.3f} "
                         f"({min(traces):.3f}-{max(traces):.3f}) | {factor} | {m['peak_rss_bytes'] / 1e6:.0f} | {each} |")
            before = m
    (OUT / "scaling-table.svg").write_text(plot_lines(f"Seconds against the number of objects, {options.size}", curves))
    return lines
