#!/usr/bin/env python3
"""Puts the tables of scene keys, as `reye reference` prints them, between their markers in geo/REFERENCE.md, and what `reye schema`
prints into geo/scene.schema.json."""
import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent
COMMAND = pathlib.Path(os.environ.get("REYE_BUILD", ROOT / "build")) / "bin" / "reye"
TABLES = {"scene": [], "solid": ["--solid"], "scar": ["--scars"]}


def printed(*arguments):
    return subprocess.run([str(COMMAND), *arguments], check=True, capture_output=True, text=True).stdout


def with_table(text, name, options):
    """The page with a fresh table of this name."""
    begin, end = f"<!-- {name} reference: begin -->", f"<!-- {name} reference: end -->"
    table = printed("reference", *options)
    head, rest = text.split(begin)
    return f"{head}{begin}\n{table}{end}{rest.split(end)[1]}"


page = ROOT / "geo" / "REFERENCE.md"
text = page.read_text(encoding="utf-8")
for name, options in TABLES.items():
    text = with_table(text, name, options)
page.write_text(text, encoding="utf-8")
(ROOT / "geo" / "scene.schema.json").write_text(printed("schema"), encoding="utf-8")
