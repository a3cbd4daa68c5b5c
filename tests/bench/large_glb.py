#!/usr/bin/env python3
"""large_glb.py SIDE FILE: a .glb of one wavy grid of SIDE x SIDE squares, with normals and 32-bit indices."""
import array
import json
import math
import struct
import sys

side, file = int(sys.argv[1]), sys.argv[2]
points = side + 1
positions, normals, indices = array.array("f"), array.array("f"), array.array("I")
wave = [math.sin(12 * i / side) for i in range(points)]
slope = [12 * math.cos(12 * i / side) for i in range(points)]
for j in range(points):
    for i in range(points):
        x, y = -0.05 * slope[i] * wave[j], -0.05 * wave[i] * slope[j]
        length = math.sqrt(x * x + y * y + 1)
        positions.extend((i / side, j / side, 0.05 * wave[i] * wave[j]))
        normals.extend((x / length, y / length, 1 / length))
for j in range(side):
    for i in range(side):
        a = j * points + i
        indices.extend((a, a + 1, a + points, a + 1, a + points + 1, a + points))

views, binary = [], b""
for data, target in ((positions, 34962), (normals, 34962), (indices, 34963)):
    views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": 4 * len(data), "target": target})
    binary += data.tobytes()
document = {
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2}]}],
    "accessors": [
        {"bufferView": 0, "componentType": 5126, "count": points * points, "type": "VEC3",
         "min": [0, 0, min(positions[2::3])], "max": [1, 1, max(positions[2::3])]},
        {"bufferView": 1, "componentType": 5126, "count": points * points, "type": "VEC3"},
        {"bufferView": 2, "componentType": 5125, "count": len(indices), "type": "SCALAR"}],
    "bufferViews": views, "buffers": [{"byteLength": len(binary)}]}
text = json.dumps(document).encode()
text += b" " * (-len(text) % 4)
with open(file, "wb") as out:
    out.write(struct.pack("<4sII", b"glTF", 2, 28 + len(text) + len(binary)))
    out.write(struct.pack("<I4s", len(text), b"JSON") + text)
    out.write(struct.pack("<I4s", len(binary), b"BIN\0") + binary)
