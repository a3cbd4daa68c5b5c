"""ci/bench kernels: nanoseconds per ray of what tracing consists of, by lane width."""
import json
import subprocess

from measure import KERNELS_BENCH, machine


def measured(runs):
    """Medians in seconds per ray by work and by (target, rays in a packet), in the order of the program."""
    output = subprocess.run([KERNELS_BENCH, f"--benchmark_repetitions={runs}", "--benchmark_min_time=0.05",
                             "--benchmark_enable_random_interleaving=true", "--benchmark_report_aggregates_only=true",
                             "--benchmark_format=json"], check=True, capture_output=True, text=True).stdout
    results = {}
    for entry in sorted(json.loads(output)["benchmarks"], key=lambda entry: entry["family_index"]):
        if entry.get("aggregate_name") == "median":
            work, target, lanes = entry["run_name"].split("/")
            results.setdefault(work, {})[target, int(lanes)] = entry["perRay"]
    return results


def table(options):
    if not KERNELS_BENCH.exists():
        raise SystemExit("bench: kernels needs a build with -DYARTE_BENCHMARKS=ON")
    results = measured(options.runs)
    targets = list(next(iter(results.values())))
    best = max(targets, key=lambda target: target[1])
    lines = [f"Nanoseconds per ray (medians of {options.runs} runs in turn) on one of {machine()}. In brackets: rays in a "
             "packet. `scalar` is the plain code of the shapes' headers, `SCALAR` the kernels with one lane.", "",
             "| work | " + " | ".join(f"{name} ({lanes})" for name, lanes in targets) + f" | scalar / {best[0]} |",
             "|---" * (len(targets) + 2) + "|"]
    for work, times in results.items():
        figures = [f"{times[t] * 1e9:.2f}" if t in times else "" for t in targets]
        ratio = f"{times['scalar', 1] / times[best]:.1f}" if ("scalar", 1) in times else ""
        lines.append(f"| {work} | " + " | ".join(figures) + f" | {ratio} |")
    return lines
