#!/usr/bin/env python3
"""Writes the files of hard rays, without labels: hard-label adds them. The same files for the same seeds."""
import math
import pathlib
import random

HERE = pathlib.Path(__file__).resolve().parent


class Family:
    def __init__(self, name, about):
        self.name, self.lines = name, [f"; {about}"]

    def scene(self, name, *bodies):
        self.lines += ["", f"scene {name}", *bodies]

    def ray(self, origin, direction):
        """direction is made a unit vector, in doubles."""
        n = math.sqrt(sum(c * c for c in direction))
        d = direction if n == 1 else [c / n for c in direction]
        self.lines.append("ray " + " ".join(float(c).hex() for c in [*origin, *d]))

    def towards(self, origin, target):
        self.ray(origin, [t - o for o, t in zip(origin, target)])

    def write(self):
        (HERE / f"{self.name}.rays").write_text("\n".join(self.lines) + "\n")


def steps(x, n):
    """x moved by n doubles."""
    for _ in range(abs(n)):
        x = math.nextafter(x, math.copysign(math.inf, n))
    return x


def spheres():
    f = Family("spheres", "Tangent and nearly tangent rays, sizes and distances, starts on the surface.")
    f.scene("unit tangent", "sphere 0 0 0 1")
    for n in (-64, -8, -4, -3, 3, 4, 8, 64):
        f.ray((0, steps(1, n), 10), (0, 0, -1))
        f.ray((steps(-1, n), 0, 10), (0, 0, -1))
    f.scene("unit, slanted tangent", "sphere 0 0 0 1")
    for e in (1e-4, 1e-8, 1e-12, 1e-14):
        for side in (-1, 1):
            y = 1 + side * e
            f.towards((-6 - 0.8 * y, -8 + 0.6 * y, 1e-3), (6 * 0 - 0.8 * y, 0.6 * y, 0))
    for exponent in (-6, -3, 0, 3, 6):
        r = 10.0 ** exponent
        f.scene(f"radius 1e{exponent}", f"sphere 0 0 0 {r!r}")
        for distance in (1, 1e4, 1e8):
            f.ray((0.6 * r, 0, distance + r), (0, 0, -1))
            f.ray((0, math.nextafter(r, math.inf) * (1 + 2**-51), distance + r), (0, 0, -1))
            f.towards((0.3 * distance, 0.2 * distance, distance + r), (0.1 * r, 0.2 * r, 0.3 * r))
    f.scene("starts", "sphere 1 2 3 0.5")
    for n in (-3, -2, 2, 3, 1000):
        for z in (3.5, 2.5):
            start = steps(z, n if z > 3 else -n)
            f.ray((1, 2, start), (0, 0, 1))
            f.ray((1, 2, start), (0, 0, -1))
            f.ray((1, 2, start), (0.6, 0, 0.8))
    f.write()


def cones():
    f = Family("cones", "Apex, generators, nearly cylinders, needles, pancakes, rims, axis-parallel rays.")
    f.scene("apex", "cone 0 0 0 1 2")
    for e in (1e-3, 1e-8, 1e-13, 1e-15):
        for side in (-1, 1):
            f.ray((-5, 2 + side * e, 0), (1, 0, 0))
            f.ray((e, 9, side * e), (0, -1, 0))
            f.towards((-5, 1, 3), (0, 2 + side * e, 0))
    f.scene("parallel to a generator", "cone 0 0 0 1 1")
    for x in (-1.5, -0.5, 0.25, 0.75):
        f.ray((x, 3, 0.125), (1, -1, 0))
        f.ray((x, 3, 0.125), (1, -1, 1e-9))
    f.scene("parallel to a generator of another slope", "cone 1 2 3 3 4")
    for x in (0.5, -1.0, -2.0):
        f.ray((x, 5, 3.25), (0.6, -0.8, 0))
        f.ray((x, 5, 3.25), (-0.6, -0.8, 0))
    f.scene("nearly a cylinder", "truncated_cone 0 0 0 1 1e9 1", "truncated_cone 0 0 5 1 1e15 2")
    for y in (0.25, 0.75):
        for z in (0.5, 0.999999999, 1.000000001):
            f.ray((-5, y, z), (1, 0, 0))
            f.ray((-5, y, 5 + z), (1, 0, 0))
    f.ray((0.5, 5, 0), (0, -1, 0))
    f.ray((0.5, 5, 5), (1e-4, -1, 0))
    f.scene("needle", "cone 0 0 0 1e-6 1", "cone 3 0 0 1e-3 1000")
    for y in (0.1, 0.9, 0.999999):
        f.ray((-2, y, 1e-8), (1, 0, 0))
        f.ray((9, y * 1000, 1e-5), (-1, 0, 0))
    f.scene("pancake", "cone 0 0 0 1 1e-9", "cone 0 3 0 1000 1e-3")
    for x in (0.5, -0.75):
        f.ray((x, 2, 0.1), (0, -1, 0))
        f.ray((x, -2, 0.1), (0, 1, 0))
        f.ray((-2, 5e-10, x), (1, 0, 0))
        f.ray((-2000, 3.0005, x), (1, 0, 0))
    f.scene("rim", "cone 0 0 0 1 1")
    for n in (-8, -4, 4, 8):
        f.ray((steps(1, n), 5, 0), (0, -1, 0))
        f.ray((0, -5, steps(-1, n)), (0, 1, 0))
    for e in (1e-3, 1e-15):
        for side in (-1, 1):
            f.ray((-5, side * e, 0), (1, 0, 0))
            f.ray((1 + side * e, 0, -3), (0, 0, 1))
    f.scene("turned", "cone 1 1 1 0.5 2", "instance_referential 1 2 2 -2 2 -1")
    for e in (1e-6, 1e-13):
        for side in (-1, 1):
            apex = [1 + 2 * c / 3 + side * e for c in (-2, 2, -1)]
            f.towards((4, -3, 7), apex)
            f.towards((1e4, -3e3, 7e3), apex)
    f.write()


