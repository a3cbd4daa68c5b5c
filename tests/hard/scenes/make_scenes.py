#!/usr/bin/env python3
"""Writes the labelled scenes: small pictures whose pixels have closed forms, worked out here in 50 digits."""
import math
import pathlib
from decimal import Decimal as D, getcontext

getcontext().prec = 50
HERE = pathlib.Path(__file__).resolve().parent
NO_CODE = "0 0 0 1 0 0 0"  # specular colour, exponent, cr, ct, ior of what neither shines, mirrors nor transmits


def text(x):
    """The nearest double to x, as short as it can be."""
    return repr(float(x)) if isinstance(x, D) else str(x)


def row(*numbers):
    return " ".join(text(x) for x in numbers)


class Picture:
    """A scene and what is true of it."""

    def __init__(self, name, why, camera=(0, 0, 5), focus=(0, 0, 0), size=1, levels=None, background=None, aperture=None):
        self.name, self.lines = name, [f"; {line}" for line in why.split("\n")]
        self.settings = [f"image_resolution {size} {size}", f"camera_position {row(*camera)}", f"focus_point {row(*focus)}"]
        if levels is not None:
            self.settings.append(f"max_recurse_level {levels}")
        if background is not None:
            self.settings.append(f"background_colour {row(*background)}")
        if aperture is not None:
            self.settings.append(f"camera_apertures {aperture} {aperture}")
        self.bodies, self.truths = [], []

    def body(self, *lines):
        self.bodies += lines
        return self

    def glow(self, r, g, b, *lines):
        """Bodies of that ambient colour and nothing else."""
        return self.body(f"material {row(r, g, b)} 0 0 0 {NO_CODE}", *lines)

    def matt(self, *lines):
        return self.body(f"material 0 0 0 1 1 1 {NO_CODE}", *lines)

    def glass(self, ct, ior, *lines):
        return self.body(f"material 0 0 0 0 0 0 0 0 0 1 0 {row(ct, ior)}", *lines)

    def mirror(self, glow, cr, *lines):
        return self.body(f"material {row(glow, glow, glow)} 0 0 0 0 0 0 1 {row(cr)} 0 0", *lines)

    def light(self, *numbers):
        return self.body("light_source " + row(*numbers))

    def pixel(self, x, y, r, g, b, within=1e-14):
        self.truths.append(f";= pixel {x} {y} {row(r, g, b)} within {within!r}")
        return self

    def all(self, r, g, b, within=0):
        self.truths.append(f";= all {row(r, g, b)} within {within!r}")
        return self

    def none(self, r, g, b):
        self.truths.append(f";= none {row(r, g, b)}")
        return self

    def error(self, code):
        self.truths.append(f";= error {code}")
        return self

    def write(self):
        (HERE / f"{self.name}.yarte").write_text("\n".join(self.lines + self.truths + self.settings + self.bodies) + "\n")


def view(i, n):
    """Where pixel i of n looks in a view of 45 degrees, from -1 to 1."""
    return D(2 * i + 1) / n - 1


