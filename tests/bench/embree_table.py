"""ci/bench embree: primary rays on a mesh of a million triangles, beside Embree's own triangles in float packets."""
import json
import statistics
import subprocess

from height_field import side_of
from measure import EMBREE_BENCH, machine


def table(options):
    if not EMBREE_BENCH.exists():
        raise SystemExit("bench: embree needs a build with -DYARTE_BENCHMARKS=ON")
    found = json.loads(subprocess.run([EMBREE_BENCH, str(options.runs), str(side_of(options.triangles * 1e6))], check=True, capture_output=True,
                                      text=True).stdout)
    names = {"yarte": "YARTE: `renderTile` of a scene without lights, in double",
             "embree": f"Embree: `rtcIntersect{found['packet']}`, coherent, in float",
             "robust": "the same, robust"}
    ours = statistics.median(found["yarte"]["seconds"])
    lines = [f"Primary rays on {found['triangles']} triangles, {found['rays']} of them, {found['hits']} of which hit; one thread, "
             f"seconds of its processor time (medians of {options.runs} runs in turn), {machine()}.", "",
             "| work | s (min-max) | Mray/s | YARTE's speed / its | pixels hit by one alone |", "|---|---|---|---|---|"]
    for key, name in names.items():
        seconds = found[key]["seconds"]
        median = statistics.median(seconds)
        lines.append(f"| {name} | {median:.4f} ({min(seconds):.4f}-{max(seconds):.4f}) | {found['rays'] / median / 1e6:.1f} "
                     f"| {median / ours:.2f} | {found[key].get('different', '')} |")
    return lines
