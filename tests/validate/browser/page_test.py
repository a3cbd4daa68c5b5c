#!/usr/bin/env python3
"""page_test.py BIN SCENES OUTPUT: opens a report in Chromium and uses every control as a person does.

Makes a report of three scenes compared with a baseline from which one differs, puts two regions and a failed condition
into its data, and leaves screenshots in OUTPUT. Exit code 77: there is no Chromium.
"""
import hashlib
import json
import math
import pathlib
import re
import struct
import subprocess
import sys
import time

import chromium

BIN, SCENES, OUTPUT = (pathlib.Path(argument).resolve() for argument in sys.argv[1:4])
REGIONS = [
    {"box": [10, 20, 60, 50], "pixels": 700, "max_abs": 0.25, "max_abs_at": [30, 40], "cause": "body",
     "subject": "sphere at line 7", "body": 0, "light": None, "line": 7, "explanation": "the <b>sphere</b> at line 7 moved"},
    {"box": [100, 100, 101, 101], "pixels": 1, "max_abs": 0.01, "max_abs_at": [100, 100], "cause": "unknown", "subject": "",
     "body": None, "light": None, "line": None, "explanation": "unknown"}]
CONDITION = {"depth": 0, "group": False, "text": "max_abs <= 4/65535", "holds": False, "measured": 0.25,
             "limit": 4 / 65535, "reason": "a reason", "pointer": ""}


def check(condition, what):
    if not condition:
        raise chromium.Failure(what)


def equal(got, expected, what):
    check(got == expected, f"{what}: got {got!r}, expected {expected!r}")


def make_report():
    """OUTPUT/index.html; returns its report.json with the regions."""
    scenes = OUTPUT / "scenes"
    scenes.mkdir(parents=True, exist_ok=True)
    for name in ("mirrors", "gamma", "turned"):
        (scenes / f"{name}.yarte").write_text((SCENES / name / f"{name}.yarte").read_text())
    files = sorted(scenes.glob("*.yarte"))
    command = [BIN / "yarte-validate", *files, "-o", OUTPUT / "report", "--baseline", OUTPUT / "baseline", "--size", "200x150"]
    subprocess.run([*command, "--update-baseline"], check=True, stdout=subprocess.DEVNULL)
    with open(scenes / "turned.yarte", "a", encoding="utf-8") as scene:
        scene.write("\nlight_source 3 9 9 0.3\n")
    equal(subprocess.run(command, stdout=subprocess.DEVNULL).returncode, 1, "exit code")
    html = (OUTPUT / "report/index.html").read_text()
    block = re.compile(r'(<script type="application/json" id="report">)(.*?)(</script>)', re.S)
    report = json.loads(block.search(html)[2])
    report["cases"][2] |= {"regions": REGIONS, "cause": None, "conditions": [CONDITION]}
    text = json.dumps(report).replace("<", "\\u003c")
    (OUTPUT / "index.html").write_text(block.sub(lambda m: m[1] + text + m[3], html))
    return report


def read_pfm(file, x, y):
    """A pixel of a PFM; its rows start at the bottom."""
    magic, size, scale, data = file.read_bytes().split(b"\n", 3)
    width, height = map(int, size.split())
    return struct.unpack_from("<3f" if float(scale) < 0 else ">3f", data, 12 * ((height - 1 - y) * width + x))


