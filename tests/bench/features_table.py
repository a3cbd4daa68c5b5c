"""ci/bench features: what features cost scenes that do not use them, and scenes that do.

Unused: each feature's last revision against the one before its first, both built here from the project's history, on scenes
without it. Instructions are counted by valgrind, exactly; it has no AVX-512, so these are the kernels for AVX2. They are those of
a picture of 256x256 pixels less those of one of 16x16, which leaves out starting and building. Seconds are of processor time, of
pictures of 1024x1024, medians of runs in turn.

Used: the same scene with and without, in seconds.
"""
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import tempfile

from cases import find_scene
from measure import BIN, OUT, ROOT, machine, resources

# A feature, and the revisions before and with it.
HISTORY = [
    ("cylinders, frustums, planes", "6ff1f18^", "6ff1f18"),
    ("tints", "30290b9^", "108126a"),
    ("light buffers", "56e80ba^", "56e80ba"),
    ("--samples", "2737167^", "2737167"),
    ("--checkpoint", "bb1b8a6^", "bb1b8a6"),
    ("profile in --stats", "4de1be9^", "86250f4"),
    ("--precision fast", "6e5761a^", "dfdb75f"),
    ("right decisions in every hard case", "0bf9654^", "0bf9654"),
]
UNUSING = ("paper", "spheres")

PLAIN = "material 0.1 0.1 0.1 0.6 0.5 0.4 0 0 0 1 0 0 0"
# A feature; what the material is then; more options.
USES = [
    ("specular light", "material 0.1 0.1 0.1 0.6 0.5 0.4 0.3 0.3 0.3 40 0 0 0", []),
    ("mirrors (cr 0.3)", "material 0.1 0.1 0.1 0.6 0.5 0.4 0 0 0 1 0.3 0 0", []),
    ("transmission (ct 0.3, ior 1)", "material 0.1 0.1 0.1 0.6 0.5 0.4 0 0 0 1 0 0.3 1", []),
    ("refraction (ct 0.3, ior 1.3)", "material 0.1 0.1 0.1 0.6 0.5 0.4 0 0 0 1 0 0.3 1.3", []),
    ("refraction with a tint", "material 0.1 0.1 0.1 0.6 0.5 0.4 0 0 0 1 0 0.3 1.3\ntint 1 0.5 0.2", []),
    ("--samples 2", PLAIN, ["--samples", "2"]),
    ("--checkpoint", PLAIN, ["--checkpoint", "{folder}/journal"]),
    ("--stats", PLAIN, ["--stats", "{folder}/stats.json"]),
    ("--aov", PLAIN, ["--aov", "{folder}/aov.exr"]),
    ("--precision fast", PLAIN, ["--precision", "fast"]),
]


def built(revision):
    """The program of that revision; None where the history lacks it."""
    found = subprocess.run(["git", "rev-parse", "--verify", "--quiet", revision + "^{commit}"], cwd=ROOT, capture_output=True,
                           text=True)
    if found.returncode != 0:
        return None
    commit = found.stdout.strip()
    program = OUT / "features" / f"yarte-{commit[:10]}"
    if not program.exists():
        print(f"building {revision}", flush=True)
        tree = program.parent / "tree"
        tree.parent.mkdir(parents=True, exist_ok=True)
        subprocess.run(["git", "worktree", "add", "--detach", tree, commit], cwd=ROOT, check=True, capture_output=True)
        try:
            subprocess.run(["cmake", "--preset", "release"], cwd=tree, check=True, capture_output=True)
            subprocess.run(["cmake", "--build", "build/release", "--target", "yarte"], cwd=tree, check=True, capture_output=True)
            shutil.copy(tree / "build/release/bin/yarte", program)
        finally:
            subprocess.run(["git", "worktree", "remove", "--force", tree], cwd=ROOT, check=True)
    return program


def without_timer(folder):
    """A library to be loaded first. Older revisions link libhwy, which looks at its timer when it is loaded, by an instruction
    that valgrind does not know."""
    library = folder / "without_timer.so"
    if not library.exists():
        subprocess.run(["c++", "-shared", "-fPIC", "-x", "c++", "-", "-o", library], check=True, text=True,
                       input="namespace hwy::platform { unsigned long TimerResolution() { return 1; } }")
    return library


def instructions(program, scene, folder):
    environment = os.environ | {"LD_PRELOAD": str(without_timer(folder))}

    def count(size):
        command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/callgrind", program, scene, "--size", size,
                   "--processes", "0", "-o", folder / "picture.ppm"]
        text = subprocess.run(command, check=True, capture_output=True, text=True, env=environment).stderr
        return int(re.search(r"Collected : (\d+)", text)[1])

    return count("256x256") - count("16x16")


def seconds(program, scene, folder, options=()):
    """Of processor time, the system's left out: it is mostly that of fresh memory, and varies."""
    (folder / "journal").unlink(missing_ok=True)
    command = [program, scene, "--size", "1024x1024", "-o", folder / "picture.ppm", "--processes", "1"]
    command += [word.format(folder=folder) for word in options]
    return resources(command, folder)[1].ru_utime


def paired(first, second, runs):
    """Median times, in turn."""
    pairs = [(first(), second()) for _ in range(runs)]
    return [statistics.median(times) for times in zip(*pairs)]


def per_cent(after, before):
    return f"{100 * (after / before - 1):+.2f} %"


def unused_rows(options, folder):
    for name, before, after in HISTORY:
        programs = built(before), built(after)
        if None in programs:
            yield f"| {name} | (the history is not here) |" + " |" * 2 * len(UNUSING)
            continue
        cells = []
        for scene_name in UNUSING:
            _, scene = find_scene(scene_name, "1024x1024", folder)
            counts = [instructions(program, scene, folder) for program in programs]
            times = paired(*(lambda p=p: seconds(p, scene, folder) for p in programs), options.runs)
            cells += [per_cent(counts[1], counts[0]), per_cent(times[1], times[0])]
        yield f"| {name} | {before} .. {after} | " + " | ".join(cells) + " |"


def used_rows(options, folder):
    _, spheres = find_scene("spheres", "1024x1024", folder)
    lines = spheres.read_text().splitlines()
    lights = [line for line in lines if line.startswith("light_source")]
    text = "\n".join(line for line in lines if line not in lights[1:]) + "\n"
    plain = folder / "plain.yarte"
    plain.write_text(re.sub(r"^material .*$", PLAIN, text, flags=re.M))
    for name, material, more in USES:
        scene = folder / "with.yarte"
        scene.write_text(re.sub(r"^material .*$", material, text, flags=re.M))
        program = BIN / "yarte"
        without, used = paired(lambda: seconds(program, plain, folder), lambda: seconds(program, scene, folder, more), options.runs)
        yield f"| {name} | {without:.3f} | {used:.3f} | {used / without:.2f} |"


def table(options):
    lines = [f"Medians of {options.runs} runs in turn, {machine()}.", "",
             "Scenes that do not use the feature: more instructions, and processor time, with it than before it.", "",
             "| feature | revisions | " + " | ".join(f"{scene}: instructions | {scene}: time" for scene in UNUSING) + " |",
             "|---|---|" + "---:|" * 2 * len(UNUSING)]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for row in unused_rows(options, folder):
            print(row, flush=True)
            lines.append(row)
        lines += ["", "Scenes that do: 10,000 spheres and one light, seconds.", "", "| feature | without | with | ratio |",
                  "|---|---:|---:|---:|"]
        for row in used_rows(options, folder):
            print(row, flush=True)
            lines.append(row)
    return lines
