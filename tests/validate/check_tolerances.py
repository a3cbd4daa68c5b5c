#!/usr/bin/env python3
"""check_tolerances.py PROJECT: the published schema of tolerances accepts and refuses what the program does.

The table data/tolerances.json goes through the schema here and through the program's reader in tolerance_test.cpp.
The schema also accepts every tolerance.json of the project and every example of validate/README.md.
"""
import json
import pathlib
import re
import sys

from check_schema import Checker


def readme_examples(text):
    """Blocks of code that are JSON objects, and such objects within a line."""
    blocks = re.findall(r"^    \{.*(?:\n    .*)*", text, re.MULTILINE)
    return [json.loads(example) for example in blocks + re.findall(r"`(\{\"[a-z_]+\": .*\})`", text)]


def main(project):
    folder = pathlib.Path(project) / "validate"
    checker = Checker(json.loads((folder / "tolerance.schema.json").read_text(encoding="utf-8")))
    wrong = []

    def expect(good, tolerance, what):
        found = list(checker.errors(tolerance, checker.root))
        if good == bool(found):
            wrong.append(f"{what}: {json.dumps(tolerance)}: expected {'good' if good else 'bad'}, found {found}")

    table = json.loads((pathlib.Path(__file__).parent / "data/tolerances.json").read_text(encoding="utf-8"))
    for entry in table:  # what is beyond a schema, it judges the other way; if not, it is not beyond it
        expect(entry["good"] != ("beyond_schema" in entry), entry["file"], "table")
    examples = readme_examples((folder / "README.md").read_text(encoding="utf-8"))
    if len(examples) < 2:
        wrong.append("README.md: its examples are not found")
    for example in examples:
        expect(True, example, "README.md")
    files = [f for top in ("scenes", "tests") for f in (pathlib.Path(project) / top).rglob("tolerance.json")]
    for file in files:
        expect(True, json.loads(file.read_text(encoding="utf-8")), file)
    print("\n".join(wrong) or f"{len(table)} of the table, {len(examples)} examples, {len(files)} files: as expected")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