def starts():
    """What is met by rays that start on a surface."""
    shapes = {
        "sphere": ["sphere 0 0 0 1"],
        "box": ["box 0 0 0 2 1 1", "instance_referential 1 2 2 -2 2 -1"],
        "cone": ["cone 0 -1 0 1 2"],
        "truncated_cone": ["truncated_cone 0 -1 0 1 4 2", "instance_referential 1 0 0 0 3 1"],
        "cylinder": ["cylinder 0 -1 0 1 2", "instance_referential 1 0 0 0 1 2"],
        "frustum": ["frustum 0 -1 0 1 0.5 2"],
        "disc": ["disc 0 0 0 2", "instance_referential 1 0 0 0 1 40"],
        "polygon": ["polygon 5 -2 0 0 0 -1 0.02 2 0 0 1 1 -0.02 -1 1 -0.02"],
        "plane": ["plane 0 1 0 -1"],
        "mesh": ["mesh icosahedron.pmf 1 1 0 0 0 1 0 0 0 1 0 0 0"],
    }
    for name, lines in shapes.items():
        Picture(f"lit-{name}", "The light stands in the eye: all that is seen is lit, at N.L > 0, however it grazes. No pixel\nis black.",
                camera=(0.3, 0.2, 3), size=64, background=(1, 0, 1), aperture=30).light(0.3, 0.2, 3, 1).matt(*lines).none(0, 0, 0).write()
    total = lambda cr, levels: sum(D(cr) ** k for k in range(levels + 1))
    rooms = {
        "sphere": (["sphere 0 0 0 1"], (0.3, 0.2, 0.1)),
        "sphere-at-its-wall": (["sphere 0 0 0 1"], (1 - 1e-9, 0, 0)),
        "box": (["box 0 0 0 2 3 4"], (0.3, 0.2, 0.1)),
        "box-of-slivers": (["box 0 0 0 2 1e-6 2"], (0.3, 1e-7, 0.1)),
        "cone": (["cone 0 0 0 2 2"], (0.3, 0.2, 0.1)),
        "cylinder": (["cylinder 0 -1 0 1 2"], (0.3, 0.2, 0.1)),
        "frustum": (["frustum 0 -1 0 1 0.25 2"], (0.3, 0.2, 0.1)),
        "mesh": (["mesh icosahedron.pmf 1 1 0 0 0 1 0 0 0 1 0 0 0"], (0.03, 0.02, 0.01)),
        "mesh-elsewhere": (["mesh icosahedron.pmf 0.7 1 2 2 -2 2 -1 0 0 0 1000 2000 -3000"], (1000.03, 2000.02, -3000.01)),
    }
    for name, (lines, eye) in rooms.items():
        levels, cr = 50, D("0.5")
        focus = tuple(e + s for e, s in zip(eye, (-0.5, 0.25, 0.125)))
        Picture(f"mirrors-{name}", f"A closed mirror around the eye: every ray of all {levels + 1} generations meets it, and adds its 1 times cr^k.",
                camera=eye, focus=focus, size=16, levels=levels, background=(1000, 1000, 1000), aperture=60) \
            .mirror(1, cr, *lines).all(*[total(cr, levels)] * 3).write()
    Picture("mirrors-corridor", "Two mirrors face each other, 255 generations between them, all of weight 1: 256 times 0.5.",
            camera=(0, 0, 0), focus=(1, 0, 0.25), size=4, levels=255, background=(1000, 0, 0), aperture=1) \
        .mirror(D("0.5"), 1, "plane 1 0 0 -1", "plane -1 0 0 -1").all(128, 128, 128).write()
    for height in ("1", "1e-6", "1e-12"):
        Picture(f"light-{height}-above", "The light stands above the point that is seen, N.L = 1, however low.",
                camera=(3, 4, 0)).light(0, height, 0, 1).matt("plane 0 1 0 0").pixel(0, 0, 1, 1, 1).write()
    for height in (D("1e-3"), D("1e-9")):
        cosine = height / (height * height + 1).sqrt()
        Picture(f"light-{float(height)}-beside", "A light just above the surface, at a distance of 1: N.L = h / sqrt(1 + h^2).",
                camera=(3, 4, 0)).light(0, height, 1, 1).matt("plane 0 1 0 0") \
            .pixel(0, 0, cosine, cosine, cosine, float(cosine) * 1e-7 if height < D("1e-6") else 1e-14).write()
    Picture("light-on-the-surface", "A light in the plane, N.L = 0 everywhere: only the ambient colour.",
            camera=(3, 4, 0), size=8).light(0, 0, 1, 1).body(f"material 0.25 0.25 0.25 1 1 1 {NO_CODE}", "plane 0 1 0 0") \
        .all(0.25, 0.25, 0.25).write()
    Picture("light-in-the-point", "A light in the very point that is seen has no direction: only the ambient colour.",
            camera=(0, 4, 0)).body("up_vector 0 0 1").light(0, 0, 0, 1) \
        .body(f"material 0.25 0.25 0.25 1 1 1 {NO_CODE}", "plane 0 1 0 0").pixel(0, 0, 0.25, 0.25, 0.25, 0).write()
    Picture("light-below", "A light a hair below the plane lights nothing of its upper side.",
            camera=(3, 4, 0), size=8).light(0, "-1e-300", 1, 1).body(f"material 0.25 0.25 0.25 1 1 1 {NO_CODE}", "plane 0 1 0 0") \
        .all(0.25, 0.25, 0.25).write()
    Picture("light-inside", "An opaque sphere around the light: nothing outside is lit, its shadow leaks nowhere.",
            camera=(3, 4, 0), size=32).light(0, 2, 0, 1).body(f"material 0.25 0.25 0.25 1 1 1 {NO_CODE}", "sphere 0 2 0 1", "plane 0 1 0 0") \
        .all(0.25, 0.25, 0.25).write()


