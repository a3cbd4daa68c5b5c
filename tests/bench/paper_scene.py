#!/usr/bin/env python3
"""paper_scene.py N: a scene of N objects (spheres, boxes, cones, ... in a room) as the paper's section 3 timed them.

The paper gives only the numbers of objects (21, 39 and 189); kinds, places and materials here come from a fixed seed.
"""
import random
import sys

count = int(sys.argv[1])
rng = random.Random(count)


def n(*values):
    return " ".join(f"{v:.6g}" for v in values)


print(f"""image_resolution 512 512
camera_position 0 0 120
camera_apertures 45 45
focus_point 0 0 0
light_source 120 120 120 0.8
light_source -120 150 -60 0.8
max_recurse_level 2
gamma_correction_factor 2.2

material 0.02 0.1 0.02 0 0.7 0 0.2 0.2 0.2 100 0.3 0 0
polygon 4 -300 -100 200 300 -100 200 300 -100 -500 -300 -100 -500
""")
size = 60 / count ** (1 / 3)
for i in range(count - 1):
    colour = [rng.uniform(0.1, 0.9) for _ in range(3)]
    mirror = rng.choice([0, 0.3, 0.6])
    glass = rng.choice([0, 0, 0, 0.5])
    print("material", n(*[c * 0.2 for c in colour], *colour, 0.3, 0.3, 0.3, rng.choice([20, 100]), mirror, glass, 1.2))
    centre = [rng.uniform(-90, 90), rng.uniform(-80, 80), rng.uniform(-90, 40)]
    kind = i % 5
    if kind == 0:
        print("sphere", n(*centre, size))
    elif kind == 1:
        print("box", n(*centre, size, size * 1.5, size))
        print("instance_referential 0.8 0.6 0 -0.6 0.8 0")
    elif kind == 2:
        print("cone", n(*centre, size, size * 1.5))
    elif kind == 3:
        print("truncated_cone", n(*centre, size, size * 3, size))
    else:
        print("disc", n(*centre, size))
        print("instance_referential 1 0 0 0 0 1")
