#!/usr/bin/env python3
"""Mutants: would the tests notice a mistake in what meets rays and shades them?

Copies the project to build/mutants/source and changes single operators there (+ to -, < to >, && to ||, min to max, inside to
outside, true to false), each in an expression that the variable YARTE_MUTANT chooses when a program starts:

    return a + b;    becomes    return (mutant() == 17 ? (a - b) : (a + b));

So all mutants are compiled at once, and one run of the tests tells of one of them. Prints a table, and each mutant that no test
caught; exits with 1 if fewer than 95 in 100 were caught.
"""
import argparse
import collections
import concurrent.futures
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
OUT = ROOT / "build/mutants"
FILES = ["yarte/trace/" + name for name in (
    "box.h", "cone.h", "disc.h", "face.h", "frustum.h", "media.h", "nappe.h", "plane.h", "power.h", "sphere.h", "truncated_cone.h",
    "careful.cpp", "face.cpp", "phong.cpp", "search.cpp", "whitted.cpp", "lanes/faces-inl.h", "lanes/normals-inl.h", "lanes/points-inl.h",
    "lanes/power-inl.h", "lanes/search-inl.h", "lanes/shading-inl.h", "lanes/shadows-inl.h", "lanes/shapes-inl.h",
    "lanes/whitted-inl.h")]
# In this order, until one fails; each within a time in which it ends many times over.
TESTS = [("test_trace", []), ("test_hard", ["--gtest_filter=-*Attack*"]), ("test_same_bytes", []), ("test_hard", ["--gtest_filter=*Attack*"])]
TIMEOUT = 120

CHANGES = [(r" \+ ", " - "), (r" - ", " + "), (r" < ", " > "), (r" > ", " < "), (r" <= ", " > "), (r" >= ", " < "),
           (r" == ", " != "), (r" != ", " == "), (r" && ", " || "), (r" \|\| ", " && "), (r"\bmin\(", "max("), (r"\bmax\(", "min("),
           (r"\bMin\(", "Max("), (r"\bMax\(", "Min("), (r"\btrue\b", "false"), (r"\bfalse\b", "true"),
           (r"\binside\b", "outside"), (r"\boutside\b", "inside"), (r"(?<=[(, ])-(?=[a-z])", ""), (r"!(?=[a-z(])", "")]
# An expression that a statement of one line takes its value from.
STATEMENT = re.compile(r"^(\s*(?:return|(?:const )?[\w:]+(?:<\w+>)?[&*]? \w+ =|[\w.\[\]>-]+ [-+*/]?=) )([^{}]+)(;(?: //.*)?)$")
CONDITION = re.compile(r"^(\s*(?:\} else )?if \()([^{}]+)(\) (?:\{|return.*;|continue;|break;))$")
SWITCH = """// Which mutant this process is.
#pragma once
#include <cstdlib>
namespace yarte {
inline const int chosenMutant = std::getenv("YARTE_MUTANT") ? std::atoi(std::getenv("YARTE_MUTANT")) : 0;
inline int mutant() { return chosenMutant; }
} // namespace yarte
"""

Mutant = collections.namedtuple("Mutant", "file line before after is_condition")


def variants(expression):
    for pattern, replacement in CHANGES:
        for match in re.finditer(pattern, expression):
            yield expression[:match.start()] + replacement + expression[match.end():]


def is_candidate(line):
    return not re.search(r"\bconstexpr\b|\bstatic\b|\bauto\b|\busing\b|\[&|\[=|\[\]|\"|//.*=", line)


def is_one(expression):
    """Not several with commas between them."""
    flat = expression
    while (inner := re.sub(r"\([^()]*\)|<[\w:, ]*>|\[[^][]*\]", "", flat)) != flat:
        flat = inner
    return not re.search(r"[(),]", flat)


def all_mutants(originals):
    mutants = []
    for file, text in originals.items():
        for number, line in enumerate(text.splitlines()):
            for pattern in (STATEMENT, CONDITION) if is_candidate(line) else ():
                match = pattern.match(line)
                if match and is_one(match[2]):
                    mutants += [Mutant(file, number, match[2], changed, pattern is CONDITION) for changed in variants(match[2])]
    return mutants