def meshes():
    """Closed and shared: edges and vertices."""
    cube = HERE / "cube.pmf"
    corners = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    faces = [(0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1), (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3)]
    cube.write_text("; a cube of triangles\n8 12\n" + "".join(row(*c) + "\n" for c in corners) + "".join(row(*f) + "\n" for f in faces))
    f = (1 + D(5).sqrt()) / 2
    one, golden = 1 / (1 + f * f).sqrt(), f / (1 + f * f).sqrt()
    points = [p for a in (-one, one) for b in (-golden, golden) for p in ((0, a, b), (a, b, 0), (b, 0, a))]
    near = lambda p, q: sum((a - b) ** 2 for a, b in zip(p, q)) < (2 * one) ** 2 * D("1.01")
    triangles = [(i, j, k) for i in range(12) for j in range(i + 1, 12) for k in range(j + 1, 12)
                 if near(points[i], points[j]) and near(points[j], points[k]) and near(points[k], points[i])]

    def outward(t):
        a, b, c = (points[i] for i in t)
        u, v = [y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, c)]
        n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        return t if sum(x * y for x, y in zip(n, a)) > 0 else (t[0], t[2], t[1])
    (HERE / "icosahedron.pmf").write_text("; an icosahedron\n12 20\n" + "".join(row(*p) + "\n" for p in points)
                                          + "".join(row(*outward(t)) + "\n" for t in triangles))
    axes = {"": "1 0 0 0 1 0 0 0 1", "-turned": "1 2 2 -2 2 -1 0 0 0"}
    for name, a in axes.items():
        for place in ("0 0 0", "1e6 -2e6 3e6"):
            at = [float(x) for x in place.split()]
            Picture(f"room{name}{'-elsewhere' if at[0] else ''}",
                    "The eye in the middle of a closed cube of triangles: rays along x = +-y pass through the diagonals,\nand through corners. No ray gets out.",
                    camera=at, focus=(at[0], at[1], at[2] - 1), size=64, background=(1, 0, 1)) \
                .glow(0, 1, 0, f"mesh cube.pmf 1 {a} {place}").all(0, 1, 0).write()
    Picture("room-corners", "The eye looks into the corners and along the edges of a closed cube.", camera=(0, 0, 0), focus=(1, 1, 1),
            size=33, background=(1, 0, 1), aperture=80).glow(0, 1, 0, "mesh cube.pmf 1 1 0 0 0 1 0 0 0 1 0 0 0").all(0, 1, 0).write()
    for mesh in ("cube", "icosahedron"):
        Picture(f"light-in-{mesh}", "A light in a closed opaque mesh lights nothing outside, through no edge and no vertex.",
                camera=(4, 6, 0), size=48).light(0, 2, 0, 1) \
            .body(f"material 0.25 0.25 0.25 1 1 1 {NO_CODE}", f"mesh {mesh}.pmf 1 1 0 0 0 1 0 0 0 1 0 2 0", "plane 0 1 0 -10") \
            .all(0.25, 0.25, 0.25).write()
    for count in (3, 4, 7):
        fan = [f"polygon 3 0 0 0 {row(*p)} {row(*q)}" for p, q in
               zip(ring(count), ring(count)[1:] + ring(count)[:1])]
        Picture(f"fan-{count}", "Triangles around a common vertex that the middle pixel sees: no gap between them.",
                camera=(0, 0, 1), size=33, background=(1, 0, 1), aperture=10).glow(0, 1, 0, *fan).all(0, 1, 0).write()
    big = " ".join(row(x, y, z) for x, y, z in ring(10000))
    Picture("10000-vertices", "A polygon of 10,000 vertices on a circle of radius 10: pixels that look within 9.99 see it, those\nbeyond 10.01 do not.",
            camera=(0, 0, 10), size=5, background=(1, 0, 1), aperture=50).glow(0, 1, 0, f"polygon 10000 {big}") \
        .pixel(2, 2, 0, 1, 0, 0).pixel(2, 3, 0, 1, 0, 0).pixel(1, 2, 0, 1, 0, 0).pixel(0, 0, 1, 0, 1, 0).pixel(4, 4, 1, 0, 1, 0).write()
    # A pane of two triangles: a shadow ray through their common edge counts the pane once.
    n = 16
    p = Picture("pane", "A pane of glass, two triangles, halfway to the light. Each point of the floor gets 0.5 (N.L), also where the way\ncrosses the triangles' common edge, above x = z.",
                camera=(0, 2, 0), focus=(0, 0, 0), size=n).body("up_vector 0 0 -1").light(0, 4, 0, 1)
    p.body("material 0 0 0 0 0 0 0 0 0 1 0 0.5 1", "mesh pane.pmf 1 1 0 0 0 1 0 0 0 1 0 3 0").matt("plane 0 1 0 0")
    (HERE / "pane.pmf").write_text("; a square of two triangles\n4 2\n-2 0 -2\n-2 0 2\n2 0 2\n2 0 -2\n0 1 2\n0 2 3\n")
    for i in range(n):
        for j in sorted({i, n - 1 - i, 3}):
            x, z = 2 * view(i, n), 2 * view(j, n)
            lit = D("0.5") * 4 / (16 + x * x + z * z).sqrt()
            p.pixel(i, j, lit, lit, lit)
    p.write()
    Picture("glass-ball-shadow", "Light through a glass ball crosses its surface twice: 0.5^2.", camera=(3, 4, 0)) \
        .light(0, 10, 0, 1).glass(D("0.5"), 1, "sphere 0 5 0 1").matt("plane 0 1 0 0").pixel(0, 0, *[0.25] * 3).write()
    Picture("glass-box-shadow-on-it", "A glass box stands on the plane, and the light passes it from top to bottom: 0.5^2, the face in the plane included.",
            camera=(0, 0.5, 3), focus=(0, 0, 0)).light(0, 10, 0, 1).matt("plane 0 1 0 0").glass(D("0.5"), 1, "box 0 3 0 2 2 2") \
        .pixel(0, 0, *[0.25] * 3).write()


