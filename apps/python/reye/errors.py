"""Errors and warnings."""
import re
from typing import NamedTuple, Optional


class Issue(NamedTuple):
    """One error of the input.

    file, line  the scene file and the line, from 1; None where the error has no place in a file
    key         the key it belongs to, as in geo/REFERENCE.md: "material.steel.nu"
    value       its value as written; empty if the key itself is the fault
    rule        the rule that it breaks
    """

    file: Optional[str]
    line: Optional[int]
    key: str
    value: str
    rule: str


class InputError(ValueError):
    """Bad input: a scene, its geometry, a folder that may not be used. Nothing has been written.

    `issues` holds all errors at once, a tuple of `Issue`; the text has a line for each, as the command prints it. Keys that
    begin with "--" are arguments: "--out" is `out`.
    """

    def __init__(self, text, issues=()):
        super().__init__(text)
        self.issues = tuple(issues)


class RunError(RuntimeError):
    """A run failed. The text is the reason; `run` holds the results up to the last good state."""

    def __init__(self, reason, run):
        super().__init__(reason)
        self.run = run


class RunWarning(UserWarning):
    """What a reader of results must know before trusting them; it stands in the summary, too."""


def input_error(text, issues):
    """The error of a text with a line per issue; `issues`: of each its key, value, rule, and these three in words."""
    lines = text.split("\n")
    lines += [""] * (len(issues) - len(lines))
    return InputError(text, [_issue(line, *parts) for line, parts in zip(lines, issues)])


def _issue(line, key, value, rule, words):
    place = re.fullmatch(r"(.*):(\d+): ", line[:-len(words)] if words and line.endswith(words) else "", re.DOTALL)
    return Issue(place[1] if place else None, int(place[2]) if place else None, key, value, rule)