class Test:
    def __init__(self, page, report):
        self.page, self.report = page, report

    # What a test looks at.
    def text(self, selector):
        return self.page.run(f"document.querySelector({json.dumps(selector)}).textContent")

    def names(self):
        return self.page.run("[...document.querySelectorAll('#overview tbody a')].map((a) => a.textContent)")

    def canvas(self, part="0, 0, c.width, c.height"):
        """A digest of what the viewer shows."""
        data = self.page.run("(() => { const c = document.querySelector('.stage canvas'); return "
                             f"[...c.getContext('2d').getImageData({part}).data].join(); }})()")
        return hashlib.sha1(data.encode()).hexdigest()

    def brightness(self):
        return self.page.run("(() => { const c = document.querySelector('.stage canvas'); const d = c.getContext('2d')"
                             ".getImageData(0, 40, c.width, c.height - 40).data; return d.reduce((a, b) => a + b, 0); })()")

    def scale(self):
        return float(self.text("#scale").removesuffix("×").replace("1/", "1e-1"))

    def open_case(self, name):
        self.page.run(f"location.hash = '#/{name}'")
        self.shown(f"#/{name}")

    def open_table(self):
        self.page.run("location.hash = ''")
        self.shown("#")

    def shown(self, fragment):
        self.page.wait(f"document.documentElement?.dataset.shown === '{fragment}'")

    def mode(self, name):
        self.page.click(f"[data-mode={name}]")
        equal(self.page.run(f"document.querySelector('[data-mode={name}]').ariaPressed"), "true", f"mode {name} is on")
        equal(self.page.run("document.querySelectorAll('[data-mode][aria-pressed=true]').length"), 1, "modes that are on")

    def hover(self, x, y):
        """Over a pixel of the picture, wherever the viewer shows it now (fitted, in one pane)."""
        left, top, width, height = self.page.run("(() => { const r = document.querySelector('.stage canvas')"
                                                 ".getBoundingClientRect(); return [r.x, r.y, r.width, r.height]; })()")
        scale = self.scale()
        self.page.mouse("mouseMoved", left + width / 2 + (x + 0.5 - 100) * scale, top + height / 2 + (y + 0.5 - 75) * scale)

    # The tests, in the order of the file.
    def test_table(self):
        equal(self.names(), ["turned", "gamma", "mirrors"], "failures first")
        self.page.click("th.name button")
        equal(self.names(), ["gamma", "mirrors", "turned"], "sorted by name")
        self.page.click("th.name button")
        equal(self.names(), ["turned", "mirrors", "gamma"], "and backwards")
        equal(self.page.run("document.querySelector('th.name').ariaSort"), "descending", "what is said of it")
        self.page.click("[data-verdict=pass]")
        equal(self.names(), ["turned"], "without passes")
        self.page.click("[data-verdict=fail]")
        check("No case is like that" in self.text("#overview"), "an empty table says so")
        self.page.click("[data-verdict=pass]")
        self.page.click("[data-verdict=fail]")
        self.page.key("/")
        for key in "irro":
            self.page.key(key)
        equal(self.names(), ["mirrors"], "found by what is typed")
        self.page.run("(() => { const s = document.querySelector('#search'); s.value = ''; s.dispatchEvent(new Event('input')); })()")
        check("the <b>sphere</b> at line 7 moved" in self.text("#overview"), "the cause is shown, as text")
        equal(self.page.run("[...document.querySelectorAll('#overview img')].filter((i) => i.naturalWidth > 0).length"), 3, "thumbnails")

    def test_links_and_neighbours(self):
        self.page.click("#overview tbody a")
        self.shown("#/turned")
        self.page.key("p")
        self.shown("#/mirrors")
        self.page.click("#next")
        self.shown("#/turned")
        equal(self.page.run("document.querySelector('#next').disabled"), True, "there is no next")
        self.page.key("Escape")
        self.shown("#")

    def test_values_are_those_of_the_files(self):
        case = self.report["cases"][2]
        self.open_case("turned")
        x, y = case["max_abs_at"]
        self.hover(x, y)
        readout = self.text("#readout")
        check(readout.startswith(f"pixel ({x}, {y}) "), f"the pixel under the pointer: {readout}")
        a, b, difference = ([float(v.replace("−", "-").replace("<1", "0")) for v in re.findall(r"[−+<]?\d+(?:\.\d+)?", line)[-4 if i == 2 else -3:][:3]]
                            for i, line in enumerate(line.replace("/65535", " 65535").replace("linear", "") for line in readout.split("\n")[1:]))
        rendered = read_pfm(OUTPUT / "report/images/turned/yarte.pfm", x, y)
        for channel in range(3):
            value = rendered[channel] * case["exposure"]
            check(abs(a[channel] - value) < 1.1 / 65535 + 5e-6, f"YARTE's value: {a} for {rendered}")
            check(abs((a[channel] - b[channel]) * 65535 - difference[channel]) < 1.5, f"the difference: {readout}")
        check(abs(max(map(abs, difference)) - case["max_abs"] * 65535) < 1, f"the largest difference: {readout}")

    def test_pictures(self):
        self.open_case("turned")
        seen = {}
        for mode in ("a", "b", "difference", "flip", "side", "wipe"):
            self.mode(mode)
            seen[mode] = self.canvas()
        equal(len(set(seen.values())), 6, "pictures that differ from each other")
        # The slider shows one picture on its left and the other on its right.
        parts = {}
        for mode in ("a", "b", "wipe"):
            self.mode(mode)
            parts[mode] = [self.canvas("c.width * 0.3, 60, 40, 300"), self.canvas("c.width * 0.65, 60, 40, 300")]
        equal(parts["wipe"], [parts["a"][0], parts["b"][1]], "the slider's halves")
        self.page.key("s")
        equal([self.canvas("c.width * 0.3, 60, 40, 300"), self.canvas("c.width * 0.65, 60, 40, 300")],
              [parts["b"][0], parts["a"][1]], "exchanged")
        self.page.key("s")
        self.mode("a")
        self.page.click("#swap")
        equal(self.canvas(), seen["b"], "swapped")
        self.page.key("s")
        equal(self.canvas(), seen["a"], "swapped back")

    def test_keys_of_the_pictures(self):
        for key, mode in zip("abxwgdf", ("a", "b", "blink", "wipe", "side", "difference", "flip")):
            self.page.key(key)
            equal(self.page.run(f"document.querySelector('[data-mode={mode}]').ariaPressed"), "true", f"key {key}")
        self.page.key("a")

    def test_blink(self):
        self.mode("a")
        a = self.canvas()
        self.mode("b")
        b = self.canvas()
        self.mode("blink")
        seen, deadline = set(), time.monotonic() + 20
        while seen != {a, b} and time.monotonic() < deadline:
            seen.add(self.canvas())
            time.sleep(0.05)
        equal(seen, {a, b}, "both pictures in turn")
        self.mode("a")

    def test_slider_is_dragged(self):
        self.mode("wipe")
        x, y = self.page.middle(".stage canvas")
        self.page.mouse("mousePressed", x, y)
        self.page.mouse("mouseMoved", x + 150, y, button="left", buttons=1)
        self.page.mouse("mouseReleased", x + 150, y)
        check(float(self.page.run("document.querySelector('#wipe').value")) > 0.6, "the slider follows")
        self.mode("a")

    def test_levels(self):
        before = self.brightness()
        self.page.key("e")
        self.page.key("e")
        equal(self.page.run("document.querySelector('#exposure').value"), "1", "exposure in stops")
        check(self.brightness() > before, "brighter")
        self.page.key("q")
        self.page.key("q")
        equal(self.brightness(), before, "as before")
        self.mode("difference")
        check(not self.page.run("document.querySelector('#gain').disabled"), "the amplification can be set")
        weak = self.brightness()
        self.page.run("(() => { const g = document.querySelector('#gain'); g.value = 12; g.dispatchEvent(new Event('input')); })()")
        check(self.brightness() > weak, "amplified")
        self.mode("a")

    def test_zoom_and_move(self):
        self.page.click("button[title='Whole picture (0)']")
        start, picture = self.scale(), self.canvas()
        self.page.key("+")
        equal(self.scale(), 2 * start, "twice as large")
        x, y = self.page.middle(".stage canvas")
        self.page.call("Input.dispatchMouseEvent", type="mouseWheel", x=x + 30, y=y, deltaX=0, deltaY=-240)
        self.page.wait(f"parseFloat(document.querySelector('#scale').textContent) === {4 * start}")
        self.hover(0, 0)
        zoomed = self.canvas()
        self.page.mouse("mousePressed", x, y)
        self.page.mouse("mouseMoved", x + 50, y + 20, button="left", buttons=1)
        self.page.mouse("mouseReleased", x + 50, y + 20)
        check(self.canvas() != zoomed, "it moves")
        moved = self.canvas()
        self.page.run("document.querySelector('.stage canvas').focus()")
        self.page.key("ArrowRight")
        check(self.canvas() != moved, "it moves by keys")
        self.page.key("0")
        equal(self.scale(), start, "fits again")
        equal(self.canvas(), picture, "the same picture again")

    def test_regions(self):
        outlined = self.canvas()
        self.page.key("o")
        check(self.canvas() != outlined, "without outlines")
        self.page.key("o")
        equal(self.canvas(), outlined, "with outlines again")
        equal(self.page.run("[...document.querySelectorAll('.regions button span:nth-child(2)')].map((e) => e.textContent)"),
              [region["explanation"] for region in REGIONS], "explanations, as text")
        self.page.click(".regions li:nth-child(2) button")
        check(self.scale() > 40, "a region is zoomed to")
        equal(self.page.run("document.querySelectorAll('.regions button')[1].ariaPressed"), "true", "it is marked")
        self.page.run("document.activeElement.blur()")
        self.page.key("r")
        equal(self.page.run("document.querySelectorAll('.regions button')[0].ariaPressed"), "true", "the next region")
        check("4096 times the limit" in self.text(".conditions"), "by how much a condition fails")

    def test_values_on_pixels(self):
        self.page.click(".regions li:nth-child(2) button")
        for _ in range(3):
            self.page.key("+")
        check(self.scale() >= 58, "pixels are large")
        for mode in ("a", "b", "difference", "flip"):
            self.mode(mode)
            colours = self.page.run("(() => { const c = document.querySelector('.stage canvas'); const d = new Uint32Array(c.getContext('2d')"
                                    ".getImageData(c.width / 2 - 40, c.height / 2 - 40, 80, 80).data.buffer); return new Set(d).size; })()")
            check(colours > 8, f"numbers are written on pixels of {mode}: {colours} colours")
        self.page.screenshot(OUTPUT / "values.png")
        self.mode("a")
        self.page.key("0")

    def test_help_and_theme(self):
        self.page.key("?")
        check(self.page.run("document.querySelector('#help').open"), "help is open")
        check("side by side" in self.text("#help"), "it lists the keys")
        self.page.screenshot(OUTPUT / "help.png")
        self.page.click("#help button")
        check(not self.page.run("document.querySelector('#help').open"), "help is closed")
        colours = set()
        for _ in range(3):
            self.page.click("#theme")
            colours.add(self.page.run("getComputedStyle(document.body).backgroundColor"))
        equal(len(colours), 2, "backgrounds of the themes")

    def test_names_for_those_who_do_not_see(self):
        for fragment in ("#", "#/turned"):
            self.page.run(f"location.hash = '{fragment}'")
            self.shown(fragment)
            nodes = self.page.call("Accessibility.getFullAXTree")["nodes"]
            controls = [n for n in nodes if n.get("role", {}).get("value") in ("button", "slider", "searchbox", "combobox", "img", "link", "table")]
            check(len(controls) > 5, "controls are found")
            for node in controls:
                check(node.get("name", {}).get("value"), f"a {node['role']['value']} has no name")

    def test_contrast(self):
        for scheme in ("light", "dark"):
            self.page.scheme(scheme)
            for ink in ("ink", "faint", "pass", "fail", "error", "link"):
                for ground in ("page", "card", "raised"):
                    ratio = contrast(*(self.colour(name) for name in (ink, ground)))
                    check(ratio >= 4.5, f"{scheme}: {ink} on {ground} has a contrast of {ratio:.2f}")

    def colour(self, variable):
        text = self.page.run(f"(() => {{ const e = document.createElement('i'); e.style.color = 'var(--{variable})'; document.body.append(e);"
                             " const c = getComputedStyle(e).color; e.remove(); return c; })()")
        return [int(v) for v in re.findall(r"\d+", text)[:3]]

    def test_screens(self):
        for name, width, height, scheme in (("light", 1280, 900, "light"), ("dark", 1280, 900, "dark"), ("narrow", 390, 844, "light")):
            self.page.size(width, height)
            self.page.scheme(scheme)
            for fragment in ("#", "#/turned"):
                self.page.run(f"location.hash = '{fragment}'")
                self.shown(fragment)
                check(self.page.run("document.documentElement.scrollWidth <= innerWidth"), f"{name} {fragment}: wider than the screen")
                self.page.screenshot(OUTPUT / f"{name}-{'table' if fragment == '#' else 'case'}.png")


def contrast(a, b):
    """WCAG 2's ratio of two sRGB colours."""
    def luminance(colour):
        linear = [v / 255 / 12.92 if v <= 10 else math.pow((v / 255 + 0.055) / 1.055, 2.4) for v in colour]
        return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    low, high = sorted((luminance(a), luminance(b)))
    return (high + 0.05) / (low + 0.05)


def main():
    program = chromium.find()
    if not program:
        print("skipped: no chromium")
        return 77
    report = make_report()
    with chromium.Page(program) as page:
        page.size(1280, 900)
        page.scheme("light")
        page.open((OUTPUT / "index.html").as_uri())
        test = Test(page, report)
        test.shown("#")
        for name in [name for name in vars(Test) if name.startswith("test_")]:
            getattr(test, name)()
            # The test itself reads the canvas back, which the browser finds slow.
            complaints = [text for text in page.complaints if "getImageData" not in text]
            equal(complaints, [], f"{name}: errors in the console")
            print("ok", name, flush=True)
        foreign = [url[:80] for url in page.requests if not url.startswith("data:") and url != (OUTPUT / "index.html").as_uri()]
        equal(foreign, [], "requests that leave the page")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except chromium.Failure as failure:
        print("FAILED:", failure)
        sys.exit(1)