def ring(count):
    """Points on a circle of radius 10, to six digits."""
    corners = [(2 * math.pi * i / count) for i in range(count)]
    return [(round(10 * math.cos(angle), 6), round(10 * math.sin(angle), 6), 0) for angle in corners]


def neighbours():
    """Close surfaces."""
    square = lambda z, s=1: f"polygon 4 {row(-s, -s, z, s, -s, z, s, s, z, -s, s, z)}"
    for gap in ("1e-3", "1e-6", "1e-9", "1e-12"):
        Picture(f"gap-{gap}", f"Two squares {gap} apart, the farther one first in the file: the nearer is seen, everywhere.",
                camera=(0.25, 0.125, 3), focus=(0.25, 0.125, 0), size=32, aperture=5).glow(1, 0, 0, square(0)).glow(0, 1, 0, square(gap)).all(0, 1, 0).write()
        Picture(f"gap-{gap}-lit", f"A square {gap} above another keeps all light from it: black but for its own light green.",
                camera=(0.25, 0.125, -3), focus=(0.25, 0.125, 0), size=32, aperture=5).light(0, 0, 5, 1) \
            .body(f"material 1 0 0 1 1 1 {NO_CODE}", square(0), f"material 0 1 0 0 0 0 {NO_CODE}", square(gap)).all(1, 0, 0).write()
    first, second = [("polygon", square(0)), ("disc", "disc 0 0 0 2\ninstance_referential 1 0 0 0 0 1 0 -1 0")], None
    for order, name in ((first, "polygon"), (first[::-1], "disc")):
        Picture(f"coplanar-{name}-first", "Two flat bodies in one plane: the first in the file is seen.", camera=(0.25, 0.125, 3), focus=(0.25, 0.125, 0), size=32, aperture=5) \
            .glow(0, 1, 0, order[0][1]).glow(1, 0, 0, order[1][1]).all(0, 1, 0).write()
    Picture("box-on-a-plane", "A box stands on a plane: from below the plane is seen and no box, from above no plane under it.",
            camera=(0.25, 3, 0.125), focus=(0.25, 0, 0.125), size=32, aperture=10).body("up_vector 0 0 1") \
        .glow(1, 0, 0, "plane 0 1 0 -1").glow(0, 1, 0, "box 0 0 0 2 2 2").all(0, 1, 0).write()
    Picture("box-through-a-plane", "The bottom of a box at -1 and a plane at -1.0000007: from below the plane is nearer.",
            camera=(0.25, -5, 0.125), focus=(0.25, 0, 0.125), size=32, aperture=5).body("up_vector 0 0 1") \
        .glow(1, 0, 0, "box 0 0 0 2 2 2").glow(0, 1, 0, "plane 0 1 0 -1.0000007").all(0, 1, 0).write()
    Picture("box-above-a-plane", "The gap of 7e-7 between a box and a plane is dark: the light above reaches nothing there.",
            camera=(-3, "-1.00000035", 0), focus=(0, "-1.00000035", 0)).light(0, 9, 0, 1) \
        .glow(0, 1, 0, "plane 0 1 0 -1.0000007").glow(1, 0, 0, "box 0 0 0 2 2 2").body("background_colour 0 0 1").pixel(0, 0, 0, 0, 1, 0).write()
    for far in ("1e3", "1e6", "1e9"):
        x = float(far)
        Picture(f"far-{far}", f"A ball and a box at {far} from the origin: where they are, doubles are fine enough for both.",
                camera=(x, x, x + 5), focus=(x, x, x), size=3, aperture=20, background=(0, 0, 1)).glow(0, 1, 0, f"sphere {row(x, x, x)} 0.5") \
            .pixel(1, 1, 0, 1, 0, 0).pixel(0, 0, 0, 0, 1, 0).pixel(2, 1, 0, 0, 1, 0).write()
    Picture("tiny-from-afar", "A ball of radius 1e-6, 1e8 away.", camera=(0, 0, "1e8"), background=(0, 0, 1)).glow(0, 1, 0, "sphere 0 0 0 1e-6").pixel(0, 0, 0, 1, 0, 0).write()
    Picture("beside-tiny-from-afar", "1.5e-6 beside the middle of a ball of radius 1e-6, 1e8 away.", camera=("1.5e-6", 0, "1e8"), focus=("1.5e-6", 0, 0), background=(0, 0, 1)) \
        .glow(0, 1, 0, "sphere 0 0 0 1e-6").pixel(0, 0, 0, 0, 1, 0).write()