def write(source, originals, mutants):
    """The files with all the mutants in them; those are counted from 1."""
    at = collections.defaultdict(lambda: collections.defaultdict(list))
    for number, mutant in enumerate(mutants, 1):
        if mutant:
            at[mutant.file][mutant.line].append((number, mutant))
    (source / "yarte/base/mutant.h").write_text(SWITCH)
    for file, original in originals.items():
        lines = original.splitlines()
        for line, here in at[file].items():
            # Both of one type: an optional and its negation would be two optionals.
            kind = "bool" if here[0][1].is_condition else ""
            chosen = "".join(f"yarte::mutant() == {number} ? {kind}({mutant.after}) : " for number, mutant in here)
            lines[line] = lines[line].replace(here[0][1].before, f"({chosen}{kind}({here[0][1].before}))", 1)
        first = next(i for i, line in enumerate(lines) if line.startswith("#include"))
        lines.insert(first, '#include "yarte/base/mutant.h"')
        text = "\n".join(lines) + "\n"
        if (source / file).read_text() != text:
            (source / file).write_text(text)


def build(source, originals, mutants):
    """Builds; a mutant that the compiler refuses is taken out (None), and it tries again."""
    subprocess.run(["cmake", "-S", source, "-B", OUT / "build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG",
                    "-DYARTE_HARDENING=OFF"], check=True, stdout=subprocess.DEVNULL)
    while True:
        write(source, originals, mutants)
        made = subprocess.run(["ninja", "-k", "0", "-C", OUT / "build", *{test for test, _ in TESTS}, "yarte"], capture_output=True, text=True)
        if made.returncode == 0:
            return
        bad = {(file, int(line)) for file, line in re.findall(r"(yarte/trace/[\w/.-]+):(\d+):\d+: (?:error|  +required)", made.stdout)}
        refused = [i for i, mutant in enumerate(mutants) if mutant and any(
            mutant.file == file and abs(line - 2 - mutant.line) <= 1 for file, line in bad)]
        if not refused:
            sys.exit(f"mutants: the build failed:\n{made.stdout[-3000:]}")
        print(f"{len(refused)} mutants do not compile", flush=True)
        for i in refused:
            mutants[i] = None


def catcher(number):
    """The test that fails for this mutant; nothing if none does."""
    for test, options in TESTS:
        try:
            done = subprocess.run([OUT / "build/tests" / test, "--gtest_brief=1", "--gtest_fail_fast", *options], timeout=TIMEOUT,
                                  cwd=OUT, env=os.environ | {"YARTE_MUTANT": str(number)}, stdout=subprocess.DEVNULL,
                                  stderr=subprocess.DEVNULL)
            if done.returncode != 0:
                return test
        except subprocess.TimeoutExpired:
            return f"{test}, endless"
    return None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("count", nargs="?", type=int, default=120, help="how many, drawn from all (default: 120)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=len(os.sched_getaffinity(0)))
    options = parser.parse_args()
    source = OUT / "source"
    shutil.rmtree(source, ignore_errors=True)
    shutil.copytree(ROOT, source, ignore=shutil.ignore_patterns("build", ".git"))
    originals = {file: (source / file).read_text() for file in FILES}
    found = all_mutants(originals)
    mutants = random.Random(options.seed).sample(found, min(options.count, len(found)))
    build(source, originals, mutants)
    if catcher(0):
        sys.exit("mutants: the tests fail without any mutant")
    alive = [number for number, mutant in enumerate(mutants, 1) if mutant]
    start = time.monotonic()
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        caught = dict(zip(alive, pool.map(catcher, alive)))
    counts = collections.Counter(caught.values())
    survivors = [number for number in alive if caught[number] is None]
    rate = 1 - len(survivors) / len(alive)
    print(f"{len(found)} possible mutants of {len(FILES)} files; {len(alive)} drawn (seed {options.seed}), {len(alive) - len(survivors)} caught, "
          f"{100 * rate:.1f} %, in {time.monotonic() - start:.0f} s\n\n| caught by | mutants |\n|---|---|")
    for test, count in counts.most_common():
        print(f"| {test or 'none'} | {count} |")
    for number in survivors:
        mutant = mutants[number - 1]
        print(f"\n{mutant.file}:{mutant.line + 1}: not caught:\n  - {mutant.before}\n  + {mutant.after}")
    sys.exit(0 if rate >= 0.95 else 1)


main()
