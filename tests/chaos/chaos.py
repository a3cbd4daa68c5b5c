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

from faults import FAULTS, clock_jumps
from trial import Failure, Fixtures, Trial

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def drawn(count, seed):
    """The faults of the trials: every one of them once, then by chance."""
    weights = [weight for _, weight in FAULTS.values()]
    return (list(FAULTS) + random.Random(seed).choices(list(FAULTS), weights, k=max(0, count - len(FAULTS))))[:count]


def table(rows):
    lines = ["| fault | trials | struck while rendering | ended with | run again | failures |", "|---|---:|---:|---|---:|---:|"]
    for name, row in rows.items():
        codes = ", ".join(f"{code} ({count})" for code, count in sorted(row["codes"].items(), key=lambda item: str(item[0])))
        lines.append(f"| {name} | {row['trials']} | {row['hit']} | {codes} | {row['again']} | {row['failures']} |")
    return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("faults", nargs="?", type=int, default=1000, help="how many (default: 1000)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int, metavar="K", help="trial K alone, whose folder is kept")
    parser.add_argument("--build", type=lambda name: pathlib.Path(name).resolve(), default=ROOT / "build/release", help="a build of this project")
    parser.add_argument("--markdown", type=pathlib.Path, metavar="FILE", help="the table, also to this file")
    options = parser.parse_args()
    names = drawn(options.faults, options.seed)
    shared = set(os.listdir("/dev/shm"))
    rows = collections.defaultdict(lambda: {"trials": 0, "hit": 0, "codes": collections.Counter(), "again": 0, "failures": 0})
    start = time.monotonic()
    folder = pathlib.Path(tempfile.mkdtemp(prefix="chaos-"))
    failures = []
    try:
        fixtures = Fixtures(options.build / "bin/yarte", ROOT / "scenes", folder / "undisturbed")
        for number, name in enumerate(names):
            if options.only is not None and number != options.only:
                continue
            here = folder / f"trial{number}"
            make = functools.partial(Trial, fixtures, here, random.Random(f"{options.seed} {number}"))
            fault = FAULTS[name][0]
            if fault is clock_jumps:
                fault = functools.partial(fault, shim=options.build / "tests/libclock_shim.so")
            row = rows[name]
            row["trials"] += 1
            try:
                trial, code, again = fault(make)
                row["hit"] += trial.hit
                row["again"] += again
                row["codes"][code] += 1
            except Failure as failure:
                row["failures"] += 1
                failures.append(number)
                print(f"chaos: {name}: {failure}\n       repeat: ci/chaos {options.faults} --seed {options.seed} --only {number}", flush=True)
            if options.only is None:
                shutil.rmtree(here, ignore_errors=True)
        left = set(os.listdir("/dev/shm")) - shared
        if left and options.only is None:
            print(f"chaos: shared memory is left: {sorted(left)}")
            failures.append(-1)
    finally:
        if options.only is None:
            shutil.rmtree(folder, ignore_errors=True)
        else:
            print(f"its folder: {folder}")
    text = (f"{sum(row['trials'] for row in rows.values())} faults (seed {options.seed}) in {time.monotonic() - start:.0f} s, "
            f"{len(failures)} failures.\n\n{table(rows)}\n")
    print(text)
    if options.markdown:
        options.markdown.write_text(text)
    sys.exit(1 if failures else 0)


main()