def through_slit(picture, x, y, width, behind):
    """Two red squares at height y with a slit between them at x, green behind it."""
    for near, far in ((x - width, x - 100), (x + width, x + 100)):
        picture.glow(1, 0, 0, f"polygon 4 {row(near, y, 9, far, y, 9, far, y, -9, near, y, -9)}")
    picture.glow(0, 1, 0, behind)


def slab(name, why, layers, dx, dy, ct=D("0.5"), width=D("1e-12"), levels=6, boxes=None, surfaces=None):
    """Down through horizontal layers (index, height) from the top at y = 1, to a slit where the exact ray arrives."""
    s = D(dx) / (D(dx) ** 2 + D(dy) ** 2).sqrt()
    x, y = D(0), D(1)
    for index, height in layers:
        inner = s / D(index)
        x += D(height) * inner / (1 - inner * inner).sqrt()
        y -= D(height)
    floor = y - 8
    x += 8 * s / (1 - s * s).sqrt()
    p = Picture(name, why, camera=(-dx, 1 + dy, 0), focus=(0, 1, 0), levels=levels, background=(0, 0, 1))
    through_slit(p, x, floor, width, f"plane 0 1 0 {row(floor - 1)}")
    for index, low, high in boxes or [(layers[0][0], 1 - D(layers[0][1]), D(1))]:
        p.glass(ct, index, f"box 0 {row((low + high) / 2)} 0 100 {row(high - low)} 100")
    p.pixel(0, 0, 0, ct ** (surfaces or 2), 0, 0).write()


