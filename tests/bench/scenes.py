#!/usr/bin/env python3
"""scenes.py NAME FOLDER: writes FOLDER/NAME.yarte (and its mesh), a workload for ci/bench, from a fixed seed.

spheres      10,000 spheres, 10 lights, shadows everywhere
generations  mirrors and glass, 10 generations
million      a height field of 1,002,528 triangles
"""
import math
import pathlib
import random
import sys

from height_field import HeightField, scene_of


def spheres(out, folder):
    rng = random.Random(1)
    out.write("camera_position 0 3 14\nfocus_point 0 -1 0\ncamera_apertures 28 28\nbackground_colour 0.1 0.1 0.15\n")
    for i in range(10):
        angle = 2 * math.pi * i / 10
        out.write(f"light_source {30 * math.cos(angle):.6g} 25 {30 * math.sin(angle):.6g} 0.12\n")
    out.write("material 0.02 0.02 0.02 0.6 0.6 0.6 0 0 0 1 0 0 0\npolygon 4 -40 -5 40 40 -5 40 40 -5 -40 -40 -5 -40\n")
    for _ in range(10000):
        colour = [rng.uniform(0.2, 1) for _ in range(3)]
        centre = [rng.uniform(-6, 6), rng.uniform(-5, 3), rng.uniform(-6, 6)]
        out.write("material 0.02 0.02 0.02 {:.3f} {:.3f} {:.3f} 0.3 0.3 0.3 40 0 0 0\n".format(*colour))
        out.write("sphere {:.6g} {:.6g} {:.6g} 0.1\n".format(*centre))


def generations(out, folder):
    rng = random.Random(2)
    out.write("camera_position 0 2 9\nfocus_point 0 0 0\ncamera_apertures 28 28\nbackground_colour 0.3 0.4 0.6\n"
              "max_recurse_level 10\nlight_source 8 12 6 0.8\nlight_source -9 8 3 0.4\n"
              "material 0.05 0.05 0.05 0.5 0.5 0.4 0.2 0.2 0.2 30 0.3 0 0\n"
              "polygon 4 -30 -3 30 30 -3 30 30 -3 -30 -30 -3 -30\n")
    for i in range(60):
        centre = [rng.uniform(-5, 5), rng.uniform(-2.4, 3), rng.uniform(-6, 3)]
        if i % 2:
            out.write("material 0 0 0 0.05 0.05 0.05 0.5 0.5 0.5 100 0 0.85 1.5\n")
        else:
            out.write("material 0 0 0 0.1 0.1 0.12 0.5 0.5 0.5 100 0.8 0 0\n")
        out.write("sphere {:.6g} {:.6g} {:.6g} 0.45\n".format(*centre))


def million(out, folder):
    HeightField(708).write(folder / "million.pmf", smooth=False)
    out.write(scene_of("million.pmf"))


if __name__ == "__main__":
    name, target = sys.argv[1], pathlib.Path(sys.argv[2])
    with open(target / f"{name}.yarte", "w") as scene:
        {"spheres": spheres, "generations": generations, "million": million}[name](scene, target)
