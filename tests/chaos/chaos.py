#!/usr/bin/env python3
"""Chaos: faults at random moments of small renders. Whatever happens, the picture is in the end that of an undisturbed render, or
the program says why there is none; no process, no half-written file is left. README.md tells what is promised of each fault.

A trial is repeated by its seed and number: --seed S --only K.
"""
import argparse
import collections
import functools
import os
import pathlib
import random
import shutil
import sys
import tempfile
import time

from faults import FAULTS, NOT_SANITIZED
from surroundings import clock_jumps
from trial import Failure, Fixtures, Trial

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def drawn(count, seed, leave_out):
    """The faults of the trials: every one of them once, then by chance."""
    faults = {name: entry for name, entry in FAULTS.items() if entry[0] not in leave_out}
    rng = random.Random(seed)
    names = list(faults) + rng.choices(list(faults), [weight for _, weight in faults.values()], k=max(0, count - len(faults)))
    return names[:count]


class Row:
    """What was seen of one fault."""

    def __init__(self):
        self.trials = self.hit = self.again = self.failures = 0
        self.outcomes = collections.Counter()

    def add(self, trial):
        self.hit += trial.hit
        self.again += trial.ran_again
        self.outcomes[trial.outcome] += 1


def table(rows):
    lines = ["| fault | trials | struck while rendering | ended with | run again | failures |", "|---|---:|---:|---|---:|---:|"]
    for name, row in rows.items():
        outcomes = ", ".join(f"{outcome} ({count})" for outcome, count in sorted(row.outcomes.items()))
        lines.append(f"| {name} | {row.trials} | {row.hit} | {outcomes} | {row.again} | {row.failures} |")
    return "\n".join(lines)


def shared_memory():
    return set(os.listdir("/dev/shm"))


def abandoned(names):
    """Those of the names in /dev/shm that are still there and that no process has open or mapped."""
    used = set()
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        for link in (*process.glob("fd/*"), *process.glob("map_files/*")):
            try:
                used.add(os.readlink(link))
            except OSError:
                pass
    return sorted(name for name in names & shared_memory() if f"/dev/shm/{name}" not in used)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("faults", nargs="?", type=int, default=1000, help="how many (default: 1000)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, metavar="K", help="trial K alone, whose folder is kept")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release", help="a build of this project")
    parser.add_argument("--sanitized", action="store_true", help="the build has sanitizers: no limits of memory, no other libraries")
    parser.add_argument("--markdown", type=pathlib.Path, metavar="FILE", help="the table, also to this file")
    options = parser.parse_args()
    build = options.build.resolve()
    names = drawn(options.faults, options.seed, NOT_SANITIZED if options.sanitized else ())
    numbers = range(len(names)) if options.only is None else [options.only]
    repeat = f"ci/chaos {options.faults} --seed {options.seed}{' --sanitized' if options.sanitized else ''}"
    shared = shared_memory()
    rows = collections.defaultdict(Row)
    start = time.monotonic()
    folder = pathlib.Path(tempfile.mkdtemp(prefix="chaos-"))
    failures = 0
    try:
        fixtures = Fixtures(build / "bin/yarte", ROOT / "scenes", folder / "undisturbed")
        for number in numbers:
            name = names[number]
            here = folder / f"trial{number}"
            fault = FAULTS[name][0]
            if fault is clock_jumps:
                fault = functools.partial(fault, shim=build / "tests/libclock_shim.so")
            rows[name].trials += 1
            try:
                rows[name].add(fault(functools.partial(Trial, fixtures, here, random.Random(f"{options.seed} {number}"))))
            except Failure as failure:
                rows[name].failures += 1
                failures += 1
                print(f"chaos: {name}: {failure}\n       repeat: {repeat} --only {number}", flush=True)
            if options.only is None:
                shutil.rmtree(here, ignore_errors=True)
        if left := abandoned(shared_memory() - shared):
            failures += 1
            print(f"chaos: shared memory is left: {left}")
    finally:
        if options.only is None:
            shutil.rmtree(folder, ignore_errors=True)
        else:
            print(f"its folder: {folder}")
    text = f"{len(numbers)} faults (seed {options.seed}) in {time.monotonic() - start:.0f} s, {failures} failures.\n\n{table(rows)}\n"
    print(text)
    if options.markdown:
        options.markdown.write_text(text)
    sys.exit(1 if failures else 0)


main()