def refraction():
    for index in ("1", "1.0000001", "0.9999999", "1.5", "10", "0.75"):
        slab(f"slab-{index}", f"Through a slab of index {index}, sin = 0.6, by Snell's law: the ray arrives within 1e-12 of where it must.", [(index, 1)], 3, 4)
    slab("slab-0.1", "Through a slab of index 0.1, sin = 44/485, below the critical 0.1.", [("0.1", 1)], 44, 483)
    slab("slab-overlapping", "Two boxes overlap: the one entered first is left while in the other, which changes nothing (removed from the stack).",
         [("1.5", 1), ("1.25", 2)], 3, 4, boxes=[("1.5", D(-1), D(1)), ("1.25", D(-2), D(0))], surfaces=4, levels=3)
    slab("slab-nested", "A box in a box.", [("1.5", 1), ("1.25", 1), ("1.5", 1)], 3, 4, boxes=[("1.5", D(-2), D(1)), ("1.25", D(-1), D(0))], surfaces=4)
    slab("slab-nested-same", "A box in a box of the same index: the light goes straight on, and that is no level.", [("1.5", 3)], 3, 4,
         boxes=[("1.5", D(-2), D(1)), ("1.5", D(-1), D(0))], surfaces=4, levels=2)
    for change, name in ((D("1e-9"), "above"), (D("-1e-9"), "below"), (D("1e-13"), "hardly-above"), (D("-1e-13"), "hardly-below")):
        index = D("1.25") * (1 + change)
        total = index * D("0.8") > 1
        Picture(f"critical-{name}", f"From inside at sin = 0.8 onto index 1.25 (1 {float(change):+g}): index sin is {'more' if total else 'less'} than 1, so the ray "
                f"{'is reflected totally, to the red plane below' if total else 'gets out, to the blue sky'}.",
                camera=(-4, -2, 0), focus=(0, 1, 0), background=(0, 0, 1), levels=3) \
            .glow(1, 0, 0, "polygon 4 -90 -20 -90 -90 -20 90 90 -20 90 90 -20 -90").glass(D("0.5"), index, "box 0 -49 0 1000 100 1000") \
            .pixel(0, 0, *((D("0.5"), 0, 0) if total else (0, 0, D("0.5"))), 0).write()

    def upwards(name, why, indices, boxes, ct=D("0.5")):
        """From inside at sin 0.6, up through layers of height 1."""
        x, s = D(0), D("0.6")
        for k, index in enumerate(indices):
            inner = s * D(indices[0]) / D(index)
            x += (D(4) if k == 0 else D(1)) * inner / (1 - inner * inner).sqrt()
        out = s * D(indices[0])
        y = D(1) + len(indices) - 1 + 8
        x += 8 * out / (1 - out * out).sqrt() - 3
        p = Picture(name, why, camera=(-3, -3, 0), focus=(0, 1, 0), levels=4, background=(0, 0, 1))
        through_slit(p, x, y, D("1e-12"), f"plane 0 1 0 {row(y + 1)}")
        for index, top in boxes:
            p.glass(ct, index, f"box 0 {row(D(top) / 2 - 25)} 0 100 {row(D(top) + 50)} 100")
        p.pixel(0, 0, 0, ct ** len(boxes), 0, 0).write()
    upwards("eye-in-glass", "The eye stands in glass: out of it at sin = 1.5 0.6, by Snell's law.", ["1.5"], [("1.5", 1)])
    upwards("eye-in-two", "The eye stands in two boxes: out of the inner one into the outer, and out of that.", ["1.25", "1.5"], [("1.5", 2), ("1.25", 1)])
    Picture("eye-in-a-ball", "From the middle of a glass ball every ray leaves straight.", camera=(0, 0, 0), focus=(0, 0, -1), size=16, background=(0, 0, 1)) \
        .glass(D("0.5"), "1.7", "sphere 0 0 0 1").all(0, 0, D("0.5")).write()
    for gap in (D("1e-6"), D("1e-12")):
        Picture(f"touching-{float(gap)}", f"Two glass boxes {float(gap)} apart; the ray goes straight through both, four surfaces.",
                camera=(0.25, 5, 0.125), focus=(0.25, 0, 0.125), levels=4, background=(0, 0, 1)).body("up_vector 0 0 1") \
            .glass(D("0.5"), "1.5", f"box 0 {row(D('0.5') + gap)} 0 9 1 9", "box 0 -0.5 0 9 1 9").pixel(0, 0, 0, 0, D("0.0625"), 0).write()


