#!/usr/bin/env python3
"""The JSON Schema of scenes accepts every scene of the project, explains every key of the reference, and refuses a mistaken
key where `reye` refuses it: the keys that it names are among those that `reye check` names, the mistaken one included.

  schema_test.py REYE
"""
import copy
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import tomllib

try:
    import jsonschema
except ImportError:
    sys.exit(77)  # skipped

ROOT = pathlib.Path(__file__).resolve().parents[2]
REYE = sys.argv[1]
SCHEMA = json.loads((ROOT / "geo" / "scene.schema.json").read_text(encoding="utf-8"))
SCENES = sorted(path for folder in ("geo", "results", "tests") for path in (ROOT / folder).rglob("*.toml"))
MISTAKES_OF_A_KIND = 25


def key_of(path):
    """`step[0].cycles` of a path in a scene."""
    return "".join(f"[{part}]" if isinstance(part, int) else f".{part}" for part in path).removeprefix(".")


def keys_named(error):
    """The keys at which an error of the schema stands; an entry of a list of plain values counts as its list."""
    path = list(error.absolute_path)
    if error.validator == "additionalProperties":
        patterns = error.schema.get("patternProperties", {})
        return {key_of([*path, name]) for name in error.instance
                if name not in error.schema["properties"] and not any(re.search(p, name) for p in patterns)}
    if error.validator == "required":
        return {key_of([*path, name]) for name in error.validator_value if name not in error.instance}
    while path and isinstance(path[-1], int):
        path.pop()
    return {key_of(path)}


def refused_by_schema(scene):
    return set().union(*map(keys_named, jsonschema.Draft7Validator(SCHEMA).iter_errors(scene)))


def refused_by_reye(file):
    """The keys in its messages, `scene.toml:9: material.steel.nu = 0.5: must lie in (-1, 0.5)`."""
    done = subprocess.run([REYE, "check", str(file)], capture_output=True, text=True, check=False)
    if done.returncode not in (0, 2):
        sys.exit(f"reye check {file}: code {done.returncode}: {done.stderr}")
    return set(re.findall(r"scene\.toml:\d+: ([^ :]+)(?: = |: )", done.stderr)) if done.returncode == 2 else set()