def cylinders():
    f = Family("cylinders", "Walls, rims, lids, axes; wires seen from afar; frusta that are nearly cylinders.")
    f.scene("wall and lids", "cylinder 0 0 0 1 2")
    for n in (-8, -4, 4, 8):
        f.ray((steps(1, n), 5, 0), (0, -1, 0))
        f.ray((-5, 1, steps(-1, n)), (1, 0, 0))
        f.ray((-5, steps(2, n), 0.5), (1, 0, 0))
    for lean in (0, 1e-300, 1e-17, 1e-9):
        f.ray((0.5, 9, 0), (lean, -1, 0))
        f.ray((1.5, 9, 0), (lean, -1, 0))
    f.scene("wire", "cylinder 0 -50 0 1e-3 100", "open_cylinder 1 -50 0 1e-6 100")
    for z in (6e-4, 9.999999e-4, 1.000001e-3):
        f.ray((1e6, 0, z), (-1, 0, 0))
        f.ray((-1e6, 0.3, z * 1e-3), (1, 0, 0))
    f.scene("tube", "open_cylinder 0 0 0 2 4")
    for x in (0.5, 1.9999999, 2.0000001):
        f.ray((x, 9, 0), (0, -1, 0))
        f.towards((x, 9, 0), (x + 0.25, 0, 0))
    for e in (1e-10, 1e-15):
        for side in (-1, 1):
            f.ray((-9, 4 + 4 * side * e, 0), (1, 0, 0))
            f.ray((-9, side * e, 0), (1, 0, 0))
    for top in ("1.000000001", "0.9999999999999998", "1e-12", "1000"):
        f.scene(f"frustum to {top}", f"frustum 0 0 0 1 {top} 1")
        for y in (0.25, 0.75):
            f.ray((-3000, y, 0.25), (1, 0, 0))
            f.towards((-3, y, 0.25), (1e-3, y / 2, 1e-3))
    f.scene("turned", "cylinder 0.1 0.2 0.3 0.7 3", "instance_referential 0.6 0.8 0 -0.8 0.6 0")
    for e in (1e-9, 1e-14):
        for side in (-1, 1):
            f.towards((0.1, 0.2, 9), (0.1 + (0.8 * 0) + 0.6 * 0.7 * (1 + side * e), 0.2 + 0.8 * 0.7 * (1 + side * e), 0.3))
    f.write()


