#!/usr/bin/env python3
"""Includes of src/ as designed: a room includes itself and rooms before it, a floor of a room (a folder in it) itself and
floors before it, no file includes itself through others, a third-party library is named in the room that owns it alone, no
file has more than 300 lines.

  architecture.py SOURCE ROOM[/FLOOR...]...   rooms in their order, each with its floors in theirs
"""
import pathlib
import re
import sys

OWNERS = {"gmsh": {"cad"}, "dlfcn": {"cad"}, "CGAL/": {"mortar", "adapt"}, "vtk": {"cad", "output"}, "nlohmann": {"scene", "output"}, "cereal": {"output"},
          "toml": {"scene"}, "cholmod": {"algebra"}, "umfpack": {"algebra"}, "suitesparse": {"algebra"}, "Support>": {"algebra"},
          "mpi.h": {"algebra"}, "dmumps": {"algebra"}, "tbb/": {"base"}, "CLI/": {"apps"}, "muParser": {"wear"}, "boost/math": {"fit"}}
MOST_LINES = 300
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:"([^"]+)"|(<[^>]+>))', re.MULTILINE)


def unit(path):
    """A header and its source are one unit."""
    return path.rsplit(".", 1)[0]


def climbs(name, own, floors):
    """Whether a file includes one of a later floor of its own room."""
    (room, *here), (other, *there) = name.split("/"), own.split("/")
    order = floors[room]
    return room == other and here[0] in order and there[0] in order and order.index(there[0]) > order.index(here[0])


def circle(includes):
    """Units that include each other in turn, or nothing."""
    done = set()
    for start in includes:
        trail, pending = [], [(start, False)]
        while pending:
            here, leaving = pending.pop()
            if leaving:
                trail.pop()
                done.add(here)
            elif here in trail:
                return trail[trail.index(here):] + [here]
            elif here not in done:
                trail.append(here)
                pending.append((here, True))
                pending += [(other, False) for other in sorted(includes.get(here, ()))]
    return []


def main():
    source = pathlib.Path(sys.argv[1])
    floors = {room: rest for room, *rest in (given.split("/") for given in sys.argv[2:])}
    rooms = list(floors)
    failures, includes = [], {}
    for number, room in enumerate(rooms):
        for file in sorted((source / room).rglob("*.[ch]pp")):
            name = file.relative_to(source).as_posix()
            here = includes.setdefault(unit(name), set())
            text = file.read_text(encoding="utf-8")
            if (lines := text.count("\n")) > MOST_LINES:
                failures.append(f"{name}: {lines} lines, more than {MOST_LINES}")
            for own, library in INCLUDE.findall(text):
                if own and own.split("/")[0] not in rooms[:number + 1]:
                    failures.append(f"{name}: room '{room}' includes '{own}', which stands after it or is not written by its room")
                if own and climbs(name, own, floors):
                    failures.append(f"{name}: '{own}' stands on a floor after it")
                if own and unit(own) != unit(name):
                    here.add(unit(own))
                failures += [f"{name}: {library} is named only in {', '.join(sorted(owners))}"
                             for word, owners in OWNERS.items() if word in library and room not in owners]
    if around := circle(includes):
        failures.append("files include each other in turn: " + " -> ".join(around))
    sys.exit("\n".join(failures) if failures else print("rooms, files and libraries as designed"))


main()
