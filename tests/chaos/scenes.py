"""The scenes of the trials: small ones of scenes/ and generated ones. Each is put into a folder as scene.yarte and its meshes."""
import math
import random
import shutil

HEAD = ("camera_position 0 0 6\nfocus_point 0 0 0\ncamera_apertures 40 32\nlight_source 5 9 6 1\nlight_source -7 4 5 0.4\n"
        "material 0.1 0.1 0.1 0.5 0.4 0.3 0.3 0.3 0.3 30 0.3 0 0\n")


def spheres(folder, scenes):
    rng = random.Random(5)
    balls = (f"sphere {rng.uniform(-2, 2):.4f} {rng.uniform(-1.6, 1.6):.4f} {rng.uniform(-2, 2):.4f} 0.2\n" for _ in range(120))
    (folder / "scene.yarte").write_text(HEAD + "".join(balls))


def relief(folder, scenes):
    """A mesh of 12800 triangles, which takes as long to read and to build as the picture to trace."""
    side = 80
    corners = [f"{4 * x / side - 2:.4f} {4 * y / side - 2:.4f} {0.3 * math.sin(x / 5) * math.cos(y / 7):.4f}\n"
               for y in range(side + 1) for x in range(side + 1)]
    faces = []
    for y in range(side):
        for x in range(side):
            a = y * (side + 1) + x
            b = a + side + 1
            faces += [f"{a} {a + 1} {b + 1}\n", f"{a} {b + 1} {b}\n"]
    (folder / "relief.pmf").write_text(f"{len(corners)} {len(faces)}\n" + "".join(corners) + "".join(faces))
    (folder / "scene.yarte").write_text(HEAD + "mesh relief.pmf 1 1 0 0 0 1 0 0 0 1 0 0 0\n")


def of_the_project(name):
    def make(folder, scenes):
        shutil.copytree(scenes / name, folder, dirs_exist_ok=True)
        (folder / f"{name}.yarte").rename(folder / "scene.yarte")
    return make


MAKERS = {"spheres": spheres, "relief": relief} | {name: of_the_project(name) for name in ("paper", "open_glass", "smooth_mesh")}
