#!/usr/bin/env python3
"""Puts the table of scene keys, as `reye reference` prints it, between its markers in geo/REFERENCE.md."""
import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent
BEGIN, END = "<!-- scene reference: begin -->", "<!-- scene reference: end -->"
COMMAND = pathlib.Path(os.environ.get("REYE_BUILD", ROOT / "build")) / "bin" / "reye"

page = ROOT / "geo" / "REFERENCE.md"
text = page.read_text(encoding="utf-8")
table = subprocess.run([str(COMMAND), "reference"], check=True, capture_output=True, text=True).stdout
head, rest = text.split(BEGIN)
tail = rest.split(END)[1]
page.write_text(f"{head}{BEGIN}\n{table}{END}{tail}", encoding="utf-8")
