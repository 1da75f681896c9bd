#!/usr/bin/env python3
"""apps/results.py and apps/expected.py: each kind of expectation passes and fails as it should, every measured name is looked
at, what is missing here is left out and said, and the expected.json of every case makes sense."""
import contextlib
import io
import json
import pathlib
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "apps"))
import expected as ex  # noqa: E402
import results  # noqa: E402

WHY = {"source": "theory"}


def good(entry, value):
    return not ex.complaints(WHY | entry, value)


class Promise(unittest.TestCase):
    def test_at_least(self):
        self.assertTrue(good({"at_least": 2.0}, 2.0))
        self.assertTrue(good({"at_least": 2.0}, 1e9))
        self.assertFalse(good({"at_least": 2.0}, 1.999))

    def test_at_most(self):
        self.assertTrue(good({"at_most": 2.0}, 2.0))
        self.assertTrue(good({"at_most": 2.0}, -1e9))
        self.assertFalse(good({"at_most": 2.0}, 2.001))

    def test_between(self):
        for value, holds in ((0.99, False), (1.0, True), (1.5, True), (2.0, True), (2.01, False)):
            self.assertEqual(good({"between": [1.0, 2.0]}, value), holds, value)


class Reference(unittest.TestCase):
    def test_absolute_tolerance(self):
        for value, holds in ((9.89, False), (9.91, True), (10.09, True), (10.11, False)):
            self.assertEqual(good({"value": 10.0, "tolerance": 0.1}, value), holds, value)

    def test_relative_tolerance_of_a_negative_value(self):
        for value, holds in ((-10.11, False), (-10.09, True), (-9.91, True), (-9.89, False)):
            self.assertEqual(good({"value": -10.0, "relative_tolerance": 0.01}, value), holds, value)

    def test_exact(self):
        self.assertTrue(good({"value": 236, "tolerance": 0}, 236))
        self.assertFalse(good({"value": 236, "tolerance": 0}, 237))


class Record(unittest.TestCase):
    def test_moves_within_its_share_only(self):
        for value, holds in ((1.98, False), (1.995, True), (2.005, True), (2.02, False)):
            self.assertEqual(good({"measured": 2.0, "within": 0.005}, value), holds, value)

    def test_has_a_share_where_none_is_given(self):
        self.assertTrue(good({"measured": 2.0}, 2.0 * (1.0 + 0.9 * ex.WITHIN)))
        self.assertFalse(good({"measured": 2.0}, 2.0 * (1.0 + 1.1 * ex.WITHIN)))

    def test_zero_and_negative(self):
        self.assertTrue(good({"measured": 0}, 0))
        self.assertFalse(good({"measured": 0}, 1))
        self.assertTrue(good({"measured": -2.0, "within": 0.01}, -2.01))
        self.assertFalse(good({"measured": -2.0, "within": 0.01}, -2.03))

    def test_what_is_only_shown_may_move(self):
        self.assertTrue(good({"measured": 4e-15, "within": "any"}, 7e-13))
        self.assertFalse(good({"at_most": 1e-9, "measured": 4e-15, "within": "any"}, 2e-9))

    def test_a_loss_within_the_promise_is_seen(self):
        wrong = ex.complaints(WHY | {"at_most": 80, "measured": 50, "within": 0.01}, 60)
        self.assertEqual(len(wrong), 1)
        self.assertIn("moved by +20 %", wrong[0])
        self.assertIn("renew", wrong[0])

    def test_a_gain_is_seen(self):
        for kind, value in (("at_most", 40), ("at_least", 60)):
            limit = {"at_most": 80, "at_least": 20}[kind]
            self.assertIn("better by", ex.complaints(WHY | {kind: limit, "measured": 50}, value)[0])

    def test_broken_promise_and_move_are_both_said(self):
        self.assertEqual(len(ex.complaints(WHY | {"at_most": 80, "measured": 50}, 90)), 2)


class NoNumber(unittest.TestCase):
    def test_is_never_good(self):
        for value in (None, float("nan"), float("inf"), "text", True, [1.0]):
            for entry in ({"at_least": 0.0}, {"at_most": 2.0}, {"between": [0, 2]}, {"value": 1, "tolerance": 1}, {"measured": 1}):
                self.assertFalse(good(entry, value), (entry, value))


class Published(unittest.TestCase):
    def test_stands_beside_and_judges_nothing(self):
        entry = WHY | {"value": 44.07, "relative_tolerance": 0.005, "published": [44.5, 48.7]}
        self.assertEqual(ex.complaints(entry, 44.0), [])
        self.assertEqual(ex.beside(entry, 44.0), "published 44.5 to 48.7: outside by 1.1 %")
        self.assertEqual(ex.beside(entry, 45.0), "published 44.5 to 48.7: inside")
        self.assertEqual(ex.beside(WHY | {"measured": 90.0, "published": 100.0}, 90.0), "published 100: -10 %")
        self.assertEqual(ex.beside(WHY | {"at_most": 1}, 45.0), "")


