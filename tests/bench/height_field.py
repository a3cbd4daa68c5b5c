#!/usr/bin/env python3
"""height_field.py SIDE FILE [smooth]: a wavy surface of 2 SIDE^2 triangles as a .glb or .pmf file.

Coordinates and normals are what floats hold, and a .pmf file has nine digits of them.
"""
import array
import json
import math
import pathlib
import struct
import subprocess
import sys


class HeightField:
    """Vertices and their unit normals, three numbers each, and three vertices of each triangle."""

    def __init__(self, side):
        self.side = side
        self.vertices, self.normals, self.corners = array.array("f"), array.array("f"), array.array("I")
        points = side + 1
        steps = [2 * i / side - 1 for i in range(points)]
        columns = [(x, math.sin(9 * x), math.cos(9 * x), math.sin(61 * x), math.cos(61 * x)) for x in steps]
        for z in steps:
            sin7, cos7, sin53, cos53 = math.sin(7 * z), math.cos(7 * z), math.sin(53 * z), math.cos(53 * z)
            sin3, cos3 = math.sin(3 * z), math.cos(3 * z)
            for x, sin9, cos9, sin61, cos61 in columns:
                sine, cosine = sin61 * cos3 + cos61 * sin3, cos61 * cos3 - sin61 * sin3  # of 61 x + 3 z
                self.vertices.extend((x, 0.15 * sin9 * cos7 + 0.02 * sine * sin53, z))
                slope_x = 1.35 * cos9 * cos7 + 1.22 * cosine * sin53
                slope_z = -1.05 * sin9 * sin7 + 0.06 * cosine * sin53 + 1.06 * sine * cos53
                length = math.sqrt(slope_x * slope_x + 1 + slope_z * slope_z)
                self.normals.extend((-slope_x / length, 1 / length, -slope_z / length))
        for row in range(0, side * points, points):
            for a in range(row, row + side):
                self.corners.extend((a, a + points, a + 1, a + 1, a + points, a + points + 1))

    def write(self, file, smooth):
        """By the file's extension."""
        {".glb": self.write_glb, ".pmf": self.write_pmf}[pathlib.Path(file).suffix](file, smooth)

    def write_pmf(self, file, smooth):
        def lines(numbers, form):
            triples = iter(numbers)
            return (form % triple for triple in zip(triples, triples, triples))

        with open(file, "w") as out:
            out.write(f"{len(self.vertices) // 3} {len(self.corners) // 3}\n")
            out.writelines(lines(self.vertices, "%.9g %.9g %.9g\n"))
            out.writelines(lines(self.corners, "%d %d %d\n"))
            if smooth:
                out.write(f"normals {len(self.normals) // 3}\n")
                out.writelines(lines(self.normals, "%.9g %.9g %.9g\n"))
                out.write("face_normals\n")
                out.writelines(lines(self.corners, "%d %d %d\n"))

    def write_glb(self, file, smooth):
        parts = [self.vertices, self.normals, self.corners] if smooth else [self.vertices, self.corners]
        attributes = {"POSITION": 0, "NORMAL": 1} if smooth else {"POSITION": 0}
        views, accessors, offset = [], [], 0
        for part in parts:
            isCorners, size = part is self.corners, len(part) * part.itemsize
            views.append({"buffer": 0, "byteOffset": offset, "byteLength": size, "target": 34963 if isCorners else 34962})
            accessors.append({"bufferView": len(accessors), "componentType": 5125 if isCorners else 5126,
                              "count": len(part) if isCorners else len(part) // 3, "type": "SCALAR" if isCorners else "VEC3"})
            offset += size
        accessors[0] |= {"min": [min(self.vertices[i::3]) for i in range(3)],
                         "max": [max(self.vertices[i::3]) for i in range(3)]}
        document = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
                    "meshes": [{"primitives": [{"attributes": attributes, "indices": len(parts) - 1}]}],
                    "accessors": accessors, "bufferViews": views, "buffers": [{"byteLength": offset}]}
        text = json.dumps(document).encode()
        text += b" " * (-len(text) % 4)
        with open(file, "wb") as out:
            out.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + offset))
            out.write(struct.pack("<I4s", len(text), b"JSON") + text)
            out.write(struct.pack("<I4s", offset, b"BIN\0"))
            for part in parts:
                part.tofile(out)


def side_of(triangles):
    """Of the field that comes nearest to that many triangles; it has 2 side^2."""
    return max(1, round((triangles / 2) ** 0.5))


def make(file, side, smooth):
    """The file of a field, by a process of its own: a program takes its starter's peak of memory for its own."""
    subprocess.run([sys.executable, __file__, str(side), file, *(["smooth"] if smooth else [])], check=True)


def scene_of(mesh):
    """The text of a scene of a field's file, with one light."""
    return ("camera_position 0 1.6 2.2\nfocus_point 0 -0.1 0\ncamera_apertures 30 30\nlight_source 3 2 1 1\n"
            "material 0.05 0.05 0.05 0.8 0.6 0.3 0.3 0.3 0.3 40 0 0 0\n"
            f"mesh {mesh} 1 1 0 0 0 1 0 0 0 1 0 0 0\n")


if __name__ == "__main__":
    HeightField(int(sys.argv[1])).write(sys.argv[2], "smooth" in sys.argv[3:])