def axes():
    for name, a in (("0.707", "0.707 0.707 0 -0.707 0.707 0"), ("long", "1e150 1e150 0 -1e-150 1e-150 0"), ("signs", "-1 -1 0 1 -1 0")):
        # A cube turned by 45 degrees shows an edge at sqrt(2) above its centre.
        r = D(2).sqrt()
        for e in (D("1e-12"), D("-1e-12")):
            Picture(f"axes-{name}-{'over' if e > 0 else 'under'}", "A cube turned by 45 degrees ends at a height of sqrt(2).", camera=(0, r + e, 5), focus=(0, r + e, 0), background=(0, 0, 1)) \
                .glow(0, 1, 0, "box 0 0 0 2 2 2", f"instance_referential {a}").pixel(0, 0, *((0, 0, 1) if e > 0 else (0, 1, 0)), 0).write()
    # Axes 1e-4 off: the closest rotation turns both by half of that.
    lean = D("1e-4")
    half = ((1 + lean * lean).sqrt() - 1) / lean  # tan of half the angle
    for e in (D("1e-10"), D("-1e-10")):
        y = 1 * half + (1 + half * half).sqrt() + e  # the top face y' = 1 above x = -1 ... at x = 1: 1 sin + ...
        Picture(f"axes-leaning-{'over' if e > 0 else 'under'}", "Axes 1e-4 off perpendicular count as the closest rotation, turned by half of that: above x = 1 the top face is at\nh + sqrt(1 + h^2), h its tangent.",
                camera=(1, y, 0), focus=(0, y - half, 0), background=(0, 0, 1)) \
            .glow(0, 1, 0, "box 0 0 0 200 2 2", f"instance_referential {row(1, lean, 0)} 0 1 0") \
            .pixel(0, 0, *((0, 0, 1) if e > 0 else (0, 1, 0)), 0).write()
    Picture("axes-mirrored", "Left-handed axes are no rotation.").glow(1, 1, 1, "box 0 0 0 1 1 1", "instance_referential 1 0 0 0 1 0 0 0 -1").error("scene.bad-axes").write()
    Picture("up-nearly-parallel", "An up vector 1e-9 off the view: what is up is the side that it leans to.", size=3, background=(0, 0, 1)) \
        .body("up_vector 0 1e-9 1").glow(0, 1, 0, "box 0 3.3333333333 0 1 1 1").pixel(1, 0, 0, 1, 0, 0).pixel(1, 2, 0, 0, 1, 0).write()
    Picture("up-parallel", "An up vector along the view says nothing.").body("up_vector 0 0 1").glow(1, 1, 1, "sphere 0 0 0 1").error("scene.up-parallel").write()


def shading():
    # The eye above the origin looks down at 3-4-5 on a mirroring-highlight plane; the light at angle u from the mirror direction.
    def highlight(name, why, n, light, within=1e-14):
        lx, ly = D(light[0]), D(light[1])
        length = (lx * lx + ly * ly).sqrt()
        cosine, along = ly / length, (D("-0.6") * lx + D("0.8") * ly) / length
        shine = (along ** D(n) if n else D(1)) if along > 0 else D(0)
        v = D("0.5") * cosine + D("0.25") * shine
        Picture(name, why, camera=(3, 4, 0)).light(*light, 0, 1).body(f"material 0 0 0 0.5 0.5 0.5 0.25 0.25 0.25 {n} 0 0 0", "plane 0 1 0 0") \
            .pixel(0, 0, v, v, v, within).write()
    highlight("exponent-0", "0.5 N.L + 0.25 (R.L)^0: an exponent of 0 shines wherever R.L > 0.", 0, (-1, 1))
    highlight("exponent-0-behind", "R.L < 0: no shine, of no exponent.", 0, (9, 1))
    highlight("exponent-1", "0.5 N.L + 0.25 R.L.", 1, (-1, 1))
    highlight("exponent-1e6", "(R.L)^1e6 of a light 1e-3 off the mirror direction; an ulp in R.L makes 1e-10 in the power.", 1000000, (D("-0.6008"), D("0.7994")), 1e-10)
    highlight("exponent-1e6-straight", "R.L = 1 but for rounding, which 1e6 makes 1e-10.", 1000000, (-3, 4), 1e-9)
    for b in ("0", "1e6", "1e-300"):
        Picture(f"brightness-{b}", "0.25 + b N.L, with N.L = 1.", camera=(3, 4, 0)).light(0, 1, 0, b).body(f"material 0.25 0.25 0.25 1 1 1 {NO_CODE}", "plane 0 1 0 0") \
            .pixel(0, 0, *[D("0.25") + D(b)] * 3, 1e-9 if b == "1e6" else 0).write()
    for off in (D("1e-3"), D("1e-6"), D("1e-9")):
        c = off / (1 + off * off).sqrt()
        Picture(f"grazing-{float(off)}", "A light far off, nearly in the plane: N.L = e / sqrt(1 + e^2), and no shadow of the plane's own.",
                camera=(3, 4, 0)).light(0, off * 1000, 1000, 1).matt("polygon 4 -9 0 -9 -9 0 9 9 0 9 9 0 -9").pixel(0, 0, c, c, c, float(c) * 1e-6).write()
    Picture("cr-and-ct-1", "cr = ct = 1: what is mirrored and what is transmitted both count in full.", camera=(3, 4, 0), levels=1, background=(0.5, 0.25, 0.125)) \
        .body("material 0.5 0.5 0.5 0 0 0 0 0 0 1 1 1 1", "plane 0 1 0 0").pixel(0, 0, D("1.5"), D("1"), D("0.75"), 0).write()


