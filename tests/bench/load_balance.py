"""ci/bench balance: how evenly tiles would load more workers than this machine has cores.

What each tile costs is measured on one core (tile_costs); what 32 workers, as many as the paper had, and 256 would do with
these tiles is simulated. Each worker takes the next tile when it is done with its last. Beside that the paper's way: the picture
is cut into as many strips as there are workers.

Efficiency is the work over the product of workers and the time until the last is done. The work is that of the tiles of
the shape that costs least, so that what small tiles cost more, and what dealing a tile costs, counts as lost. Not simulated
is what a machine with so many cores does to each: its shared memory and caches, its clock.
"""
import heapq
import json
import pathlib
import subprocess
import tempfile

from cases import find_scene
from measure import OUT, TILE_COSTS, machine
from plot import bars

WORKERS = (32, 256)
SIDES = (8, 16, 32, 64)


def time_until_done(costs, workers):
    """Of tiles that are dealt in this order."""
    done_at = [0.0] * workers
    for cost in costs:
        heapq.heapreplace(done_at, done_at[0] + cost)
    return max(done_at)


def row_by_row(costs, columns):
    return costs


def centre_first(costs, columns):
    middle_x, middle_y = (columns - 1) / 2, (len(costs) / columns - 1) / 2
    nearest = sorted(range(len(costs)), key=lambda i: (i % columns - middle_x) ** 2 + (i // columns - middle_y) ** 2)
    return [costs[i] for i in nearest]


def costliest_first(costs, columns):
    return sorted(costs, reverse=True)


ORDERS = {"row by row": row_by_row, "centre first": centre_first, "costliest first (not to be had)": costliest_first}


def measured(scene, width, height, runs):
    """The costs of tiles by shape, as "32x32", and what dealing a square one costs."""
    shapes = [f"{side}x{side}" for side in SIDES] + [f"{width}x{-(-height // workers)}" for workers in WORKERS]
    output = subprocess.run([TILE_COSTS, scene, f"{width}x{height}", str(runs), *shapes], check=True, capture_output=True,
                            text=True).stdout
    return json.loads(output)


def efficiencies(tiles, width, height):
    """By (workers, "strips") and by (workers, order, side)."""
    work = min(sum(shape["seconds"]) for shape in tiles.values())
    result = {}
    for workers in WORKERS:
        strip_height = -(-height // workers)
        # A strip is not dealt, but its pixels have to be gathered: most of what dealing a large tile costs.
        gathering = tiles["64x64"]["deal"] / 64 ** 2 * width * strip_height
        slowest = max(tiles[f"{width}x{strip_height}"]["seconds"]) + gathering
        result[workers, "strips"] = work / (workers * slowest)
        for side in SIDES:
            shape = tiles[f"{side}x{side}"]
            costs = [cost + shape["deal"] for cost in shape["seconds"]]
            for name, order in ORDERS.items():
                time = time_until_done(order(costs, -(-width // side)), workers)
                result[workers, name, side] = work / (workers * time)
    return result


def default_scenes(corpora):
    spd = [f"{corpora}/spd/{name}.pov" for name in ("balls_4", "gears_2", "jacks_4", "tetra_4")] if corpora else []
    return ["paper", "spheres", "generations", *spd]


def table(options):
    if not TILE_COSTS.exists():
        raise SystemExit("bench: balance needs a build with -DYARTE_BENCHMARKS=ON")
    width, height = map(int, options.size.split("x"))
    lines = [f"Efficiency of many workers at {options.size}, in per cent: simulated from the cost of each tile (medians of "
             f"{options.runs} passes on one of {machine()}), dealing included. Strips: one for each worker, as in the paper.", "",
             "| workers | scene | strips | order of tiles | " + " | ".join(f"{side}x{side}" for side in SIDES) + " |",
             "|---" * (4 + len(SIDES)) + "|"]
    found, dealing = {}, []
    for name in options.scenes or default_scenes(options.corpora):
        with tempfile.TemporaryDirectory() as folder_name:
            case, scene = find_scene(name, options.size, pathlib.Path(folder_name))
            tiles = measured(scene, width, height, options.runs)
        found[case] = efficiencies(tiles, width, height)
        per_tile = ", ".join(f"{tiles[f'{side}x{side}']['deal'] * 1e6:.1f}" for side in SIDES)
        seconds = ", ".join(f"{sum(tiles[f'{side}x{side}']['seconds']):.3f}" for side in SIDES)
        dealing.append(f"- {case}: {seconds} s of tracing in tiles of {', '.join(map(str, SIDES))}; dealing a tile: {per_tile} µs")
        print(dealing[-1], flush=True)
    for workers in WORKERS:
        for case, result in found.items():
            for order in ORDERS:
                cells = " | ".join(f"{100 * result[workers, order, side]:.0f}" for side in SIDES)
                lines.append(f"| {workers} | {case} | {100 * result[workers, 'strips']:.0f} | {order} | {cells} |")
    plotted = {}
    for case, result in found.items():
        plotted |= {f"{case}: strips": 100 * result[32, "strips"], f"{case}: tiles": 100 * result[32, "row by row", 32]}
    (OUT / "balance-table.svg").write_text(bars(f"Efficiency of 32 workers, per cent, {options.size}", plotted))
    return lines + [""] + dealing
