#!/usr/bin/env python3
"""A render is killed half way, something is altered, and it is told to go on: what YARTE (--resume) and POV-Ray (+C) then do, side by
side. The share of wrong pixels is against an uninterrupted render of what was asked for at last. Needs povray.
"""
import argparse
import pathlib
import random
import re
import shutil
import signal
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SIZE = (2000, 1500)


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


def yarte(output, *more):
    size = [] if "--size" in more else ["--size", "x".join(map(str, SIZE))]
    return [ROOT / "build/release/bin/yarte", "scene.yarte", "-o", output, *size, "--processes", "1", "--progress", "none",
            "--checkpoint", f"{output}.journal", *more]


def povray(output, *more):
    """A file that is there already is one to go on with only if +C says so."""
    return ["povray", "+Iscene.pov", f"+O{output}", "+FP", f"+W{SIZE[0]}", f"+H{SIZE[1]}", "-D", "+WT1", *more]


PROGRAMS = {"YARTE": (yarte_scene, yarte, ["--resume"]), "POV-Ray": (povray_scene, povray, ["+C"])}


def edit(file, before, after):
    text = file.read_text()
    assert before in text
    file.write_text(text.replace(before, after))


def flip(file):
    data = bytearray(file.read_bytes())
    for place in range(len(data) // 4, len(data), max(1, len(data) // 40)):
        data[place] ^= 0x15
    file.write_bytes(data)


def state_of(program, folder):
    if program == "YARTE":
        return folder / "out.ppm.journal"
    return next(file for file in folder.iterdir() if file.name.endswith(".pov-state"))


# What is altered; how, for each program; the options that a render has from then on.
ALTERATIONS = {
    "nothing": {"YARTE": (None, []), "POV-Ray": (None, [])},
    "a colour in the scene": {"YARTE": (lambda f: edit(f / "scene.yarte", "0.5 0.4 0.3 0.3 0.3", "0.1 0.4 0.6 0.3 0.3"), []),
                              "POV-Ray": (lambda f: edit(f / "scene.pov", "rgb <0.5, 0.4, 0.3>", "rgb <0.1, 0.4, 0.6>"), [])},
    "an option: antialiasing": {"YARTE": (None, ["--samples", "2"]), "POV-Ray": (None, ["+A0.1"])},
    "an option: the size": {"YARTE": (None, ["--size", f"{SIZE[0]}x{SIZE[1] - 200}"]), "POV-Ray": (None, [f"+H{SIZE[1] - 200}"])},
    "bytes of the state file": {"YARTE": (lambda f: flip(state_of("YARTE", f)), []),
                                "POV-Ray": (lambda f: flip(state_of("POV-Ray", f)), [])},
    "the mesh, the include file": {"YARTE": (lambda f: edit(f / "part.pmf", "0 2 2", "0 0 2"), []),
                                   "POV-Ray": (lambda f: edit(f / "part.inc", "<0, 2, 2>", "<0, 0, 2>"), [])},
}


def picture(file):
    """The size and the pixels of a PPM file of 8 bits."""
    data = file.read_bytes()
    head = re.match(rb"P6\s+(?:#.*\n)*(\d+)\s+(\d+)\s+255\s", data)
    pixels = data[head.end():]
    return head.groups(), [pixels[i:i + 3] for i in range(0, len(pixels), 3)]


def wrong_pixels(got, asked):
    (got_size, got_pixels), (asked_size, asked_pixels) = picture(got), picture(asked)
    if got_size != asked_size:
        return "another size"
    return f"{100 * sum(a != b for a, b in zip(got_pixels, asked_pixels)) / len(asked_pixels):.2f} %"


def killed_half_way(command, folder, output, seconds):
    """False if it was faster than that."""
    running = subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    time.sleep(0.6 * seconds)  # a part of it is the scene's reading, in which nothing is kept
    running.send_signal(signal.SIGKILL)
    return running.wait() == -signal.SIGKILL and not (folder / output).exists()


def message(errors):
    """What it says of that something is wrong or other than it was."""
    words = "warning", "error", "another", "damaged", "yarte:", "continu", "resum"
    lines = (line.strip() for line in errors.splitlines() if "Stream to console" not in line)
    said = next((line for line in lines if any(word in line.lower() for word in words)), "(none)")
    return said.replace("|", "\\|")[:160]


def resumed(program, alteration, folder):
    make, command, resume = PROGRAMS[program]
    make(folder)
    start = time.monotonic()
    subprocess.run(command("whole.ppm"), cwd=folder, check=True, capture_output=True)
    seconds = time.monotonic() - start
    if not killed_half_way(command("out.ppm"), folder, "out.ppm", seconds):
        raise SystemExit(f"resume-comparison: {program} was done before it was killed; the machine is too restless")
    alter, options = ALTERATIONS[alteration][program]
    if alter:
        alter(folder)
    done = subprocess.run(command("out.ppm", *resume, *options), cwd=folder, capture_output=True, text=True, errors="replace")
    subprocess.run(command("asked.ppm", *options), cwd=folder, check=True, capture_output=True)
    wrong = wrong_pixels(folder / "out.ppm", folder / "asked.ppm") if (folder / "out.ppm").exists() else "no picture"
    return f"{done.returncode} | {message(done.stderr)} | {wrong}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.parse_args()
    if shutil.which("povray") is None:
        raise SystemExit("resume-comparison: povray is not installed")
    print("| altered | program | exit code | message | wrong pixels |\n|---|---|---:|---|---:|", flush=True)
    for alteration in ALTERATIONS:
        for program in PROGRAMS:
            with tempfile.TemporaryDirectory() as name:
                print(f"| {alteration} | {program} | {resumed(program, alteration, pathlib.Path(name))} |", flush=True)


main()