def toml(value):
    """A value as TOML, tables inline."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(name)} = {toml(inner)}" for name, inner in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value, ensure_ascii=False) if isinstance(value, (str, bool)) else repr(value)


def rows(solid):
    """(pattern, what it takes, meaning) of every key of the reference."""
    command = [REYE, "reference", *(["--solid"] if solid else [])]
    lines = subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()[2:]
    cells = [line.strip("| ").split(" | ") for line in lines]
    return [(row[0].strip("`"), row[1], row[-1]) for row in cells]


def segments(pattern):
    """The names of a pattern, each as all that it stands for; `[]` and `[?]` are left out."""
    parts = [part.removesuffix("[]").removesuffix("[?]") for part in pattern.split(".")]
    return [spelt(part) for part in parts]


def spelt(part):
    """`{a,b}_c` as a_c, b_c."""
    found = re.fullmatch(r"\{(.*)\}(.*)", part)
    return [name + found[2] for name in found[1].split(",")] if found else [part]


def row_of(path, table):
    """The row of a value in a scene; None for entries of a list of numbers."""
    names = [part for part in path if not isinstance(part, int)]
    for pattern, takes, _ in table:
        parts = segments(pattern)
        if len(parts) == len(names) and all(part == ["*"] or name in part for part, name in zip(parts, names)):
            return parts, takes
    return None


def values(scene, path=()):
    """(path, value) of everything that is neither a table nor a list of tables."""
    if isinstance(scene, dict):
        for name, inner in scene.items():
            yield from values(inner, (*path, name))
    elif isinstance(scene, list) and scene and all(isinstance(inner, dict) for inner in scene):
        for i, inner in enumerate(scene):
            yield from values(inner, (*path, i))
    else:
        yield path, scene


def at(scene, path):
    for part in path:
        scene = scene[part]
    return scene


# A mistake changes a scene at a value, whose row of the reference is (segments, takes), and returns the mistaken key; None
# where such a mistake cannot be made there.

def misspelt(dice, scene, path, row):
    """A name of the grammar on the way to the value has a letter twice."""
    names = [i for i, part in enumerate(path) if not isinstance(part, int)]
    place = dice.choice([i for i, part in zip(names, row[0]) if part != ["*"]])
    table, name = at(scene, path[:place]), path[place]
    letter = dice.randrange(len(name))
    wrong = name[:letter] + name[letter] + name[letter:]
    table[wrong] = table.pop(name)
    return key_of([*path[:place], wrong])


def changed(scene, path, value):
    at(scene, path[:-1])[path[-1]] = value
    return key_of(path)


def of_wrong_type(dice, scene, path, row):
    others = [7.5, "yes"] if row[1] == "true, false" else [True, [[["a"]]]]
    return changed(scene, path, dice.choice(others))


def out_of_range(dice, scene, path, row):
    """A number beyond an end of its interval, or none that is whole; in a list its last number."""
    bad = [float(end) for end in re.findall(r" > (-?[\d.e+-]+)", row[1])]
    bad += [float(end) - 1.0 for end in re.findall(r" >= (-?[\d.e+-]+)", row[1])]
    for low, high in re.findall(r"in [(\[](\S+), (\S+)[)\]]", row[1]):
        bad += [float(low) - 0.1, float(high) + 0.1]
    bad += [2.5] if row[1].startswith("whole number") else []
    value = at(scene, path)
    if not bad or isinstance(value, str):
        return None
    if not isinstance(value, list):
        return changed(scene, path, dice.choice(bad))
    last = value[-1] if isinstance(value[-1], list) else value
    last[-1] = dice.choice(bad)
    return key_of(path)


def no_choice(dice, scene, path, row):
    value = at(scene, path)
    if row[1].startswith('"') and isinstance(value, str):
        return changed(scene, path, dice.choice(["none_of_these", value + "s", value.upper()]))
    return changed(scene, path, dice.choice([0, 3])) if row[1] == "1 or 2" else None


MISTAKES = (misspelt, of_wrong_type, out_of_range, no_choice)


def mistaken(dice, scenes, tables, mistake):
    """A random scene with one mistake at a random value, and the mistaken key."""
    while True:
        path = dice.choice(SCENES)
        scene = copy.deepcopy(scenes[path])
        table = tables[scene.get("analysis") == "solid"]
        place, _ = dice.choice(list(values(scene)))
        key = mistake(dice, scene, place, row_of(place, table))
        if key:
            return path, scene, key


def fault(scene, key, file):
    """Why the schema and `reye` disagree on a scene with a mistaken key; empty: they agree."""
    file.write_text("".join(f"{json.dumps(name)} = {toml(value)}\n" for name, value in scene.items()), encoding="utf-8")
    schema, reye = refused_by_schema(scene), refused_by_reye(file)
    if not schema and not reye:
        return "both accept it"
    if key not in schema or not schema <= reye:
        return f"the schema names {sorted(schema)}, reye {sorted(reye)}"
    return ""


def place_in(schema, parts):
    """The part of the schema where a key of the reference stands."""
    if not parts:
        return schema
    name, *rest = parts
    tables = [schema, schema.get("items", {})]
    inner = [table[kind].get(name) for table in tables for kind in ("properties", "patternProperties") if kind in table]
    inner += [own for table in tables if name == "*" for own in table.get("patternProperties", {}).values()]
    found = [place_in(schema, rest) for schema in inner if schema]
    return next(filter(None, found), None)


def unexplained(table, schema):
    """Keys of a table that the schema does not explain as the reference does."""
    for pattern, takes, meaning in table:
        for name in segments(pattern)[-1]:
            place = place_in(schema, [part[0] for part in segments(pattern)[:-1]] + [name])
            if place is None or not place["description"].startswith(f"{meaning}\n\n{takes}"):
                yield f"{pattern}: {name} is not in the schema, or explained otherwise"


def main():
    jsonschema.Draft7Validator.check_schema(SCHEMA)
    tables = {solid: rows(solid) for solid in (False, True)}
    scenes = {path: tomllib.loads(path.read_text(encoding="utf-8")) for path in SCENES}
    faults = [f"{path}: the schema refuses {sorted(keys)}" for path, scene in scenes.items() if (keys := refused_by_schema(scene))]
    for solid, name in ((False, "plane"), (True, "solid")):
        faults += unexplained(tables[solid], SCHEMA["definitions"][name])
    dice = random.Random(1860)
    with tempfile.TemporaryDirectory() as folder:
        for mistake in MISTAKES * MISTAKES_OF_A_KIND:
            path, scene, key = mistaken(dice, scenes, tables, mistake)
            if why := fault(scene, key, pathlib.Path(folder) / "scene.toml"):
                faults.append(f"{path.relative_to(ROOT)}, {key} {mistake.__name__}: {why}")
    sys.exit("\n".join(faults) if faults else
             print(f"{len(scenes)} scenes accepted, {len(MISTAKES) * MISTAKES_OF_A_KIND} mistakes refused at the mistaken key"))


main()
