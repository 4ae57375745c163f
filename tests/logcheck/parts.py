# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of kinex-logcheck by themselves: roots, instants, names, formulas, scenes, the command line.

usage: parts.py LOGCHECK_FOLDER
"""
import copy
import io
import json
import math
import pathlib
import random
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

import logs

FOLDER = sys.argv.pop(1)
logs.checker(FOLDER)
import instants  # noqa: E402
import labels  # noqa: E402
import polynomials as poly  # noqa: E402
import predicates  # noqa: E402
import progress  # noqa: E402
import roots  # noqa: E402
from log import Wrong  # noqa: E402
from scene import Extended, Scene  # noqa: E402

SCENE = logs.SCENE


def product(numbers):
    p = (1,)
    for r in numbers:
        p = poly.multiply(p, (-r.numerator, r.denominator))
    return p


class HowFar(unittest.TestCase):
    class Terminal(io.StringIO):
        def isatty(self):
            return True

    def told(self, file, wanted=False):
        shown = progress.Progress(wanted, file)
        for k in range(3):
            shown.last -= 3600
            shown.show("record", k, 3)
            shown.show("record", k, 3)  # too soon
        shown.wipe()
        return file.getvalue()

    def test_lines_elsewhere_if_they_are_wanted(self):
        self.assertEqual(self.told(io.StringIO()), "")
        text = "".join("kinex-logcheck: record %d of 3, 0 s\n" % k for k in range(3))
        self.assertEqual(self.told(io.StringIO(), wanted=True), text)

    def test_one_line_on_a_terminal(self):
        text = "".join("\r\033[Krecord %d of 3, 0 s" % k for k in range(3))
        self.assertEqual(self.told(self.Terminal()), text + "\r\033[K")


class Roots(unittest.TestCase):
    def test_known_roots_come_back(self):
        rng = random.Random(1)
        for _ in range(200):
            chosen = [Fraction(rng.randint(-30, 30), rng.randint(1, 8)) for _ in range(rng.randint(1, 6))]
            p = product(chosen)
            odd = sorted(r for r in set(chosen) if chosen.count(r) % 2)
            for window in (None, (-31, 31, 0)):
                found = roots.SignChanges(p, window)
                self.assertEqual(len(found.roots), len(odd))
                for x, r in zip(found.roots, odd):
                    self.assertEqual(roots.compare(x, roots.Instant.rational(r.numerator, r.denominator)), 0)
                self.assertEqual(len(roots.all_roots(p, window)), len(set(chosen)))
                for k in range(-61, 62):
                    sign = poly.sign_at(p, 101 * k + 1, 202)
                    self.assertEqual(found.after(roots.Instant.rational(101 * k + 1, 202)), sign)

    def test_equal_numbers_of_different_polynomials(self):
        p, q = (-2, 0, 1), poly.multiply((-2, 0, 1), (-3, 0, 1))
        a, b = roots.all_roots(p, None), roots.all_roots(q, None)
        self.assertEqual(roots.compare(a[1], b[2]), 0)
        self.assertEqual(roots.compare(a[1], b[3]), -1)
        self.assertEqual(roots.compare(a[0], b[2]), -1)

    def test_close_roots_are_told_apart(self):
        e = 1 << 300
        p = (1 - 2 * e, 0, 2 * e)  # just below 1
        x = roots.all_roots(p, None)[1]
        self.assertEqual(roots.compare(x, roots.Instant.rational(1)), -1)
        y = roots.all_roots((-2 * e - 1, 0, 2 * e), None)[1]
        self.assertEqual(roots.compare(x, y), -1)

    def test_square_free_parts(self):
        a, b = (-1, 1), (-2, 0, 1)
        p = poly.multiply(a, poly.multiply(b, b))
        self.assertEqual(sorted(poly.square_free_parts(p)), sorted([(a, 1), (b, 2)]))


class Names(unittest.TestCase):
    GOOD = {"polynomial": ["-2", "0", "1"], "root": 2, "interval": ["1", "2"], "decimal": "1.41421356237"}

    def refused(self, **changes):
        time = copy.deepcopy(self.GOOD)
        time.update(changes)
        with self.assertRaises(Wrong):
            instants.read_instant(time, True)

    def test_a_good_name(self):
        instants.read_instant(self.GOOD, True)
        instants.read_instant({"polynomial": ["1", "3"], "root": 1, "interval": ["-1/3", "-1/3"],
                               "decimal": "-0.333333333333"}, True)

    def test_decimals(self):
        for text in ("0.0000123456789012", "123456789012", "-9.99999999999e-6", "1.00000000000e12",
                     "4.50000000000e-320", "10.0000000000"):
            low, high = instants.decimal_range(text)
            self.assertIn(Fraction(text), (low, high))
            self.assertEqual(abs(high - low) * 10**11, Fraction(10) ** math.floor(math.log10(abs(Fraction(text)))))
        for text in ("0.00000123456789012", "1234567890123", "1.00000000000e11", "0.0", "-0", "01.0000000000",
                     "1.00000000000e012", "12.0000000000e20", "0.123456789012e20", "1e20", "", "1.00000000000 "):
            with self.assertRaises(Wrong):
                instants.decimal_range(text)

    def test_bad_names(self):
        self.refused(root=1)
        self.refused(interval=["-2", "2"], root=1)
        self.refused(interval=["2", "3"])
        self.refused(interval=["4/3", "3/2"])  # not dyadic
        self.refused(polynomial=["2", "0", "-1"])
        self.refused(polynomial=["-4", "0", "2"])
        self.refused(polynomial=["4", "0", "-4", "0", "1"])  # a square
        self.refused(polynomial=["-3", "0", "1"])  # another decimal
        self.refused(decimal="1.41421356238")
        self.refused(decimal="1.4142135623")
        self.refused(decimal="1.41421356237e0")
        self.refused(decimal="1.4142135623x")
        # Rational numbers under names that are not their own.
        self.refused(polynomial=["-9", "0", "4"], decimal="1.50000000000")
        self.refused(polynomial=["-3", "2"], decimal="1.50000000000", root=1)


class Formulas(unittest.TestCase):
    def value(self, name, *points):
        """The fourth number of a point and those after it are the extents there."""
        formula = predicates.formula_of(name)[0]
        on_lines = predicates.needs_unit(name)  # in the plane, and with the unit as last argument
        axes = 2 if on_lines else 3
        values = [Extended([(c,) if c else () for c in point], axes) for point in points]
        p = formula(values + [(1,)] if on_lines else values)
        return p[0] if p else 0

    def test_signs(self):
        self.assertGreater(self.value("line_side", (2, 1), (3, 8)), 0)  # above y = 2 x + 1
        self.assertLess(self.value("line_side", (2, 1), (3, 6)), 0)
        self.assertEqual(self.value("line_side", (2, 1), (3, 7)), 0)
        self.assertLess(self.value("line_under", (2, 1), (3, 8)), 0)
        self.assertLess(self.value("order_line_height", (1, 0), (0, 5), (0, 0), (0, -4)), 0)  # 5 and 4
        self.assertGreater(self.value("order_line_distance", (1, 0), (0, 5), (0, 0), (0, -4)), 0)  # sqrt(25/2) and 4
        self.assertEqual(self.value("order_line_distance", (7, 2), (1, 19), (1, 3), (4, 5)), 0)
        self.assertEqual(self.value("order_line_height/0101", (1, 0), (0, 5)), 0)
        self.assertGreater(self.value("order_line_distance/0102", (1, 0), (0, 5), (0, 6)), 0)
        self.assertGreater(self.value("order_x", (0, 5), (1, 0)), 0)
        self.assertLess(self.value("order_y", (0, 5), (1, 0)), 0)
        self.assertGreater(self.value(("order_direction", (Fraction(1, 2), Fraction(-1))), (0, 0), (0, -1)), 0)
        self.assertGreater(self.value("order_squared_distance", (1, 0), (3, 0), (0, 0)), 0)
        self.assertGreater(self.value("orientation_2", (0, 0), (1, 0), (0, 1)), 0)
        self.assertGreater(self.value("slope_order_2", (0, 0), (1, 0), (5, 5), (5, 6)), 0)
        self.assertGreater(self.value("in_circle_2", (0, 0), (2, 0), (0, 2), (1, 1)), 0)
        self.assertLess(self.value("in_circle_2", (0, 0), (2, 0), (0, 2), (3, 3)), 0)
        self.assertEqual(self.value("in_circle_2", (0, 0), (2, 0), (0, 2), (2, 2)), 0)

    def test_orders_of_boxes(self):
        u, v = (Fraction(1), Fraction(0)), (Fraction(3, 5), Fraction(4, 5))
        one = ((4, 0), (0, 0), (0, 1), (0, 0))  # 4 by 1
        other = ((3, 4), (0, 0), (-4, 3), (0, 0))  # 5 by 5
        for name, difference in (("order_box_area", 21), ("order_box_perimeter", 5)):
            scale = 25 if name == "order_box_area" else 5
            self.assertEqual(self.value((name, u, v), *one, *other), scale * difference)
            self.assertEqual(self.value((name, v, u), *other, *one), -scale * difference)

    def test_arguments_that_are_shared(self):
        self.assertEqual(predicates.places_of("order_box_area", 8), list(range(8)))
        self.assertEqual(predicates.places_of("order_box_area/01120312", 8), [0, 1, 1, 2, 0, 3, 1, 2])
        for name in ("order_box_area/0112031", "order_box_area/01120412", "order_box_area/", "order_box_area/1112031a"):
            self.assertIsNone(predicates.places_of(name, 8))

    def test_normal_forms_keep_the_value(self):
        rng = random.Random(2)
        places = [tuple(rng.randint(-9, 9) for _ in range(6)) for _ in range(12)]
        for name, (_, arity, _) in predicates.FORMULAS.items():
            for _ in range(40):
                ids = rng.sample(range(12), arity)
                normal, sign = predicates.normal_form(name, tuple(ids))
                self.assertEqual(self.value(name, *(places[i] for i in ids)),
                                 sign * self.value(name, *(places[i] for i in normal)), name)


class LabelsOfLists(unittest.TestCase):
    def test_room(self):
        some = labels.Labels()
        some.assign(["c", "a", "e"], 3)
        self.assertEqual(some.of, {"c": 0, "a": 2, "e": 5})
        self.assertEqual(some.room_between("e", "x", None), {"x": 7})
        self.assertEqual(some.room_between("c", "x", "a"), {"x": 1})
        some.of["x"] = 1
        self.assertIsNone(some.room_between("c", "y", "x"))  # too many for 8 labels
        some.assign(["c", "a", "e"], 4)
        some.of["x"] = 1
        self.assertEqual(some.room_between("c", "y", "x"), {"y": 1, "x": 2})  # the first four labels are spread
        some.assign(["a", "b"], labels.bits_for(2))
        self.assertIsNone(some.room_between("a", "x", "b"))


class CommandLine(unittest.TestCase):
    """A log written by hand: a overtakes b at t = 1."""

    HEADER = {"format": "kinex-log", "version": 2, "scene": "two", "arithmetic": "exact", "exact": True,
              "instants": "names", "build": "kinex 0",
              "structures": [{"label": "sorted_list", "structure": "sorted_list", "key": "x",
                              "kinds": ["swap", "tie", "motion", "insert", "erase", "settled", "rebuild"]}],
              "objects": ["a", "b"]}
    RECORD = {"structure": "sorted_list", "kind": "swap", "ids": ["a", "b"],
              "certificate": {"predicate": "order_x", "ids": ["a", "b"]}, "external": True,
              "time": {"polynomial": ["-1", "1"], "root": 1, "interval": ["1", "1"],
                       "decimal": "1.00000000000"}}
    LAST = {"end": "done", "reached": "2"}

    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self.scratch.cleanup)
        self.folder = pathlib.Path(self.scratch.name)
        self.scene = self.folder / "two.json"
        self.scene.write_text(json.dumps(SCENE))
        self.log = self.folder / "two.jsonl"

    def write(self, header=None, record=None, last=None, records=1):
        head = dict(self.HEADER, scene_hash=Scene("two", self.scene.read_text()).hash, **(header or {}))
        lines = [dict(copy.deepcopy(self.RECORD), **(record or {})) for _ in range(records)]
        for i, line in enumerate(lines):
            line["seq"] = i
        self.log.write_bytes(logs.sealed(head, lines, dict(self.LAST, **(last or {}))))

    def run_it(self, *more):
        done = subprocess.run([sys.executable, FOLDER, str(self.log), "--scene", str(self.scene), *more],
                              capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    def test_right(self):
        self.write()
        code, text = self.run_it()
        self.assertEqual(code, 0, text)
        self.assertEqual(text.count("  done  "), 6, text)
        self.assertIn(": 1 record\n", text)
        code, text = self.run_it("--json", "--levels", "0-2")
        self.assertEqual([level["done"] for level in json.loads(text)["levels"]], [True] * 3)

    def last_line(self, *more, scene=True):
        place = ["--scene", str(self.scene)] if scene else []
        done = subprocess.run([sys.executable, FOLDER, str(self.log), *place, *more], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done)
        return done.stdout.splitlines()[-1].removeprefix(str(self.log) + ": ")

    def test_the_last_line_says_what_was_not_done(self):
        self.write()
        self.assertEqual(self.last_line(), "nothing wrong")
        self.assertEqual(self.last_line("--levels", "0,2", scene=True), "nothing wrong")
        self.assertEqual(self.last_line(scene=False),
                         "levels 0 and 1: nothing wrong; levels 2 to 5 were not done: no scene was given")
        self.assertEqual(self.last_line("--levels", "1,3", scene=False),
                         "levels 0 and 1: nothing wrong; level 3 was not done: no scene was given")
        inexact = {"exact": False, "arithmetic": "double"}
        self.write(header=inexact, record={"time": {"decimal": "1.00000000000"}})
        self.assertEqual(self.last_line(), "level 0 (format): nothing wrong; levels 1 to 5 were not done: the "
                         "arithmetic double is not exact")
        self.assertEqual(self.last_line("--levels", "0"), "nothing wrong")
        self.write(header={"instants": "intervals"},
                   record={"time": {"interval": ["1", "1"], "decimal": "1.00000000000"}})
        self.assertEqual(self.last_line(), "levels 0 and 1: nothing wrong; levels 2 to 5 were not done: the log does "
                         "not name its instants")

    def of(self, *words, given=""):
        done = subprocess.run([sys.executable, FOLDER, *map(str, words)], capture_output=True, text=True, input=given)
        return done.returncode, done.stdout + done.stderr

    def test_levels(self):
        self.write()
        for levels, message in (("3-1", "3-1 holds no level; write 1-3"), ("9", "9: the levels are 0 to 5"),
                                ("0,4-7", "4-7: the levels are 0 to 5"), ("x", "levels are written 0-5, 3 or 0,2-4")):
            code, said = self.of(self.log, "--scene", self.scene, "--levels", levels)
            self.assertEqual(code, 2, said)
            self.assertIn("argument --levels: " + message, said)

    def test_files_that_are_something_else(self):
        self.write()
        for text in (json.dumps(SCENE), json.dumps(SCENE, indent=1)):  # without a last newline
            self.scene.write_text(text)
            for words in ((self.scene,), (self.scene, "--scene", self.scene)):
                code, said = self.of(*words)
                self.assertEqual(code, 2, said)
                self.assertIn("%s: this is a scene, not an event log; write kinex-logcheck LOG --scene" % self.scene,
                              said)
        code, said = self.of(self.log, "--scene", self.log)
        self.assertEqual(code, 2)
        self.assertIn("%s: this is an event log, not a scene; give the scene that was run" % self.log, said)
        for text in ("[1]", "{", "", "\n"):
            self.log.write_text(text)
            code, said = self.of(self.log)
            self.assertEqual(code, 2, said)
            self.assertIn("; give an event log, as kinex run SCENE --events LOG", said)

    def test_standard_input(self):
        self.write()
        code, said = self.of("-", "--scene", self.scene, given=self.log.read_text())
        self.assertEqual(code, 0, said)
        self.assertTrue(said.endswith("\n-: nothing wrong\n"), said)
        code, said = self.of(self.log, "--scene", "-", given=self.scene.read_text())
        self.assertEqual(code, 0, said)
        code, said = self.of("-", "--scene", "-", given=self.log.read_text())
        self.assertEqual(code, 2)
        self.assertIn("--scene: standard input is the log already; give the scene's file", said)

    def test_wrong(self):
        self.write(records=0)
        code, text = self.run_it()
        self.assertEqual(code, 1)
        self.assertIn("is negative right after 1", text)
        self.write(records=2)
        self.assertEqual(self.run_it()[0], 1)
        self.write(record={"ids": ["b", "a"]})
        self.assertEqual(self.run_it()[0], 1)
        self.write(record={"external": False})
        self.assertEqual(self.run_it()[0], 1)
        self.write(last={"reached": "1/2"})
        self.assertEqual(self.run_it()[0], 1)

    def test_a_run_that_stopped_is_judged_up_to_there(self):
        self.write(records=0, last={"reached": "1/2", "end": "limit"})
        code, text = self.run_it("--levels", "0-4")
        self.assertEqual(code, 0, text)

    def test_a_structure_that_became_corrupt(self):
        inexact = {"header": {"exact": False, "arithmetic": "double"}, "record": {"time": {"decimal": "1.00000000000"}}}
        text = "no end of repairs at one instant (at t = 1)"
        self.write(last={"corrupt": {"sorted_list": text}}, **inexact)
        code, said = self.run_it()
        self.assertEqual(code, 0, said)
        self.assertIn(": 1 record; sorted_list is corrupt: %s\n" % text, said)
        self.assertIn("; sorted_list is corrupt: " + text, json.loads(self.run_it("--json")[1])["levels"][0]["detail"])
        self.write(last={"corrupt": {"sorted_list": "\x1b[1m"}}, **inexact)
        self.assertIn("; sorted_list is corrupt: \\x1b[1m\n", self.run_it()[1])
        for corrupt in ({}, [], None, {"sorted_list": ""}, {"sorted_list": 1}, {"list": text}):
            self.write(last={"corrupt": corrupt}, **inexact)
            code, said = self.run_it()
            self.assertEqual(code, 1, said)
            self.assertIn("two.jsonl:3: corrupt ", said)
        self.write(last={"corrupt": {"sorted_list": text}})
        code, said = self.run_it()
        self.assertEqual(code, 1)
        self.assertIn("corrupt in an exact arithmetic", said)

    def test_a_broken_seal(self):
        self.write()
        self.log.write_text(self.log.read_text().replace('"kinex 0"', '"kinex 1"'))
        code, text = self.run_it()
        self.assertEqual(code, 1)
        self.assertIn("seal", text)

    def test_bad_input(self):
        self.write(header={"version": 1})
        code, text = self.run_it()
        self.assertEqual(code, 2)
        self.assertIn("run the scene again", text)
        self.log.write_text("hello\n")
        self.assertEqual(self.run_it()[0], 2)
        self.assertEqual(self.run_it("--levels", "7")[0], 2)
        self.write()
        self.scene.unlink()
        self.assertEqual(self.run_it()[0], 2)

    def test_messages_have_a_place_and_a_remedy(self):
        log_remedy = "give an event log, as kinex run SCENE --events LOG writes it"
        scene_remedy = "give the scene that was run, as kinex gen or kinex import writes it"
        for text, problem, remedy in (
                (None, ": No such file or directory; ", log_remedy), (b"", ": the file is empty; ", log_remedy),
                (b"hello\n", ": not JSON at line 1, column 1 (expecting value); ", log_remedy),
                (b"{}\n", ":1: not an event log of kinex; ", log_remedy), (b"\xff\n", ": not UTF-8 (byte 0); ", log_remedy)):
            self.log.unlink(missing_ok=True)
            if text is not None:
                self.log.write_bytes(text)
            self.assertEqual(self.run_it(), (2, "kinex-logcheck: %s%s%s\n" % (self.log, problem, remedy)))
        self.write()
        for text, problem in ((None, ": No such file or directory; "), (b"{\n", ": not JSON at line 2, column 1 (expecting "
                              "property name enclosed in double quotes); "), (b"[]", ": not a kinex scene of version 1; "),
                              (b"\xff", ": not UTF-8 (byte 0); ")):
            self.scene.unlink(missing_ok=True)
            if text is not None:
                self.scene.write_bytes(text)
            self.assertEqual(self.run_it(), (2, "kinex-logcheck: %s%s%s\n" % (self.scene, problem, scene_remedy)))

    def test_a_structure_without_a_replay_is_named(self):
        structure = dict(self.HEADER["structures"][0], structure="sorted_set")
        self.write(header={"structures": [structure]})
        code, text = self.run_it()
        self.assertEqual(code, 0, text)
        self.assertIn("sorted_list has no replay", text)

    def test_another_scene(self):
        self.write()
        self.scene.write_text(json.dumps(dict(SCENE, name="three")))
        code, text = self.run_it()
        self.assertEqual(code, 1)
        self.assertIn("another scene", text)
        self.assertTrue(text.endswith("; give the scene that was run, as kinex gen or kinex import writes it\n"), text)

    def test_a_wrong_log_has_a_remedy(self):
        self.write(records=0)
        self.assertIn("; run the scene again (kinex run SCENE --events LOG); a new log that is refused", self.run_it()[1])
        self.write()
        self.log.write_text("".join(self.log.read_text().splitlines(True)[:-1]))
        self.assertIn("it was cut; run the scene again (kinex run SCENE --events LOG); kinex log shows", self.run_it()[1])

    def test_a_scene_without_objects(self):
        def hash_of(*maintain):
            return Scene("x", json.dumps(dict(SCENE, objects=[], maintain=maintain))).hash

        self.assertEqual(hash_of({"structure": "sorted_list"}), hash_of("sorted_list"))

    def test_names_that_a_terminal_would_obey(self):
        self.log = self.folder / "no\x1b\n\x9b"
        code, text = self.run_it()
        self.assertEqual(code, 2)
        self.assertIn("no\\u001b\\n\\u009b", text)
        self.assertNotRegex(text[:-1], "[\x00-\x1f\x7f-\x9f]")

    def test_a_scene_of_two_objects_with_one_id(self):
        self.write()
        self.scene.write_text(json.dumps(dict(SCENE, objects=[SCENE["objects"][0]] * 2)))
        self.assertEqual(self.run_it(), (2, "kinex-logcheck: %s: two objects have one id; give one of them another: kinex "
                                         "check SCENE says which\n" % self.scene))


unittest.main()