def boxes():
    f = Family("boxes", "Thin ones; rays in a face's plane, along an edge, through a corner; zeros of either sign.")
    f.scene("unit", "box 0 0 0 2 2 2")
    for n in (-8, -4, 4, 8):
        f.ray((steps(1, n), 5, 0.5), (0.0, -1, -0.0))
        f.ray((steps(1, n), 5, steps(1, n)), (-0.0, -1, 0.0))
    for e in (1e-3, 1e-9, 1e-14):
        for side in (-1, 1):
            f.towards((4, 4, 0.5), (1 + side * e, 1 + side * e, 0.5 - side * e))
            f.towards((-5, -3, 7), (1 + side * e, -1 - side * e, 1 + side * e))
            f.towards((0, 3 + side * e, 0), (2 + side * e, 1, 0))
    f.scene("thin", "box 0 0 0 1 1e-12 1", "box 5 0 0 1000 1000 1e-9")
    for x in (0.25, -0.49):
        f.ray((x, 2, 0.1), (0, -1, 0))
        f.ray((-2, 1e-13 * x, 0.1), (1, 0, 0))
        f.ray((-2, 1e-12, 0.1 * x), (1, 0, 0))
        f.towards((-2, 1e-3, 0.1), (x, 0, 0))
    f.scene("turned", "box 1 2 3 1 2 3", "instance_referential 2 1 2 -2 2 1")
    for e in (1e-6, 1e-13):
        for side in (-1, 1):
            corner = [c + (1 + side * e) * (0.5 * x + 1 * y + 1.5 * z) / 3
                      for c, x, y, z in zip((1, 2, 3), (2, 1, 2), (-2, 2, 1), (-1, -2, 2))]
            f.towards((9, -8, 7), corner)
            f.towards((9e5, -8e5, 7e5), corner)
    f.scene("starts", "box 0 0 0 2 2 2")
    for n in (-3, 3):
        f.ray((0.5, steps(1, n), 0.25), (0, 1, 0))
        f.ray((0.5, steps(1, n), 0.25), (0.6, -0.8, 0))
        f.ray((0.5, steps(-1, n), 0.25), (0.6, -0.8, 0))
    f.write()


def faces():
    f = Family("faces", "Slivers, concave outlines, collinear vertices, edges and vertices shared, planes edge-on.")
    f.scene("sliver of half a degree", "polygon 3 0 0 0 10 0 0 10 0.0872 0")
    for x in (0.01, 1, 9.9):
        for part in (1e-9, 0.5, 0.999999999, 1.000000001):
            f.towards((3, 1, 7), (x, x * 0.00872 * part, 0))
    f.scene("needle far from the origin", "polygon 3 1000 1000 1000 1010 1000 1000 1000.0001 1000.0001 1000.0001")
    for part in (0.1, 0.5, 0.9):
        f.towards((1003, 1020, 1013), (1000 + 10 * part * 0.5 , 1000 + 0.00003, 1000 + 0.00003))
    f.scene("concave", "polygon 6 0 0 0 2 0 0 2 1 0 1 1 0 1 2 0 0 2 0")
    for e in (1e-9, 1e-14):
        for side in (-1, 1):
            f.ray((1 + side * e, 1 + side * e, 3), (0, 0, -1))
            f.ray((1 + side * e, 1.5, 3), (0, 0, -1))
            f.towards((0.3, 0.2, -5), (1.5, 1 + side * e, 0))
    f.scene("collinear vertices", "polygon 7 0 0 0 1 0 0 2 0 0 2 1 0 2 2 0 1 2 0 0 2 0")
    for e in (1e-9, 1e-14):
        for side in (-1, 1):
            f.towards((0.3, 0.2, -5), (1, side * e, 0))
            f.towards((0.3, 0.2, 5), (2 + side * e, 1, 0))
    f.scene("a fan", *[f"polygon 3 0 0 0 {a} 0 {b} 0" for a, b in
                       (("1 0", "0.5 1"), ("0.5 1", "-0.5 1"), ("-0.5 1", "-1 0"), ("-1 0", "-0.5 -1"))])
    generator = random.Random(1)
    for _ in range(24):
        angle, r = generator.uniform(0.1, 4), generator.uniform(1e-15, 0.5)
        f.towards((generator.uniform(-2, 2), generator.uniform(-2, 2), 3), (r * math.cos(angle), r * math.sin(angle), 0))
    f.scene("nearly edge-on", "polygon 4 -1 0 -1 -1 0 1 1 0 1 1 0 -1")
    for fall in (1e-3, 1e-8, 1e-15):
        for side in (-1, 1):
            f.ray((-5, side * fall * 5.5, 0.1), (1, -side * fall, 0))
            f.ray((-5, side * fall * 5.5, 0.1), (1, side * fall, 0))
    f.scene("starts", "polygon 3 1 1 1 4 1 1 1 1 5")
    for n in (-4, 4):
        f.ray((2, steps(1, n), 2), (0, 1, 0))
        f.ray((2, steps(1, n), 2), (0, -1, 0))
    f.scene("far hits of a robust intersector", "polygon 3 12290 -1 -1 12290 1 -1 12290 0 1")
    f.ray((-1, 0.25, 0.25), (1, 0, 0))
    f.ray((-1, 0.75, 0.75), (1, 0, 0))
    f.write()


