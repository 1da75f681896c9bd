#!/usr/bin/env python3
"""Refuses stilted phrases in texts, comments, messages and docstrings, with file, line and what to write.

  words.py ROOT
"""
import pathlib
import re
import sys

SUFFIXES = {".md", ".hpp", ".cpp", ".py", ".sh", ".toml"}
PLACES = ("README.md", "CHANGELOG.md", "src", "apps", "geo", "results", "tests")

START = "\N{START OF TEXT}"  # stands before the first word of each comment
REFUSED = {  # regular expression, a space stands for any blanks and line breaks: what to write
    r"\bcan not\b": "cannot",
    r"\banew\b": "remesh, redraw, again",
    r"\b(tell|tells|telling|told)\b": "report, give, say, decide",
    r"\b(go|goes|going|gone|went) on\b": "resume (a run), continue",
    r"\b(puts?|gets?|got) (\w+ ){0,3}wrong\b": "error",
    START + r"\s*the same\b": "name the thing: a comment does not lean on the one above it",
    r"\bno rigid motion can fake\b": "an objective (frame-indifferent) slip measure",
    r"\bstands? in its own equations\b": "wear is implicit: it enters the contact equations of its own increment",
    r"\bbooks? of volumes?\b|\bthe book\b": "ledger; removed volume is conserved exactly",
    r"\bdeformation \(not wear\) ruins\b": "if deformation rather than wear degrades the mesh",
    r"\binstability is not seen\b": "the estimate does not detect instabilities",
    r"\bplayed again\b": "repeated",
    r"\bwhat is left of the difference stands in\b": "the estimated error is written to",
    r"\bbroken off\b": "interrupted",
    r"\bdone ones stay untouched\b": "finished ones are not rerun",
    r"\bthat the tests see is itself under test\b": "the test suite itself is tested",
    r"\blost the contact that holds\b": "is unsupported",
    r"\bno status fits\b": "no consistent contact status exists",
    r"\b(that|which) there (is|are) not\b": "that does not exist",
    r"\bwhat happens in a block that may be refused\b": "buffers the records of a block until it is accepted",
}
PATTERNS = [(re.compile(pattern.replace(" ", r"\s+"), re.IGNORECASE), say) for pattern, say in REFUSED.items()]

# What a person reads of a source: comments and texts in quotes; everything else is code.
SLASHES = re.compile(r'//[^\n]*|"(?:[^"\\\n]|\\.)*"')
HASHES = re.compile(r'#[^\n]*|"""[\s\S]*?"""|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)*\'')


def blank(text, filler=" "):
    """As long and with the same line breaks."""
    return re.sub(r"[^\s]", filler, text)


def prose(text, part):
    """The text with code as bars and marks of comments as blanks; START where a comment begins."""
    out, end, last = [], 0, ""
    for found in part.finditer(text):
        between = text[end:found.start()]
        word = found.group()
        mark = re.match(r"///<|/{2,3}|#", word)
        if mark:
            goes_along = last == mark.group() and not between.strip() and between.count("\n") == 1
            out.append(between if goes_along else blank(between, "|"))
            out.append((" " if goes_along else START) + " " * (len(mark.group()) - 1) + word[len(mark.group()):])
        else:
            adjacent = end > 0 and not between.strip()
            out.append(between if adjacent else blank(between, "|"))
            out.append(" " + word[1:-1] + " " if len(word) > 1 else word)
        last = mark.group() if mark else ""
        end = found.end()
    return "".join(out)


def refused_in(path):
    text = path.read_text(encoding="utf-8", errors="replace")
    if path.suffix in (".hpp", ".cpp"):
        text = prose(text, SLASHES)
    elif path.suffix != ".md":
        text = prose(text, HASHES)
    for pattern, say in PATTERNS:
        for found in pattern.finditer(text):
            words = " ".join(found.group().replace(START, "").split())
            yield text.count("\n", 0, found.start()) + 1, words, say


def files(root):
    for place in PLACES:
        found = [root / place] if (root / place).is_file() else sorted((root / place).rglob("*"))
        yield from (f for f in found if f.suffix in SUFFIXES and f.is_file() and f.resolve() != pathlib.Path(__file__).resolve()
                    and not any(part.endswith(".out") for part in f.parts))


def main():
    root = pathlib.Path(sys.argv[1])
    count = 0
    for path in files(root):
        for line, words, say in sorted(refused_in(path)):
            print(f"{path.relative_to(root)}:{line}: \"{words}\": write {say}")
            count += 1
    print(f"{count} refused phrases")
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
