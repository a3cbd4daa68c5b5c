#!/usr/bin/env python3
"""A render is killed half way, something is altered, and it is told to go on: what YARTE and POV-Ray (+C) then do, side by side.
The share of wrong pixels is against an uninterrupted render of what was asked for at last. Needs povray.
"""
import argparse
import pathlib
import random
import signal
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SIZE = (1200, 900)


def spheres():
    rng = random.Random(3)
    return [[round(rng.uniform(-2, 2), 3) for _ in range(3)] for _ in range(300)]


def yarte_scene(folder):
    text = ("camera_position 0 0 7\nfocus_point 0 0 0\ncamera_apertures 40 30\nlight_source 5 9 6 1\nmax_recurse_level 5\n"
            "material 0.1 0.1 0.1 0.5 0.4 0.3 0.3 0.3 0.3 30 0.4 0 0\nmesh part.pmf 1 1 0 0 0 1 0 0 0 1 0 0 0\n")
    text += "".join(f"sphere {x} {y} {z} 0.25\n" for x, y, z in spheres())
    (folder / "scene.yarte").write_text(text)
    (folder / "part.pmf").write_text("3 1\n-2 -2 2\n2 -2 2\n0 2 2\n0 1 2\n")


def povray_scene(folder):
    finish = "texture { pigment { rgb <0.5, 0.4, 0.3> } finish { ambient 0.1 diffuse 1 phong 0.3 phong_size 30 reflection 0.4 } }"
    text = ("#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level 5 }\ncamera { location <0, 0, 7> look_at 0 angle 40 }\n"
            "light_source { <5, 9, 6> rgb 1 }\n#include \"part.inc\"\n")
    text += "".join(f"sphere {{ <{x}, {y}, {z}>, 0.25 {finish} }}\n" for x, y, z in spheres())
    (folder / "scene.pov").write_text(text)
    (folder / "part.inc").write_text(f"triangle {{ <-2, -2, 2>, <2, -2, 2>, <0, 2, 2> {finish} }}\n")


def yarte(folder, output, *more):
    return [ROOT / "build/release/bin/yarte", "scene.yarte", "-o", output, "--size", "x".join(map(str, SIZE)), "--processes", "1", "--progress", "none",
            "--checkpoint", f"{output}.journal", *more]


def povray(folder, output, *more):
    return ["povray", "+Iscene.pov", f"+O{output}", "+FP", f"+W{SIZE[0]}", f"+H{SIZE[1]}", "-D", "+WT1", *more]


PROGRAMS = {"YARTE": (yarte_scene, yarte, ["--resume"]), "POV-Ray": (povray_scene, povray, ["+C"])}


def edit(file, before, after):
    text = file.read_text()
    assert before in text
    file.write_text(text.replace(before, after))


def flip(file):
    """A run of bytes in the middle, as when a block of a disk went bad."""
    data = bytearray(file.read_bytes())
    middle = len(data) // 2
    for place in range(middle, min(middle + 4096, len(data))):
        data[place] ^= 0x15
    file.write_bytes(data)


def state_of(program, folder):
    if program == "YARTE":
        return folder / "out.ppm.journal"
    return next(file for file in folder.iterdir() if file.name.endswith(".pov-state"))


# What is altered; how, for each program; the options that a render has from then on.
ALTERATIONS = {
    "nothing": {"YARTE": (lambda f: None, []), "POV-Ray": (lambda f: None, [])},
    "a colour in the scene": {"YARTE": (lambda f: edit(f / "scene.yarte", "0.5 0.4 0.3 0.3 0.3", "0.1 0.4 0.6 0.3 0.3"), []),
                              "POV-Ray": (lambda f: edit(f / "scene.pov", "rgb <0.5, 0.4, 0.3>", "rgb <0.1, 0.4, 0.6>"), [])},
    "an option (samples, antialiasing)": {"YARTE": (lambda f: None, ["--samples", "2"]), "POV-Ray": (lambda f: None, ["+A0.1"])},
    "bytes of the state file": {"YARTE": (lambda f: flip(state_of("YARTE", f)), []), "POV-Ray": (lambda f: flip(state_of("POV-Ray", f)), [])},
    "the mesh or include file": {"YARTE": (lambda f: edit(f / "part.pmf", "0 2 2", "0 0 2"), []),
                                 "POV-Ray": (lambda f: edit(f / "part.inc", "<0, 2, 2>", "<0, 0, 2>"), [])},
}


def pixels(file):
    data = file.read_bytes()
    body = data[-3 * SIZE[0] * SIZE[1]:]
    return [body[i:i + 3] for i in range(0, len(body), 3)]


def resumed(program, alteration, folder):
    make, command, resume = PROGRAMS[program]
    make(folder)
    start = time.monotonic()
    subprocess.run(command(folder, "whole.ppm"), cwd=folder, check=True, capture_output=True)
    seconds = time.monotonic() - start
    running = subprocess.Popen(command(folder, "out.ppm"), cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(0.6 * seconds)
    running.send_signal(signal.SIGKILL)
    running.wait()
    alter, options = ALTERATIONS[alteration][program]
    alter(folder)
    done = subprocess.run(command(folder, "out.ppm", *resume, *options), cwd=folder, capture_output=True, text=True, errors="replace")
    subprocess.run(command(folder, "asked.ppm", *options), cwd=folder, check=True, capture_output=True)
    said = [line.strip() for line in done.stderr.splitlines() if "Stream" not in line and any(word in line.lower() for word in ("warning", "error", "another", "damaged", "yarte:"))]
    said = said[0][:110] if said else ""
    if done.returncode != 0 or not (folder / "out.ppm").exists():
        return f"{done.returncode} | {said} | no picture"
    wrong = sum(a != b for a, b in zip(pixels(folder / "out.ppm"), pixels(folder / "asked.ppm")))
    return f"{done.returncode} | {said} | {100 * wrong / (SIZE[0] * SIZE[1]):.2f} %"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.parse_args()
    print("| altered | program | exit code | message | wrong pixels |\n|---|---|---:|---|---:|", flush=True)
    for alteration in ALTERATIONS:
        for program in PROGRAMS:
            with tempfile.TemporaryDirectory() as name:
                print(f"| {alteration} | {program} | {resumed(program, alteration, pathlib.Path(name))} |", flush=True)


main()