def inputs():
    digits = "1." + "0" * 199 + "1" * 200
    ok = lambda name, why, *lines: Picture(f"input-{name}", why, background=(0, 0, 1)).glow(0, 1, 0, *lines).pixel(0, 0, 0, 1, 0, 0).write()
    bad = lambda name, why, code, *lines: Picture(f"input-{name}", why).glow(0, 1, 0, *lines).error(code).write()
    ok("400-digits", "A radius of 400 digits is the nearest double, 1.", f"sphere 0 0 0 {digits}")
    ok("denormal-centre", "A denormal coordinate is as good as 0.", "sphere 5e-324 -4.9e-324 1e-310 1")
    ok("minus-zero", "-0 is 0.", "sphere -0 -0.0 -0e9 1")
    ok("huge-sphere-behind", "A sphere of radius 1e100 around everything, and one in front of its wall.", "sphere 0 0 0 1", "sphere 0 0 0 1e100")
    Picture("input-denormal-radius", "A radius of 5e-324 is positive. Half a pixel beside it there is nothing.", camera=(0.5, 0, 5), focus=(0.5, 0, 0), background=(0, 0, 1)) \
        .glow(0, 1, 0, "sphere 0 0 0 5e-324").pixel(0, 0, 0, 0, 1, 0).write()
    Picture("input-1e308", "A sphere whose centre is 1e308 away is not seen; no nan gets into the picture.", background=(0, 0, 1), size=4) \
        .glow(0, 1, 0, "sphere 1e308 0 0 1", "box 0 1e308 0 1 1 1", "cone 0 0 -1e308 1 1").all(0, 0, 1).write()
    bad("nan", "nan is no number.", "lang.bad-number", "sphere nan 0 0 1")
    bad("inf", "inf is no number.", "lang.bad-number", "sphere 0 inf 0 1")
    bad("1e309", "Beyond the largest double.", "lang.number-too-large", "sphere 0 0 1e309 1")
    bad("400-digits-too-large", "4 times 10^399.", "lang.number-too-large", "sphere 0 0 " + "4" * 400 + " 1")
    bad("radius-0", "A radius of 0.", "scene.radius-not-positive", "sphere 0 0 0 0")
    bad("radius-minus-0", "A radius of -0.", "scene.radius-not-positive", "sphere 0 0 0 -0")
    bad("radius-underflow", "A radius whose nearest double is 0.", "scene.radius-not-positive", "sphere 0 0 0 1e-400")
    bad("side-0", "A box without thickness.", "scene.side-not-positive", "box 0 0 0 1 0 1")
    bad("two-vertices", "A polygon needs three vertices.", "scene.too-few-vertices", "polygon 2 0 0 0 1 0 0")
    bad("no-area", "Collinear vertices enclose nothing.", "scene.no-area", "polygon 3 0 0 0 1 1 1 2 2 2")
    bad("twice-a-vertex", "Neighbouring vertices must differ.", "scene.repeated-vertex", "polygon 4 0 0 0 0 0 0 1 0 0 0 1 0")
    bad("empty-mesh", "A mesh without faces.", "scene.mesh-empty", "mesh empty.pmf 1 1 0 0 0 1 0 0 0 1 0 0 0")
    (HERE / "empty.pmf").write_text("0 0\n")
    bad("height-above-cone", "More kept than there is.", "scene.height-above-cone", "truncated_cone 0 0 0 1 1 1.0000000000000002")
    bad("plane-without-normal", "A plane needs a normal.", "scene.normal-zero", "plane 0 0 0 1")
    bad("brightness-negative", "Light cannot be negative.", "scene.colour-negative", "light_source 0 0 0 -1e-300")
    Picture("input-nothing", "No object, no light: the background.", size=4, background=("0.1", "0.2", "0.3")).all("0.1", "0.2", "0.3").write()


for old in HERE.glob("*.yarte"):
    old.unlink()
for family in (starts, meshes, neighbours, refraction, axes, shading, inputs):
    family()
