"""The scenes of ci/bench's tables, by name."""
import pathlib
import subprocess
import sys

from measure import BIN, ROOT


def find_scene(name, size, folder):
    """A scene's name and its .yarte: of scenes/, of scenes.py, or from a .pov file; what is not there is made in `folder`."""
    if name.endswith(".pov"):
        scene = folder / f"{pathlib.Path(name).stem}.yarte"
        subprocess.run([BIN / "yarte-convert", name, scene, "--size", size], check=True, stderr=subprocess.DEVNULL)
        return scene.stem, scene
    scene = ROOT / f"scenes/{name}/{name}.yarte"
    if not scene.exists():
        subprocess.run([ROOT / "tests/bench/scenes.py", name, folder], check=True)
        scene = folder / f"{name}.yarte"
    return name, scene


def largest_spd(corpora):
    """The largest file of each scene of Haines's Standard Procedural Databases: balls_4.pov, ..."""
    if not corpora:
        print("bench: without --corpora the scenes of SPD are left out", file=sys.stderr)
        return []
    files = sorted((pathlib.Path(corpora) / "spd").glob("*_*.pov"))
    return [str(file) for file in {file.stem.split("_")[0]: file for file in files}.values()]
