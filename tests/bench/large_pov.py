#!/usr/bin/env python3
"""large_pov.py KIND SIDE FILE: a POV-Ray scene of one wavy grid of SIDE x SIDE squares, two triangles each.

KIND: mesh2, mesh2-smooth (with normals), mesh (of `triangle`s), mesh-smooth (of `smooth_triangle`s).
"""
import math
import sys

kind, side, file = sys.argv[1], int(sys.argv[2]), sys.argv[3]
points = side + 1
wave = [math.sin(12 * i / side) for i in range(points)]
slope = [12 * math.cos(12 * i / side) for i in range(points)]
grid = [(i, j) for j in range(points) for i in range(points)]
vertices = [f"<{i / side:.9g},{0.05 * wave[i] * wave[j]:.9g},{j / side:.9g}>" for i, j in grid]
normals = [f"<{-0.05 * slope[i] * wave[j]:.9g},1,{-0.05 * wave[i] * slope[j]:.9g}>" for i, j in grid]
corners = [(a, a + 1, a + points, a + 1, a + points + 1, a + points)
           for j in range(side) for a in range(j * points, j * points + side)]
faces = [face for c in corners for face in (c[:3], c[3:])]

with open(file, "w") as out:
    out.write("#version 3.7;\nglobal_settings{assumed_gamma 1}\n"
              "camera{location <0.5,1,-1> look_at <0.5,0,0.5>}\nlight_source{<5,9,-5> rgb 1}\n")

    def write_list(name, rows):
        out.write(f"{name}{{{len(rows)},\n" + ",\n".join(rows) + "}\n")

    if kind.startswith("mesh2"):
        out.write("mesh2{\n")
        write_list("vertex_vectors", vertices)
        if kind == "mesh2-smooth":
            write_list("normal_vectors", normals)
        write_list("face_indices", ["<%d,%d,%d>" % face for face in faces])
    elif kind == "mesh":
        out.write("mesh{\n")
        out.writelines(f"triangle{{{','.join(vertices[v] for v in face)}}}\n" for face in faces)
    elif kind == "mesh-smooth":
        out.write("mesh{\n")
        out.writelines(f"smooth_triangle{{{','.join(f'{vertices[v]},{normals[v]}' for v in face)}}}\n" for face in faces)
    else:
        sys.exit(__doc__)
    out.write("pigment{rgb <.8,.6,.3>}}\n")