def flats():
    f = Family("flats", "Discs and planes: rims, nearly parallel rays, starts on either side, far away.")
    f.scene("disc", "disc 0 0 0 1")
    for n in (-8, -4, 4, 8):
        f.ray((steps(1, n), 5, 0), (0, -1, 0))
        f.ray((0, -5, steps(-1, n)), (0, 1, 0))
    for fall in (1e-3, 1e-9, 1e-15):
        f.ray((-5, 5.5 * fall, 0), (1, -fall, 0))
        f.ray((-5, 5.5 * fall, 0), (1, fall, 0))
        f.ray((-5, 3 * fall, 0), (1, -fall, 0))
    f.scene("plane", "plane 0 1 0 -1")
    for fall in (1e-3, 1e-9, 1e-15, 1e-300):
        f.ray((0, 1, 0), (1, -fall, 0))
        f.ray((0, 1, 0), (1, fall, 0))
    for n in (-4, 4):
        f.ray((7, steps(-1, n), 0), (0, -1, 0))
        f.ray((7, steps(-1, n), 0), (0, 1, 0))
    f.scene("slanted plane", "plane 1 2 3 4")
    for distance in (1, 1e4, 1e8):
        f.towards((distance, distance, distance), (1, 1, 1 / 3))
    f.write()


def neighbours():
    f = Family("neighbours", "Which of two close surfaces is first: gaps down to 1e-12, coplanar faces, touching bodies.")
    for exponent in (0, -4, -8, -12):
        gap = 10.0 ** exponent
        f.scene(f"gap 1e{exponent}", "polygon 3 -1 -1 0 1 -1 0 0 1 0", f"polygon 3 -1 -1 {gap!r} 1 -1 {gap!r} 0 1 {gap!r}")
        f.ray((0.1, 0.1, 5), (0, 0, -1))
        f.ray((0.1, 0.1, -5), (0, 0, 1))
        f.towards((3, 2, 4), (0.1, 0.1, 0))
    f.scene("tie: coplanar, the polygon first", "polygon 4 -1 -1 1 1 -1 1 1 1 1 -1 1 1", "box 0 0 0 2 2 2")
    f.ray((0.5, 0.25, 5), (0, 0, -1))
    f.scene("tie: coplanar, the box first", "box 0 0 0 2 2 2", "polygon 4 -1 -1 1 1 -1 1 1 1 1 -1 1 1")
    f.ray((0.5, 0.25, 5), (0, 0, -1))
    f.scene("tie: twice the same", "sphere 0 0 0 1", "sphere 0 0 0 1")
    f.ray((0.5, 0.25, 5), (0, 0, -1))
    f.scene("a box hardly above a plane", "plane 0 1 0 -1.0000007", "box 0 0 0 2 2 2")
    for x in (-0.5, 0, 0.999):
        f.ray((x, -5, 0.3), (0, 1, 0))
        f.towards((x, -1.0000003, 0.3), (x + 1, -1.0000003, 0.4))
        f.towards((x, -1.0000003, 0.3), (x + 1, -1.5, 0.4))
    f.scene("a box on a plane", "plane 0 1 0 -1", "box 0 0 0 2 2 2")
    f.towards((5, 0.5, 0.1), (0.5, -0.75, 0.1))
    f.towards((5, 0.5, 0.1), (1.5, -1, 0.1))
    f.write()


def elsewhere():
    f = Family("elsewhere", "Far from the origin, tiny, huge, with axes that are written carelessly.")
    for shift in (1e3, 1e6, 1e9):
        f.scene(f"moved by {shift:g}", f"sphere {shift!r} {shift!r} 0 1", f"cone {shift + 3!r} {shift!r} 0 1 2",
                f"box {shift + 6!r} {shift!r} 0 1 1 1")
        for x in (0.25, 3.25, 6.25, 0.999):
            f.ray((shift + x, shift + 0.25, 9), (0, 0, -1))
            f.towards((shift, shift + 9, 9), (shift + x, shift + 0.25, 0))
    for k in (-40, 40):
        s = 2.0 ** k
        f.scene(f"scaled by 2^{k}", f"sphere 0 0 0 {s!r}", f"frustum {3 * s!r} 0 0 {s!r} {s / 2!r} {s!r}",
                f"disc {-3 * s!r} 0 0 {s!r}")
        for x in (0.25, 3.25, -2.75):
            f.ray((x * s, 9 * s, s / 4), (0, -1, 0))
            f.towards((9 * s, 9 * s, s / 4), (x * s, s / 8, 0))
    for name, axes in (("0.707", "0.707 0.707 0 -0.707 0.707 0"), ("leaning", "1 1e-4 0 0 1 0"), ("long", "1e150 0 0 0 0 1e-150"),
                       ("mirrored twice", "-1 0 0 0 -1 0")):
        f.scene(f"axes {name}", "box 0 0 0 2 1 3", f"instance_referential {axes}")
        for target in ((1.0, 0.1, 0.2), (0.4, 0.4, -0.7)):
            f.towards((5, 4, 3), target)
            f.towards((-50, 4, 30), target)
    f.write()


for family in (spheres, cones, cylinders, boxes, faces, flats, neighbours, elsewhere):
    family()
