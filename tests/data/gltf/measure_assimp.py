#!/usr/bin/env python3
"""measure_assimp.py FILE...: what assimp makes of each file, in the world: triangles, bounding box, area."""
import math
import pathlib
import subprocess
import sys
import tempfile


def triangles(file, folder):
    """From its export as ASCII STL, with all transforms applied."""
    stl = pathlib.Path(folder) / "out.stl"
    subprocess.run(["assimp", "export", file, stl, "-ptv", "-tri"], check=True, capture_output=True)
    facets = stl.read_text().split("endfacet")[:-1]
    faces = [[tuple(map(float, v.split()[:3])) for v in facet.split("vertex")[1:]] for facet in facets]
    return [face for face in faces if len(face) == 3]  # points and lines are there too


def area(a, b, c):
    u, v = [[q - p for p, q in zip(a, other)] for other in (b, c)]
    return math.hypot(*(u[i - 2] * v[i - 1] - u[i - 1] * v[i - 2] for i in range(3))) / 2


for file in sys.argv[1:]:
    with tempfile.TemporaryDirectory() as folder:
        try:
            faces = triangles(file, folder)
        except subprocess.CalledProcessError:
            print(file, "not read", sep="\t")
            continue
    axes = list(zip(*(corner for face in faces for corner in face)))
    print(file, len(faces), *map(min, axes), *map(max, axes), math.fsum(area(*face) for face in faces), sep="\t")