class Faults(unittest.TestCase):
    def test_every_kind_makes_sense(self):
        for entry in ({"at_least": 1}, {"at_most": 1}, {"between": [1, 2]}, {"value": 1, "tolerance": 0.1},
                      {"value": 0, "tolerance": 9}, {"value": 1, "relative_tolerance": 0.1}, {"measured": 1},
                      {"measured": 1, "within": "any"}, {"at_most": 2, "measured": 1, "within": 0.1},
                      {"at_most": 2, "published": [1, 2]}, {"at_most": 2, "published": 3}):
            self.assertEqual(ex.fault(WHY | entry), "", entry)

    def test_what_makes_none_is_refused(self):
        for entry in ({}, {"at_least": 1, "at_most": 2}, {"at_least": 1, "value": 1, "tolerance": 0.1},
                      {"between": [2, 1]}, {"between": 2}, {"at_most": "much"}, {"value": 1},
                      {"value": 1, "tolerance": 0.1, "relative_tolerance": 0.1},
                      {"value": 1, "tolerance": -0.1}, {"at_most": 1, "tolerance": 0.1}, {"at_most": 1, "within": 0.1},
                      {"measured": None}, {"measured": 1, "within": -1}, {"measured": 1, "within": "some"},
                      {"at_most": 1, "published": "2"}, {"at_mots": 1}):
            self.assertNotEqual(ex.fault(WHY | entry), "", entry)
        self.assertIn("source", ex.fault({"at_most": 1}))

    def test_a_wide_band_is_no_reference(self):
        self.assertEqual(ex.fault(WHY | {"value": 2.0, "tolerance": 0.29}), "")
        for entry in ({"value": 2.0, "tolerance": 0.3}, {"value": -2.0, "tolerance": 0.3}, {"value": 2.0, "relative_tolerance": 0.15}):
            self.assertIn("say at_least", ex.fault(WHY | entry), entry)


class Renewed(unittest.TestCase):
    def test_writes_what_was_measured_and_nothing_else(self):
        entry = {"at_most": 80, "measured": 50, "within": 0.01, "source": "promise"}
        self.assertEqual(ex.renewed(entry, 60), entry | {"measured": 60})
        self.assertEqual(list(ex.renewed({"at_most": 80, "source": "promise"}, 1.0 / 3.0).items()),
                         [("at_most", 80), ("measured", 0.3333333), ("source", "promise")])

    def test_keeps_the_digits_of_what_did_not_move(self):
        entry = WHY | {"measured": 0.123}
        self.assertIs(ex.renewed(entry, 0.12300001), entry)

    def test_is_good_afterwards(self):
        for value in (1.0 / 3.0, -2e-7 / 3.0, 1e9 / 7.0, 0, 17):
            entry = ex.renewed(WHY | {"measured": 5.0}, value)
            self.assertEqual(ex.complaints(entry, value), [], value)


