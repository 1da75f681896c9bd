"""What the figures of a case are expected to be, and whether measured ones are that. An entry of expected.json is one of

  {"at_most": 1.3, "source": "..."}                     a promise; also "at_least", or "between": [least, largest]
  {"value": 0.6, "tolerance": 0.01, "source": "..."}    a reference from theory or a publication and how near to it we must
                                                        come; "relative_tolerance" is a share of |value|
  {"measured": 1.0127, "source": "..."}                 a record: nothing is promised, but a change has to be noticed

Promises and references may carry "measured" as well: what was measured when the case was last committed. A figure that has
moved from it by more than "within" (a share of |measured|, WITHIN where it is left out) fails in either direction: a loss is
to be found, a gain to be kept, and "results.py renew" writes the new figure down. "within": "any" is for round-off and for
times of the machine of the day, which are shown and not compared.

"published": a number or [least, largest] is shown beside the figure and judges nothing, so that nobody needs to widen it.
"""
import math

WITHIN = 1e-3
WIDE = 0.15          # a band this wide, relative, says at_least, at_most or between
KINDS = ("at_least", "at_most", "between", "value")
OPTIONAL = {"measured", "within", "published", "source"}


def is_number(value):
    return isinstance(value, (int, float)) and not isinstance(value, bool) and math.isfinite(value)


def is_range(value):
    return isinstance(value, list) and len(value) == 2 and all(map(is_number, value)) and value[0] <= value[1]


def tolerance(entry):
    return entry["relative_tolerance"] * abs(entry["value"]) if "relative_tolerance" in entry else entry["tolerance"]


def band_fault(entry):
    """What is wrong with the tolerance of a reference, or nothing."""
    given = [key for key in ("tolerance", "relative_tolerance") if key in entry]
    if "value" not in entry:
        return "a tolerance without a value" if given else ""
    if len(given) != 1 or not is_number(entry[given[0]]) or entry[given[0]] < 0.0:
        return "a value needs one tolerance, zero or more"
    if entry["value"] != 0 and tolerance(entry) >= WIDE * abs(entry["value"]):
        return f"a band of {100 * WIDE:g} % or more is no reference: say at_least, at_most or between"
    return ""


def record_fault(entry):
    """What is wrong with what was measured before, or nothing."""
    if "measured" in entry and not is_number(entry["measured"]):
        return "measured is no number"
    if "within" in entry and "measured" not in entry:
        return "within without measured"
    within = entry.get("within", WITHIN)
    if within != "any" and not (is_number(within) and within >= 0.0):
        return "within is a share of measured, or \"any\""
    return ""


def fault(entry):
    """What is wrong with an entry of expected.json, in words; empty: nothing."""
    kinds = [key for key in KINDS if key in entry]
    unknown = sorted(set(entry) - OPTIONAL - {*KINDS, "tolerance", "relative_tolerance"})
    if unknown:
        return f"unknown: {', '.join(unknown)}"
    if len(kinds) > 1 or not kinds and "measured" not in entry:
        return f"one of {', '.join(KINDS)} is needed, or measured alone"
    if kinds and not (is_range if kinds == ["between"] else is_number)(entry[kinds[0]]):
        return f"{kinds[0]} is {'not [least, largest]' if kinds == ['between'] else 'no number'}"
    if not isinstance(entry.get("source"), str) or not entry["source"].strip():
        return "the source is missing"
    if "published" in entry and not (is_number(entry["published"]) or is_range(entry["published"])):
        return "published is neither a number nor [least, largest]"
    return band_fault(entry) or record_fault(entry)


def bounds(entry):
    """The least and the largest number that hold the promise or lie in the band of the reference."""
    if "value" in entry:
        return entry["value"] - tolerance(entry), entry["value"] + tolerance(entry)
    if "between" in entry:
        return tuple(entry["between"])
    return entry.get("at_least", -math.inf), entry.get("at_most", math.inf)


def in_words(entry):
    """What is expected, for tables."""
    if "value" in entry:
        return f"{entry['value']:.7g} +- {tolerance(entry):.2g}"
    if "between" in entry:
        return f"{entry['between'][0]:.7g} to {entry['between'][1]:.7g}"
    for key, word in (("at_least", ">="), ("at_most", "<=")):
        if key in entry:
            return f"{word} {entry[key]:.7g}"
    return "record"


def moved(entry, value):
    """By what share of the committed figure a figure has moved; None: no more than it may."""
    if "measured" not in entry or entry.get("within") == "any":
        return None
    before, within = entry["measured"], entry.get("within", WITHIN)
    if abs(value - before) <= within * abs(before):
        return None
    return (value - before) / abs(before) if before != 0 else math.copysign(math.inf, value)


def complaints(entry, value):
    """Why a measured number is not as expected, in words; empty: it is."""
    if not is_number(value):
        return ["not measured"]
    least, largest = bounds(entry)
    found = []
    if not least <= value <= largest:
        found.append("outside the band of its reference" if "value" in entry else "promise broken")
    share = moved(entry, value)
    if share is not None:
        better = "at_least" in entry and share > 0 or "at_most" in entry and share < 0
        found.append(f"{'better' if better else 'moved'} by {100 * share:+.2g} % since it was committed, "
                     f"{100 * entry.get('within', WITHIN):g} % allowed: find out why, then renew it")
    return found


def beside(entry, value):
    """Where the figure stands beside what was published, in words; empty where nothing is given."""
    if "published" not in entry or not is_number(value):
        return ""
    published = entry["published"]
    if is_number(published):
        return f"published {published:.7g}: {100 * (value - published) / abs(published):+.2g} %"
    least, largest = published
    text = f"published {least:.7g} to {largest:.7g}"
    if least <= value <= largest:
        return f"{text}: inside"
    edge = least if value < least else largest
    return f"{text}: outside by {100 * abs(value - edge) / abs(edge):.2g} %"


def renewed(entry, value):
    """The entry with the figure that was measured now; one that has not moved keeps its digits."""
    if "measured" in entry and moved(dict(entry, within=1e-6), value) is None:
        return entry
    digits = 3 if entry.get("within") == "any" else 7
    number = value if isinstance(value, int) else float(f"{value:.{digits}g}")
    fresh = {key: v for key, v in entry.items() if key not in ("measured", "within", "source")}
    fresh["measured"] = number
    return fresh | {key: entry[key] for key in ("within", "source") if key in entry}
