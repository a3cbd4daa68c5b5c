#!/usr/bin/env python3
"""report_page.py BIN SCENE [COUNT]: how large a report of COUNT cases (200) is, and how long Chromium takes to open it.

Every case is SCENE at 256x256, from a report of one whose parts are repeated. Prints the median of five openings: from
the browser's start of navigation until the table is there and drawn.
"""
import json
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "validate/browser"))
import chromium  # noqa: E402


def repeated(html, count):
    def block(name):
        return re.compile(rf'(<script type="[a-z/]+" id="{name}">)(.*?)(</script>)', re.S)

    report = json.loads(block("report").search(html)[2])
    report["cases"] = [report["cases"][0] | {"name": f"case-{i}"} for i in range(count)]
    pages = json.loads(block("pages").search(html)[2]) * count
    pixels = block("pixels-0").search(html)[2]
    html = block("pixels-0").sub("", html)
    html = block("report").sub(lambda m: m[1] + json.dumps(report).replace("<", "\\u003c") + m[3], html)
    html = block("pages").sub(lambda m: m[1] + json.dumps(pages) + m[3], html)
    blocks = "".join(f'<script type="text/plain" id="pixels-{i}">{pixels}</script>\n' for i in range(count))
    return html.replace('<script type="module">', blocks + '<script type="module">')


def main(bin_folder, scene, count=200):
    program = chromium.find()
    if not program:
        sys.exit("no chromium")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        # Against its own picture as the baseline: no POV-Ray is needed.
        command = [f"{bin_folder}/yarte-validate", scene, "--size", "256x256", "-o", folder, "--baseline", folder / "base"]
        subprocess.run([*command, "--update-baseline"], check=True, stdout=subprocess.DEVNULL)
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        page_file = folder / "index.html"
        page_file.write_text(repeated(page_file.read_text(), int(count)))
        seconds = []
        for _ in range(5):
            with chromium.Page(program) as page:
                page.open(page_file.as_uri())
                page.wait("document.documentElement?.dataset.shown !== undefined")
                seconds.append(page.run("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => "
                                        "done(performance.now() / 1000))))"))
        print(f"{count} cases of {scene} at 256x256: {page_file.stat().st_size / 1e6:.1f} MB, "
              f"opened in {statistics.median(seconds):.2f} s ({', '.join(f'{s:.2f}' for s in seconds)})")


if __name__ == "__main__":
    main(*sys.argv[1:])
