#!/usr/bin/env python3
"""make_forms.py: writes forms.gltf, whose nodes show triangles in forms that few files have: a strip, a fan, quantised
positions, sparse ones (over zeros and over others), instances, and hierarchies that mirror and shear."""
import base64
import json
import math
import random
import struct

random.seed(1)
views, accessors, meshes, nodes, binary = [], [], [], [], b""
FORMATS = {5122: "h", 5121: "B", 5123: "H", 5126: "f"}


def view(values, component):
    global binary
    data = struct.pack(f"<{len(values)}{FORMATS[component]}", *values)
    views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(data)})
    binary += data + bytes(-len(data) % 4)
    return len(views) - 1


def accessor(rows, component, kind, **more):
    flat = [value for row in rows for value in row]
    accessors.append({"bufferView": view(flat, component), "componentType": component, "count": len(rows), "type": kind,
                      **more})
    return len(accessors) - 1


def positions(rows, component=5126, **more):
    rows = [struct.unpack("<3f", struct.pack("<3f", *row)) if component == 5126 else row for row in rows]
    limits = {"min": [min(axis) for axis in zip(*rows)], "max": [max(axis) for axis in zip(*rows)]}
    return accessor(rows, component, "VEC3", **limits, **more)


def node(position, mode=4, indices=None, **more):
    primitive = {"attributes": {"POSITION": position}, "mode": mode}
    if indices is not None:
        primitive["indices"] = accessor([[i] for i in indices], 5123, "SCALAR")
    meshes.append({"primitives": [primitive]})
    nodes.append({"mesh": len(meshes) - 1, **more})
    return len(nodes) - 1


zigzag = [(i / 2, i % 2, 0.3 * math.sin(i)) for i in range(9)]
fan = [(0, 0, 0.5)] + [(math.cos(i), math.sin(i), 0) for i in range(6)]
cloud = [[random.uniform(-1, 1) for _ in range(3)] for _ in range(12)]

roots = [
    node(positions(zigzag), 5, name="strip"),
    node(positions(zigzag), 5, [8, 6, 7, 5, 3, 4, 1], name="indexed strip", translation=[0, 2, 0]),
    node(positions(fan), 6, name="fan", translation=[-3, 0, 0]),
    node(positions(fan), 6, [0, 2, 4, 6, 1], name="indexed fan", translation=[-3, 3, 0], scale=[1, 2, 3]),
]
whole = [[random.randrange(-32767, 32768) for _ in range(3)] for _ in range(9)]
# Of four times two bytes, so that every element begins at a multiple of four.
accessors.append({"bufferView": view([c for row in whole for c in (*row, 0)], 5122), "componentType": 5122, "count": 9,
                  "type": "VEC3", "normalized": True, "min": [min(a) for a in zip(*whole)],
                  "max": [max(a) for a in zip(*whole)]})
views[-1].update(byteStride=8, target=34962)
roots.append(node(len(accessors) - 1, name="quantised", translation=[5, 5, 5], scale=[3, 3, 3]))

moved = [[random.uniform(-2, 2) for _ in range(3)] for _ in range(4)]
moved = [struct.unpack("<3f", struct.pack("<3f", *row)) for row in moved]
for base in (None, cloud):
    rows = [struct.unpack("<3f", struct.pack("<3f", *row)) for row in base or [(0, 0, 0)] * 12]
    if base:
        id = positions(base)
    else:
        accessors.append({"componentType": 5126, "count": 12, "type": "VEC3"})
        id = len(accessors) - 1
    where = [1, 4, 5, 10]
    for index, row in zip(where, moved):
        rows[index] = row
    accessors[id].update(
        min=[min(a) for a in zip(*rows)], max=[max(a) for a in zip(*rows)],
        sparse={"count": 4, "indices": {"bufferView": view(where, 5121), "componentType": 5121},
                "values": {"bufferView": view([c for row in moved for c in row], 5126)}})
    roots.append(node(id, name="sparse over " + ("others" if base else "zeros"), translation=[0, -5, 2 if base else 0]))

places = {"TRANSLATION": accessor([(3 * i, -8, i) for i in range(4)], 5126, "VEC3"),
          "ROTATION": accessor([(math.sin(i / 2), 0, 0, math.cos(i / 2)) for i in range(4)], 5126, "VEC4"),
          "SCALE": accessor([(1, 1 + i / 2, 1) for i in range(4)], 5126, "VEC3")}
roots.append(node(positions(cloud), name="instances", rotation=[0, 0, math.sin(0.2), math.cos(0.2)],
                  extensions={"EXT_mesh_gpu_instancing": {"attributes": places}}))

# A rotation below an uneven scale shears.
child = node(positions(cloud), name="sheared", rotation=[0, math.sin(0.4), 0, math.cos(0.4)], scale=[1, -1, 1])
nodes.append({"name": "uneven", "children": [child], "scale": [2, 1, 0.5], "translation": [0, 0, -6]})
roots.append(len(nodes) - 1)
child = node(positions(fan), 6, name="mirrored", scale=[-1, 1, 1])
nodes.append({"name": "by a matrix", "children": [child], "matrix": [0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, -6, -6, 0, 1]})
roots.append(len(nodes) - 1)

document = {"asset": {"version": "2.0"}, "extensionsUsed": ["EXT_mesh_gpu_instancing", "KHR_mesh_quantization"],
            "extensionsRequired": ["KHR_mesh_quantization"], "scene": 0, "scenes": [{"nodes": roots}], "nodes": nodes,
            "meshes": meshes, "accessors": accessors, "bufferViews": views,
            "buffers": [{"byteLength": len(binary),
                         "uri": "data:application/octet-stream;base64," + base64.b64encode(binary).decode()}]}
with open("forms.gltf", "w") as out:
    json.dump(document, out, indent=1)
    out.write("\n")
