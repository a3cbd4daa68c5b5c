#!/usr/bin/env python3
"""check_schema.py SCHEMA FILE...: checks JSON files against a JSON schema (draft 2020-12).

Knows the keywords that our schemas use, and refuses a schema with any other: none is silently ignored.
"""
import json
import re
import sys

TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "null": type(None)}
ANNOTATIONS = {"$schema", "$defs", "title", "description"}


def has_type(value, name):
    if name in ("integer", "number"):
        return not isinstance(value, bool) and isinstance(value, int if name == "integer" else (int, float))
    return isinstance(value, TYPES[name])


def same(value, other):
    """JSON's equality: true is not 1."""
    return value == other and isinstance(value, bool) == isinstance(other, bool)


def as_list(value):
    return value if isinstance(value, list) else [value]


class Checker:
    def __init__(self, schema):
        self.root = schema

    def errors(self, value, schema, place=""):
        if isinstance(schema, bool):
            if not schema:
                yield f"{place}: may not be here"
            return
        for keyword, rule in schema.items():
            if keyword in ANNOTATIONS:
                continue
            check = getattr(self, "check_" + keyword.strip("$"), None)
            if check is None:
                raise SystemExit(f"check_schema: unknown keyword {keyword}")
            yield from check(value, rule, schema, place)

    def check_type(self, value, rule, _, place):
        if not any(has_type(value, name) for name in as_list(rule)):
            yield f"{place}: {value!r} is not of type {rule}"

    def check_const(self, value, rule, _, place):
        if not same(value, rule):
            yield f"{place}: {value!r} is not {rule!r}"

    def check_enum(self, value, rule, _, place):
        if not any(same(value, option) for option in rule):
            yield f"{place}: {value!r} is none of {rule}"

    def check_ref(self, value, rule, _, place):
        target = self.root
        for part in rule.removeprefix("#/").split("/"):
            target = target[part]
        yield from self.errors(value, target, place)

    def check_anyOf(self, value, rule, _, place):
        if all(list(self.errors(value, option, place)) for option in rule):
            yield f"{place}: fits none of the alternatives"

    def check_allOf(self, value, rule, _, place):
        for option in rule:
            yield from self.errors(value, option, place)

    def check_oneOf(self, value, rule, _, place):
        count = sum(not list(self.errors(value, option, place)) for option in rule)
        if count != 1:
            yield f"{place}: fits {count} of the alternatives"

    def check_propertyNames(self, value, rule, _, place):
        if isinstance(value, dict):
            for name in value:
                yield from self.errors(name, rule, f"{place}/{name}")

    def check_minProperties(self, value, rule, _, place):
        if isinstance(value, dict) and len(value) < rule:
            yield f"{place}: fewer than {rule} properties"

    def check_properties(self, value, rule, _, place):
        if isinstance(value, dict):
            for name in rule.keys() & value.keys():
                yield from self.errors(value[name], rule[name], f"{place}/{name}")

    def check_required(self, value, rule, _, place):
        if isinstance(value, dict):
            yield from (f"{place}: {name} is missing" for name in rule if name not in value)

    def check_additionalProperties(self, value, rule, schema, place):
        assert rule is False
        if isinstance(value, dict):
            yield from (f"{place}: {name} is not in the schema" for name in value if name not in schema["properties"])

    def check_items(self, value, rule, _, place):
        if isinstance(value, list):
            for i, item in enumerate(value):
                yield from self.errors(item, rule, f"{place}/{i}")

    def check_minItems(self, value, rule, _, place):
        if isinstance(value, list) and len(value) < rule:
            yield f"{place}: fewer than {rule} items"

    def check_maxItems(self, value, rule, _, place):
        if isinstance(value, list) and len(value) > rule:
            yield f"{place}: more than {rule} items"

    def check_minLength(self, value, rule, _, place):
        if isinstance(value, str) and len(value) < rule:
            yield f"{place}: shorter than {rule}"

    def check_pattern(self, value, rule, _, place):
        # In JSON schemas $ is nothing but the end; Python's also matches before a last line break.
        if isinstance(value, str) and not re.search(re.sub(r"\$$", r"\\Z", rule), value):
            yield f"{place}: {value!r} is not of the pattern"

    def check_maximum(self, value, rule, _, place):
        if has_type(value, "number") and value > rule:
            yield f"{place}: {value} is above {rule}"

    def check_minimum(self, value, rule, _, place):
        if has_type(value, "number") and value < rule:
            yield f"{place}: {value} is below {rule}"

    def check_exclusiveMinimum(self, value, rule, _, place):
        if has_type(value, "number") and value <= rule:
            yield f"{place}: {value} is not above {rule}"


def main(schema_file, *files):
    with open(schema_file, encoding="utf-8") as text:
        schema = json.load(text)
    found = []
    for file in files:
        with open(file, encoding="utf-8") as text:
            found += [f"{file}{error}" for error in Checker(schema).errors(json.load(text), schema)]
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
