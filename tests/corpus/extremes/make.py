#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes this folder: scenes, polynomials, and index.json, which says for each what is known about it.

    /usr/bin/python3 make.py           writes the files
    /usr/bin/python3 make.py --check   exit code 1 if they are not what it would write

Every answer is stated where its scene is made, with the reason in its "source"; where it follows from the
roots of polynomials, exact.py finds or confirms them. An entry of the index:

  name        stable; group/name
  file        a scene; or "polynomial", a file for `kinex roots`, whose scene is one object that moves by the
              polynomial and one at rest; or "crowd", a family of tests/extremes/crowds.h with its parameters
  time        of a polynomial's scene
  instants    [WHEN, EVENTS] for every instant with events of the first structure of the scene, in order
  events      instead, where only the sum is known
  roots       of a polynomial: [WHERE, MULTIPLICITY], all real ones
  final       a sorted list at the end; or "start": as it is right after the start; or "exchanged": the same
              with 2k and 2k+1 exchanged
  sturm       false: too large for it
  page        false: takes too long for the page of verdicts, because an arithmetic makes very many repairs

WHEN is "1/3 + 2^-80 - 1" (exact terms), "root 2 of -2 0 1 + 2^-80" (coefficients, low degree first), or
"between 1/3 and 1/2".
"""
import json
import pathlib
import sys
from fractions import Fraction as F

from exact import Sturm, add, by_multiplicity, mul, power, roots, scaled, separate, shifted, sub, value

HERE = pathlib.Path(__file__).parent
files, index = {}, []


def number(x):
    """As JSON: bare if short, else quoted; m e k where that is shorter."""
    x = F(x)
    if x.denominator == 1 and abs(x) < 2**53:
        return str(x.numerator)
    for exponent in (-300, -150, -18, -12, -9, 150, 300):
        mantissa = x / F(10)**exponent
        if mantissa.denominator == 1 and abs(mantissa) < 10**6:
            return f'"{mantissa.numerator}e{exponent}"'
    return f'"{x}"'


def coefficients(axes):
    return "[" + ", ".join("[" + ", ".join(map(number, p or [F(0)])) + "]" for p in axes) + "]"


def motion(axes_or_pieces):
    if isinstance(axes_or_pieces[0], tuple):
        return "[" + ",\n      ".join(f'{{"from": {number(a)}, "to": {number(b)}, "coordinates": '
                                      f"{coefficients(axes)}}}" for a, b, axes in axes_or_pieces) + "]"
    return coefficients(axes_or_pieces)


def entry(name, source, **known):
    item = {"name": name, **{k: v for k, v in known.items() if v is not None}, "source": source}
    index.append("{" + ", ".join(f"{json.dumps(k)}: {json.dumps(v)}" for k, v in item.items()) + "}")


def scene(name, objects, start, end, source, structure=None, **known):
    """objects: {id: one polynomial per axis, or pieces (from, to, axes)}"""
    first = next(iter(objects.values()))
    dimension = len(first[0][2]) if isinstance(first[0], tuple) else len(first)
    structure = structure or ("sorted_list" if dimension == 1 else "delaunay_2")
    body = ",\n".join(f'  {{"id": "{i}", "motion": {motion(m)}}}' for i, m in objects.items())
    files[name + ".json"] = (
        f'{{"kinex": 1, "name": "{name}", "dimension": {dimension}, "time": {{"start": {number(start)}, '
        f'"end": {number(end)}}},\n "objects": [\n{body}],\n "maintain": ["{structure}"]}}\n')
    entry(name, source, file=name + ".json", **known)


def text(root):
    if root.lower == root.upper:
        return str(root.lower)
    return f"between {root.lower} and {root.upper}"


def sorting(name, curves, start, end, source, instants=None):
    """Objects on a line: {id: polynomial}. Two change places at every root of odd multiplicity of their
    difference in (start, end]; so all events are known. Where the instants are given, only their number is
    looked at here."""
    ids = list(curves)
    meetings = []
    for i, a in enumerate(ids):
        for b in ids[i + 1:]:
            difference = sub(curves[a], curves[b])
            if len(difference) > 1:
                meetings += [r for r in roots(difference, start, end) if r.multiplicity % 2]
    if instants is None:
        instants = []
        for root in separate(meetings):
            if instants and instants[-1][0] == text(root):
                instants[-1][1] += 1
            else:
                instants.append([text(root), 1])
    assert sum(count for _, count in instants) == len(meetings), (name, len(meetings))
    at_end = {i: value(p, F(end)) for i, p in curves.items()}
    final = sorted(ids, key=lambda i: at_end[i])
    if len(set(at_end.values())) < len(ids):
        final = None
    scene(name, {i: [p] for i, p in curves.items()}, start, end, source, instants=instants, final=final)


def polynomial(name, p, start, end, source, known=None, sturm=None):
    """known: [WHERE, MULTIPLICITY]; confirmed by number, unless all roots are factors anyway."""
    if known is None or sum(m for _, m in known) < len(p) - 1:
        found = roots(p, start, end)
        assert len(found) == sum(Sturm(factor).count_all() for factor, _ in by_multiplicity(p)), name
        known = known if known is not None else [[text(r), r.multiplicity] for r in found]
        assert [m for _, m in known] == [r.multiplicity for r in found], (name, found)
    files[name + ".txt"] = f"# {source}\n{len(p) - 1} " + " ".join(map(str, p)) + "\n"
    entry(name, source, polynomial=name + ".txt", time=[str(start), str(end)], roots=known,
          instants=[[where, 1] for where, m in known if m % 2], sturm=sturm)


T = [F(0), F(1)]


def at(r, slope=1):
    return [-F(r) * slope, F(slope)]


def pair(curves, name, p, base):
    """Two objects whose difference is p, far from all others."""
    curves[name] = add([F(base)], p)
    curves[name + "-still"] = [F(base)]


# ---- close roots
SQRT2, QUINTIC = [F(-2), F(0), F(1)], [F(c) for c in (-1, -1, 0, 0, 0, 1)]
ONE_THIRD = at(F(1, 3))


def convergent(bits):
    """p/q < sqrt(2) with p^2 - 2 q^2 = -1 and 1 / (2 sqrt(2) q^2) about 2^-bits."""
    p, q = 1, 1
    while q * q < 2**(bits - 1):
        p, q = 3 * p + 4 * q, 2 * p + 3 * q
    return F(p, q)


for bits in (20, 53, 80, 200, 1000, None):
    gap = F(1, 2**bits) if bits else F(0)
    plus = f" + 2^-{bits}" if bits else ""
    label = str(bits) if bits else "equal"
    roots_at = ["1/3", "root 1 of -1 -1 0 0 0 1", "root 2 of -2 0 1"]
    distance = f"2^-{bits}" if bits else "0"
    # What comes later is written first: in arithmetics that see a tie the order is wrong.
    for kind, factors in (("equal", ([1], [1], [1])), ("different", ([5, 1], [3, 1], [1, 0, 1]))):
        curves, base = {}, 0
        for name, p, factor in zip(("third", "root2", "quintic"), (ONE_THIRD, SQRT2, QUINTIC), factors):
            pair(curves, name + "-late", mul(shifted(p, gap), [F(c) for c in factor]), base)
            pair(curves, name + "-early", p, base + 1000)
            base += 2000
        instants = []
        for where in roots_at:
            instants += [[where, 1], [where + plus, 1]] if bits else [[where, 2]]
        sorting(f"close/{kind}-degrees-{label}", curves, 0, 2,
                f"by construction: p(t) and p(t - {distance}){' times a factor without roots' if factors[0] != [1] else ''}",
                instants)
    if bits:
        c = convergent(bits)
        curves = {}
        pair(curves, "irrational", SQRT2, 0)
        pair(curves, "convergent", at(c), 1000)
        sorting(f"close/convergent-{label}", curves, 0, 2,
                f"sqrt(2) and p/q below it with p^2 - 2 q^2 = -1: about 2^-{bits} apart",
                [[str(c), 1], ["root 2 of -2 0 1", 1]])

for bits in (20, 53, 80, 200, 1000):
    e = F(1, 2**bits)
    polynomial(f"close/two-roots-{bits}", mul(at(F(1, 3)), at(F(1, 3) + e), [F(7), F(0), F(1)]), 0, 2,
               f"by construction: (t - 1/3)(t - 1/3 - 2^-{bits})(t^2 + 7)",
               [["1/3", 1], [f"1/3 + 2^-{bits}", 1]])
    polynomial(f"close/nearly-double-{bits}", sub(power(at(1), 2), [e * e]), 0, 2,
               f"by construction: (t - 1)^2 - 2^-{2 * bits}",
               [[f"1 - 2^-{bits}", 1], [f"1 + 2^-{bits}", 1]])
    polynomial(f"close/no-root-{bits}", add(power(at(1), 2), [e * e]), 0, 2,
               f"by construction: (t - 1)^2 + 2^-{2 * bits} has no real root", [])

# ---- notorious polynomials
for degree, a in ((4, 10**3), (8, 10**6), (12, 10**6), (20, 10**6)):
    p = sub([F(0)] * degree + [F(1)], scaled(power([F(-1), F(a)], 2), 2))
    polynomial(f"polynomials/mignotte-{degree}", p, -10**7, 10**7,
               f"Mignotte, Some useful bounds (1982): t^{degree} - 2 ({a} t - 1)^2 has two roots about "
               f"{a}^-{(degree + 2) // 2} apart; all roots by Sturm's theorem (exact.py)")
for degree, shift in ((10, 0), (20, F(1, 3)), (15, 2**30), (12, F(2**200, 3))):
    p = [F(1)]
    for i in range(1, degree + 1):
        p = mul(p, at(i + shift))
    polynomial(f"polynomials/wilkinson-{degree}" + ("" if shift == 0 else
                                                    "-third" if shift == F(1, 3) else
                                                    "-2^30" if shift == 2**30 else "-2^200-thirds"),
               p, shift, shift + degree + 1,
               f"Wilkinson, The evaluation of the zeros of ill-conditioned polynomials (1959), shifted: by "
               f"construction", [[str(shift + i), 1] for i in range(1, degree + 1)])
p = [F(1)]
for i in range(1, 21):
    p = mul(p, at(i))
p[19] -= F(1, 2**23)
polynomial("polynomials/wilkinson-20-perturbed", p, 0, 30,
           "Wilkinson 1959: with 2^-23 taken from the coefficient of t^19 ten real roots are left; "
           "by Sturm's theorem (exact.py)")
for degree in (8, 20, 30, 40):
    a, b = [F(1)], T
    for _ in range(degree - 1):
        a, b = b, sub(mul([F(0), F(2)], b), a)
    polynomial(f"polynomials/chebyshev-{degree}", b, -2, 2,
               f"T_{degree} has {degree} simple roots in (-1, 1); by Sturm's theorem (exact.py)")
polynomial("polynomials/double-and-triple", mul(power(at(1), 2), power(at(2), 3), power(SQRT2, 2),
                                                [F(-3), F(0), F(1)], [F(1), F(0), F(1)]), -4, 4,
           "by construction: (t - 1)^2 (t - 2)^3 (t^2 - 2)^2 (t^2 - 3)(t^2 + 1)",
           [["root 1 of -3 0 1", 1], ["root 1 of -2 0 1", 2], ["1", 2], ["root 2 of -2 0 1", 2],
            ["root 2 of -3 0 1", 1], ["2", 3]])
polynomial("polynomials/irrational-triple", power([F(-2), F(0), F(1)], 3), -4, 4,
           "by construction: (t^2 - 2)^3", [["root 1 of -2 0 1", 3], ["root 2 of -2 0 1", 3]])
polynomial("polynomials/high-multiplicity", mul(power(at(F(1, 3)), 9), power(at(F(1, 2)), 8)), 0, 1,
           "by construction: (t - 1/3)^9 (t - 1/2)^8", [["1/3", 9], ["1/2", 8]])
polynomial("polynomials/triple-beside-simple", mul(power(at(1), 3), at(1 + F(1, 2**80))), 0, 2,
           "by construction: (t - 1)^3 (t - 1 - 2^-80)", [["1", 3], ["1 + 2^-80", 1]])

# ---- big rationals
SEVEN = str(7**2400)


def digits(count, k):
    return int("1" + SEVEN[k * 37:k * 37 + count - 1])


numerators = sorted(F(digits(400, k), digits(400, k + 20)) for k in range(5))
p = [F(1)]
for r in numerators:
    p = mul(p, [-F(r.numerator), F(r.denominator)])
polynomial("big/digits-2000", p, 0, 12, "by construction: five roots with 400 digits above and below the line",
           [[str(r), 1] for r in numerators])
curves = {f"line{k}": [F(digits(2000, k), digits(1990, k + 3)), F(digits(2000, k + 7), digits(1995, k + 1))]
          for k in range(6)}
sorting("big/lines-2000", curves, -10**7, 10**7, "six lines with coefficients of 2,000 digits; all meetings by exact.py")
polynomial("big/degree-30-rationals", mul(*[at(F(k, 31)) for k in range(1, 31)]), 0, 1,
           "by construction: roots k/31, k = 1 .. 30", [[str(F(k, 31)), 1] for k in range(1, 31)])
p = mul(*[at(F(digits(8, k), digits(7, k + 9))) for k in range(30)])
polynomial("big/degree-30-digits", p, 0, 100, "by construction: thirty roots with 8 and 7 digits above and below the line",
           [[str(r), 1] for r in sorted(F(digits(8, k), digits(7, k + 9)) for k in range(30))], sturm=False)

# ---- scale
QUAD = {"east": ([F(1)], [F(0)]), "north": ([F(0)], [F(1)]), "west": ([F(-1)], [F(0)])}
FLIP = "three points of a circle and one that enters it from below: convex at all times, so one flip where it is on it"


def quad(name, south, start, end, source, instants, scale=1, shift=0, drift=0):
    """The three points and `south`, a curve (x, y), all scaled, shifted, and moving along (1, 1) at `drift`."""
    carry = lambda p: add(scaled(p, F(scale)), [F(shift), F(drift)])
    objects = {i: [carry(p) for p in axes] for i, axes in {**QUAD, "south": south}.items()}
    scene(name, objects, start, end, source + "; " + FLIP, instants=instants)


LINES = [(0, 3), (1, 1), (2, -1), (4, -2), (7, -7)]
for exponent in (-300, -150, 150, 300):
    s = F(10)**exponent
    sorting(f"scale/lines-1e{exponent}", {f"line{k}": [x * s, v * s] for k, (x, v) in enumerate(LINES)}, 0, 3,
            f"five lines times 1e{exponent}: the meetings are those of small integers")
    quad(f"scale/flip-1e{exponent}", ([F(0)], [F(-3, 2), F(1)]), 0, 1, f"the unit circle times 1e{exponent}",
         [["1/2", 1]], scale=s)
curves = {}
for k, exponent in enumerate((-300, -150, 0, 150, 300)):
    s = F(10)**exponent
    curves[f"at-1e{exponent}"] = [10 * s]
    curves[f"by-1e{exponent}"] = add([10 * s], scaled(at(F(k + 1, 7)), s))
sorting("scale/mixed-lines", curves, 0, 1, "by construction: pairs at 1e-300, 1e-150, 1, 1e150, 1e300 meet at k/7")
curves = {}
pair(curves, "thirds", ONE_THIRD, 0)
curves["huge"] = add([F(10)**6], scaled(ONE_THIRD, F(10)**300))
curves["tiny"] = [F(10)**6, F(1, 10**300)]
sorting("scale/one-certificate", curves, 0, 1,
        "1e300 (t - 1/3) meets 1e-300 t about 1e-601 after 1/3, at which a small pair meets; 1e-294 before they "
        "meet it passes that pair")
quad("scale/mixed-flip", ([F(0)], [F(-1) - F(1, 2 * 10**300), F(1, 10**300)]), 0, 1,
     "a circle of radius 1e150; the fourth point moves by 1e-150", [["1/2", 1]], scale=10**150)
for exponent in (-9, 12):
    s = F(10)**exponent
    sorting(f"scale/times-1e{exponent}", {f"line{k}": [F(x), v / s] for k, (x, v) in enumerate(LINES)}, 0, 3 * s,
            f"five lines, time times 1e{exponent}")
    quad(f"scale/flip-times-1e{exponent}", ([F(0)], [F(-3, 2), 1 / s]), 0, s,
         f"time times 1e{exponent}", [[str(s / 2), 1]])
for label, late in (("1e12", F(10)**12), ("2^30", F(2**30)), ("2^200", F(2**200))):
    sorting(f"scale/starts-at-{label}", {f"line{k}": add([F(x)], at(late, v)) for k, (x, v) in enumerate(LINES)},
            late, late + 3, f"five lines that start at t = {label}")
    sorting(f"scale/curves-start-at-{label}",
            {"circle": shifted(SQRT2, late), "rest": [F(0)], "far": shifted([F(90), F(1), F(1)], late)},
            late, late + 2, f"(t - {label})^2 - 2 and an object at rest",
            [[f"root 2 of -2 0 1 + {late}", 1]])
    quad(f"scale/flip-starts-at-{label}", ([F(0)], [F(-3, 2) - late, F(1)]), late, late + 1,
         f"starts at t = {label}", [[f"{late} + 1/2", 1]])
for exponent in (30, 200):
    shift = F(2**exponent)
    sorting(f"scale/shifted-2^{exponent}", {f"line{k}": [shift + x, F(v)] for k, (x, v) in enumerate(LINES)}, 0, 3,
            f"five lines, positions shifted by 2^{exponent}")
    quad(f"scale/flip-shifted-2^{exponent}", ([F(0)], [F(-3, 2), F(1)]), 0, 1,
         f"positions shifted by 2^{exponent}", [["1/2", 1]], shift=shift)
    quad(f"scale/flip-shifted-2^{exponent}-fast", ([F(0)], [F(-3, 2), F(1)]), 0, 1,
         f"all move at 2^{exponent}", [["1/2", 1]], drift=shift)
for exponent in (5, 12):
    horizon, creep = F(10)**exponent, F(1, 10**18)
    sorting(f"scale/near-parallel-1e{exponent}",
            {f"line{k}": [1 + F(x) * creep * horizon / 4, F(1) + v * creep] for k, (x, v) in enumerate(LINES)},
            0, horizon, f"velocities differ by 1e-18 of the positions; five meetings up to 1e{exponent}")
    quad(f"scale/near-parallel-flip-1e{exponent}", ([F(0)], [-1 - creep * horizon / 2, creep]), 0, horizon,
         "velocities differ by 1e-18 of the positions", [[str(horizon / 2), 1]], drift=1)

# ---- many events at one instant
for n in (2, 3, 10):
    sorting(f"together/pencil-{n}", {f"line{k}": at(F(1, 3), (7 * k) % n) for k in range(n)}, 0, 1,
            "lines through one point: all pairs change places there",
            [["1/3", n * (n - 1) // 2]])
    curves = {}
    for k in range(n):
        pair(curves, f"pair{k}", at(F(1, 2), k + 1), 100 * k)
    sorting(f"together/pairs-{n}", curves, 0, 1, "pairs that meet at 1/2, each at its own speed", [["1/2", n]])
    curves = {}
    for k in range(n):
        pair(curves, f"pair{k}", mul(SQRT2, [F(k + 1), F(0), F(1)]), 1000 * k)
    sorting(f"together/irrational-pairs-{n}", curves, 0, 2,
            "pairs that meet at sqrt(2), as roots of different polynomials of degree 4",
            [["root 2 of -2 0 1", n]])

for k in (100, 1000, 10000):
    entry(f"together/crowd-pairs-{k}", f"{k} pairs that meet at 1/2, each at its own speed", crowd=f"pairs k={k}",
          instants=[["1/2", k]])
    entry(f"together/crowd-curves-{k}", f"{k} pairs that meet at sqrt(2) and -sqrt(2), as roots of different polynomials",
          crowd=f"curves k={k}", instants=[["root 1 of -2 0 1", k], ["root 2 of -2 0 1", k]],
          sturm=None if k <= 100 else False)
for n in (15, 46, 142):
    entry(f"together/crowd-pencil-{n}", f"{n} lines through one point: n (n - 1) / 2 pairs", crowd=f"pencil n={n}",
          instants=[["1/3", n * (n - 1) // 2]])
for m in (11, 33, 101):
    entry(f"together/crowd-shear-{m}", f"a sheared {m} x {m} lattice, square at t = 1, where the shorter diagonal "
          f"of each of its {(m - 1)**2} cells changes; the hull keeps its points", crowd=f"shear m={m}",
          instants=[["1", (m - 1)**2]], sturm=None if m <= 33 else False)
for n in (8, 40, 200):
    half = n // 2
    rest = half * half // 2 - 2 * half
    entry(f"together/crowd-rings-{n}", f"two rings of {half} turn against each other by two right angles: between "
          "concentric circles the apex over an edge is the vertex nearest to its bisector, so a flip is the meeting "
          "of two bisectors; all meet at quarter turns, t = sqrt(2) - 1 and t = 1",
          crowd=f"counter-rotating-rings n={n}",
          **({"instants": [["root 2 of -1 2 1", half], ["1", half]]} if rest == 0 else
             {"events": half * half // 2}), sturm=None if n <= 40 else False,
          page=None if n <= 8 else False)
for n in (3, 10, 100, 1000):
    entry(f"together/crowd-expanding-{n}", "identically on one circle: nothing happens", crowd=f"expanding-circle n={n}",
          instants=[], final="start", page=None if n <= 10 else False)
for n in (4, 10, 100, 1000):
    entry(f"together/crowd-one-point-{n}", "all move through one point at 1/2: turned by two right angles there, "
          "and every certificate is a square times what it is elsewhere", crowd=f"through n={n}", instants=[],
          final="start", page=None if n <= 10 else False)
for n in (4, 10, 50):
    entry(f"together/crowd-line-{n}", "all on one line at 1/2, and reflected in it from then on: the edges are the same",
          crowd=f"reflection n={n}", final="start",
          page=None if n <= 10 else False)
for n in (4, 10, 100, 1000):
    entry(f"together/crowd-meet-{n}", "pairs that meet at 1/2: at 1 - t they have changed places",
          crowd=f"exchange n={n}", final="exchanged", sturm=None if n <= 100 else False,
          page=None if n <= 10 else False)
for m in (3, 10, 30):
    entry(f"together/crowd-lattice-{m}", f"all on a {m} x {m} lattice at t = 1, and back by the way they came",
          crowd=f"touching-lattice m={m}", final="start",
          sturm=None if m <= 10 else False, page=None if m <= 3 else False)

# ---- grazing: double roots, roots at the ends and at flight-plan updates
for label, where in (("before", F(-1)), ("at-the-start", F(0)), ("inside", F(1, 3)), ("at-the-end", F(1)),
                     ("after", F(2))):
    curves = {}
    pair(curves, "above", power(at(where), 2), 0)
    pair(curves, "below", scaled(power(at(where), 2), F(-1)), 100)
    pair(curves, "fourth", power(at(where), 4), 200)
    sorting(f"grazing/double-{label}", curves, 0, 1, f"touches at {where} and turns back: no event", [])
sorting("grazing/irrational", {"curve": power(SQRT2, 2), "rest": [F(0)]}, -2, 2, "(t^2 - 2)^2: no event", [])
sorting("grazing/irrational-triple", {"curve": power(SQRT2, 3), "rest": [F(0)]}, -2, 2,
        "(t^2 - 2)^3: one event at each root", [["root 1 of -2 0 1", 1], ["root 2 of -2 0 1", 1]])
sorting("grazing/touch-where-another-crosses", {"rest": [F(0)], "curve": power(at(F(1, 2)), 2), "line": at(F(1, 2))},
        0, 1, "at 1/2 the line passes both, which touch there", [["1/2", 2]])
for label, where in (("before", F(1, 8)), ("at", F(1, 4)), ("after", F(1, 2))):
    crossing = mul([F(-64)], at(F(1, 4)))
    sorting(f"grazing/born-{label}", {"rest": [F(0)], "curve": power(at(where), 2), "line": crossing}, 0, 1,
            f"the line leaves at 1/4; what touches at {where} becomes a certificate anew there")
sorting("grazing/root-at-the-start", {"rest": [F(0)], "line": T, "square": [F(0), F(0), F(1)]}, 0, 1,
        "all meet at the start; at the end t and t^2 meet and have changed places just after it", [["1", 1]])
sorting("grazing/root-at-the-end", {"rest": [F(0)], "line": at(1), "cube": power(at(1), 3), "square": power(at(1), 2)},
        0, 1, "all meet at the end: what changes sign there is an event, the squares are none")


def pieces(name, source, instants, **paths):
    scene(f"grazing/{name}", {i: [(a, b, [p]) for a, b, p in path] for i, path in paths.items()}, 0, 1, source,
          instants=instants)


HALF = F(1, 2)
REST = [(F(0), F(1), [F(0)])]
pieces("crosses-at-an-update", "passes at 1/2, where its motion changes", [["1/2", 1]],
       rest=REST, mover=[(F(0), HALF, at(HALF)), (HALF, F(1), at(HALF, 3))])
pieces("turns-at-an-update", "touches at 1/2, where its motion changes, and turns back: no event", [],
       rest=REST, mover=[(F(0), HALF, at(HALF)), (HALF, F(1), at(HALF, -1))])
pieces("turns-smoothly-at-an-update", "(t - 1/2)^2, then (t - 1/2)^3: touches and goes on above: no event", [],
       rest=REST, mover=[(F(0), HALF, power(at(HALF), 2)), (HALF, F(1), power(at(HALF), 3))])
pieces("both-change", "both change at 1/2, where they meet, and cross", [["1/2", 1]],
       other=[(F(0), HALF, at(HALF, -1)), (HALF, F(1), at(HALF, -2))],
       mover=[(F(0), HALF, at(HALF)), (HALF, F(1), power(at(HALF), 2))])
pieces("just-before-an-update", "passes 2^-200 before its motion changes, and again 2^-200 after it",
       [["1/2 - 2^-200", 1], ["1/2 + 2^-200", 1]], rest=REST,
       mover=[(F(0), HALF, at(HALF - F(1, 2**200))), (HALF, F(1), at(HALF + F(1, 2**200), -1))])
scene("grazing/circle-tangent", {**{i: list(a) for i, a in QUAD.items()}, "south": [at(HALF), [F(-1)]]}, 0, 1,
      "the fourth point moves along a tangent of the circle of the three others and touches it at 1/2: no flip",
      instants=[])
scene("grazing/edge-tangent", {"east": [[F(1)], [F(0)]], "west": [[F(-1)], [F(0)]], "top": [[F(0)], [F(2)]],
                               "mover": [at(HALF, F(1, 4)), power(at(HALF), 2)]}, 0, 1,
      "a point inside a triangle touches its edge at 1/2 and turns back: joined to all corners at all times",
      instants=[])
scene("grazing/edge-crossed", {"east": [[F(1)], [F(0)]], "west": [[F(-1)], [F(0)]], "top": [[F(0)], [F(2)]],
                               "mover": [[F(0)], at(HALF, -1)]}, 0, 1,
      "a point inside a triangle leaves through an edge at 1/2, and the circle of the corners at 1: first the edge goes, "
      "then it is there again", instants=[["1/2", 1], ["1", 1]])
scene("grazing/circle-at-the-start", {**{i: list(a) for i, a in QUAD.items()}, "south": [[F(0)], [F(-1), F(1, 2)]]}, 0, 1,
      "cocircular at the start, inside right after it: no flip", instants=[])
scene("grazing/circle-at-the-end", {**{i: list(a) for i, a in QUAD.items()}, "south": [[F(0)], [F(-3, 2), F(1, 2)]]}, 0, 1,
      "cocircular at the end, inside right after it: one flip", instants=[["1", 1]])
scene("grazing/circle-at-an-update", {**{i: [(F(0), F(1), list(a))] for i, a in QUAD.items()}, "south":
      [(F(0), HALF, [[F(0)], [F(-3, 2), F(1)]]), (HALF, F(1), [[F(0)], add([F(-1)], at(HALF, -1))])]}, 0, 1,
      "touches the circle at 1/2, where its motion changes, and turns back: no flip", instants=[])
scene("grazing/circle-crossed-at-an-update", {**{i: [(F(0), F(1), list(a))] for i, a in QUAD.items()}, "south":
      [(F(0), HALF, [[F(0)], [F(-3, 2), F(1)]]), (HALF, F(1), [[F(0)], add([F(-1)], at(HALF, F(1, 2)))])]}, 0, 1,
      "enters the circle at 1/2, where its motion changes: one flip", instants=[["1/2", 1]])

# ----
files["index.json"] = "[\n" + ",\n".join(index) + "\n]\n"


def main():
    names = [json.loads(line)["name"] for line in index]
    assert len(set(names)) == len(names), "a name is used twice"
    present = {str(path.relative_to(HERE)) for path in HERE.rglob("*") if path.suffix in (".json", ".txt")}
    if sys.argv[1:] == ["--check"]:
        wrong = sorted(name for name in present | set(files)
                       if name not in files or name not in present or (HERE / name).read_text() != files[name])
        for name in wrong:
            print(f"{HERE / name}: not what make.py writes; run it", file=sys.stderr)
        sys.exit(1 if wrong else 0)
    for name in present - set(files):
        (HERE / name).unlink()
    for name, content in files.items():
        (HERE / name).parent.mkdir(exist_ok=True)
        (HERE / name).write_text(content)
    print(f"{len(index)} entries, {len(files)} files, {sum(map(len, files.values()))} bytes")


main()