class Case(unittest.TestCase):
    """Cases in a scratch folder whose make.py writes what the test gives it."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = pathlib.Path(scratch.name)
        for name, value in (("ROOT", self.root), ("BUILD", self.root / "build")):
            self.addCleanup(setattr, results, name, getattr(results, name))
            setattr(results, name, value)

    def case(self, name, entries, measured, script="import pathlib; pathlib.Path('measured.json').write_text({!r})"):
        folder = self.root / "results" / name
        folder.mkdir(parents=True)
        (folder / "expected.json").write_text(json.dumps({key: WHY | entry for key, entry in entries.items()}), encoding="utf-8")
        (folder / "make.py").write_text(script.format(json.dumps(measured)), encoding="utf-8")
        return folder

    def said(self, *arguments):
        """(exit code, what was printed)."""
        out = io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
            code = results.main(list(arguments))
        return code, out.getvalue()

    def test_as_expected(self):
        self.case("one", {"a": {"at_most": 1}, "b": {"measured": 3.0}}, {"a": 0.5, "b": 3.0})
        code, text = self.said("compare", "one")
        self.assertEqual(code, 0, text)
        self.assertIn("1 of 1 cases as expected\n", text)

    def test_a_name_that_is_not_measured_fails(self):
        self.case("one", {"a": {"at_most": 1}, "b": {"at_most": 1}}, {"a": 0.5})
        code, text = self.said("compare", "one")
        self.assertEqual(code, 1)
        self.assertIn("FAIL: not measured", text)

    def test_a_name_that_is_not_expected_fails(self):
        for case, value in (("number", 7.0), ("text", "peer is not installed"), ("list", [7.0])):
            self.case(case, {"a": {"at_most": 1}}, {"a": 0.5, "new": value})
            code, text = self.said("compare", case)
            self.assertEqual(code, 1, case)
            self.assertIn("measured, but expected.json does not name it", text)

    def test_what_is_no_measurement_fails(self):
        self.case("one", {"a": {"at_most": 1}}, [0.5])
        code, text = self.said("compare", "one")
        self.assertEqual(code, 1)
        self.assertIn("neither figures nor a text", text)

    def test_a_program_that_is_missing_leaves_its_figures_out(self):
        self.case("peers", {"own": {"at_most": 1}, "theirs": {"at_most": 1}}, {"own": 0.5, "theirs": "peer is not installed"})
        code, text = self.said("compare", "all")
        self.assertEqual(code, 0, text)
        self.assertIn("1 of 1 cases as expected", text)
        self.assertIn("left out in part: peers (peer is not installed)", text)

    def test_what_is_left_out_does_not_hide_a_failure(self):
        self.case("peers", {"own": {"at_most": 1}, "theirs": {"at_most": 1}}, {"own": 2.0, "theirs": "peer is not installed"})
        self.assertEqual(self.said("compare", "all")[0], 1)

    def test_a_case_left_out_neither_passes_nor_fails(self):
        self.case("whole", {"a": {"at_most": 1}}, "test_stability is not built")
        self.case("each", {"a": {"at_most": 1}}, {"a": "peer is not installed"})
        self.case("here", {"a": {"at_most": 1}}, {"a": 0.5})
        code, text = self.said("compare", "all")
        self.assertEqual(code, 0, text)
        self.assertIn("1 of 3 cases as expected\n", text)
        self.assertIn("left out: whole (test_stability is not built)", text)
        self.assertIn("left out: each (peer is not installed)", text)

    def test_an_old_measurement_never_counts(self):
        folder = self.case("one", {"a": {"at_most": 1}}, {}, script="raise SystemExit(3)  # {}")
        (folder / "measured.json").write_text('{"a": 0.5}', encoding="utf-8")
        self.assertEqual(self.said("compare", "one")[0], 1)
        self.assertFalse((folder / "measured.json").exists())

    def test_an_entry_without_sense_fails_before_anything_is_played(self):
        folder = self.case("one", {"a": {"value": 1.0, "tolerance": 0.5}}, {"a": 1.0})
        code, text = self.said("compare", "one")
        self.assertEqual(code, 1)
        self.assertIn("say at_least", text)
        self.assertFalse((folder / "measured.json").exists())

    def test_renew_makes_the_last_compare_the_committed_figures(self):
        folder = self.case("one", {"a": {"at_most": 1, "measured": 0.25}, "b": {"at_most": 1}}, {"a": 0.5, "b": "peer is not installed"})
        self.assertEqual(self.said("compare", "one")[0], 1)
        self.assertEqual(self.said("renew", "one")[0], 0)
        written = json.loads((folder / "expected.json").read_text(encoding="utf-8"))
        self.assertEqual(written, {"a": WHY | {"at_most": 1, "measured": 0.5}, "b": WHY | {"at_most": 1}})
        self.assertEqual(self.said("compare", "one")[0], 0)

    def test_renew_does_not_mend_a_broken_promise(self):
        self.case("one", {"a": {"at_most": 1, "measured": 0.5}}, {"a": 2.0})
        self.said("compare", "one")
        self.said("renew", "one")
        self.assertEqual(self.said("compare", "one")[0], 1)

    def test_table_of_all(self):
        self.case("one", {"a": {"at_most": 1, "measured": 0.5}}, {"a": 2.0})
        self.case("two", {"b": {"between": [1, 2]}}, {"b": 1.5})
        self.said("compare", "one")
        self.assertEqual(self.said("table-all")[0], 0)
        table = (self.root / "results" / "TABLE.md").read_text(encoding="utf-8")
        self.assertIn("| one | a | <= 1 | 0.5 | 2 **promise broken; moved by +3e+02 %", table)
        self.assertIn("| two | b | 1 to 2 | - | - |", table)
        self.assertIn("2 figures of 2 cases; 1 figures of 1 cases measured in this clone, 1 of them not as expected.", table)

    def test_what_is_no_command_is_refused(self):
        for arguments in ((), ("compare",), ("table-all", "x"), ("cmp", "one")):
            self.assertEqual(self.said(*arguments)[0], 2, arguments)


class Here(unittest.TestCase):
    def test_every_case_has_expectations_that_make_sense(self):
        cases = results.all_cases()
        self.assertGreater(len(cases), 0)
        for case in cases:
            self.assertGreater(len(results.expectations(case)), 0, case.name)


if __name__ == "__main__":
    unittest.main()
