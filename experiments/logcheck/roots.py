# SPDX-License-Identifier: GPL-3.0-or-later
"""Real roots of integer polynomials by Descartes' rule of signs and bisection (Vincent; Collins and
Akritas 1976), and instants: real algebraic numbers that can be compared.

An irrational instant is a square-free polynomial and an open interval with dyadic ends, at which the
polynomial has opposite signs and inside which it has no other root. A comparison refines the two intervals
by bisection; equality is decided by a greatest common divisor.
"""

from fractions import Fraction
from math import inf, nextafter

import polynomials as poly


class GaveUp(Exception):
    """A limit of this program, not an error in the log."""


MOST_BITS = 200000  # of an interval's ends


def double_below(numerator, denominator):
    try:
        return nextafter(numerator / denominator, -inf)
    except OverflowError:
        return -inf if numerator < 0 else 1.7e308


def double_above(numerator, denominator):
    try:
        return nextafter(numerator / denominator, inf)
    except OverflowError:
        return inf if numerator > 0 else -1.7e308


class Instant:
    """Rational: `value` = (numerator, denominator). Else `p` has one root between a / 2^k and b / 2^k."""

    __slots__ = ("value", "p", "a", "b", "k", "sign_a", "lo", "hi")

    @staticmethod
    def rational(numerator, denominator=1):
        x = Instant()
        if denominator != 1:
            f = Fraction(numerator, denominator)
            numerator, denominator = f.numerator, f.denominator
        x.value = (numerator, denominator)
        x.p = None
        x.lo = double_below(numerator, denominator)
        x.hi = double_above(numerator, denominator)
        return x

    @staticmethod
    def root(p, a, b, k):
        """The only root of p between a / 2^k and b / 2^k, where p is not zero."""
        x = Instant()
        x.value = None
        x.p, x.a, x.b, x.k = p, a, b, k
        x.sign_a = poly.sign_at_dyadic(p, a, k)
        x.enclose()
        return x

    def enclose(self):
        self.lo = double_below(self.a, 1 << self.k)
        self.hi = double_above(self.b, 1 << self.k)

    def halve(self):
        m = self.a + self.b
        sign = poly.sign_at_dyadic(self.p, m, self.k + 1)
        if sign == 0:
            # The number is m / 2^(k + 1) itself.
            f = Fraction(m, 1 << (self.k + 1))
            self.value, self.p = (f.numerator, f.denominator), None
            return
        if sign == self.sign_a:
            self.a, self.b = m, 2 * self.b
        else:
            self.a, self.b = 2 * self.a, m
        self.k += 1
        if self.k > MOST_BITS:
            raise GaveUp("a root was not told apart from another number within %d bits" % MOST_BITS)

    def refine(self, times):
        for _ in range(times):
            if self.value is None:
                self.halve()
        if self.value is None:
            self.enclose()
        else:
            self.lo, self.hi = double_below(*self.value), double_above(*self.value)

    def approximate(self):
        """For people."""
        if self.value is None and self.hi - self.lo > 1e-12 * max(1.0, abs(self.lo)):
            self.refine(60)
        return (self.lo + self.hi) / 2

    def __repr__(self):
        return "%.12g" % self.approximate()


def compare(x, y):
    """-1, 0, +1. Exact."""
    if x is y:
        return 0
    if x.hi < y.lo:
        return -1
    if y.hi < x.lo:
        return 1
    if x.value is not None:
        if y.value is not None:
            left, right = x.value[0] * y.value[1], y.value[0] * x.value[1]
            return (left > right) - (left < right)
        return -compare_root(y, x.value)
    if y.value is not None:
        return compare_root(x, y.value)
    return compare_roots(x, y)


def compare_root(x, value):
    """Compares an irrational number with a rational one."""
    n, d = value
    if n << x.k <= x.a * d:
        return 1
    if n << x.k >= x.b * d:
        return -1
    sign = poly.sign_at(x.p, n, d)
    if sign == 0:
        return 0
    return 1 if sign == x.sign_a else -1


def changes_sign_between(p, low, high):
    """low, high = (a, k): p has opposite signs at a / 2^k and there."""
    return poly.sign_at_dyadic(p, *low) * poly.sign_at_dyadic(p, *high) < 0


def compare_roots(x, y):
    checked = False
    step = 8
    while True:
        k = max(x.k, y.k)
        xa, xb = x.a << (k - x.k), x.b << (k - x.k)
        ya, yb = y.a << (k - y.k), y.b << (k - y.k)
        if xb <= ya:
            return -1
        if yb <= xa:
            return 1
        if not checked:
            checked = True
            low, high = (max(xa, ya), k), (min(xb, yb), k)
            # A common root of both is one root of each in the intersection.
            g = x.p if x.p == y.p else poly.common_divisor(x.p, y.p)
            if len(g) > 1 and changes_sign_between(g, low, high):
                return 0
        x.refine(step)
        y.refine(step)
        if x.value is not None or y.value is not None:
            return compare(x, y)
        step = min(2 * step, 512)


# ---- isolation


def mapped(p, a, width, k):
    """2^(k d) p((a + width x) / 2^k), whose roots in (0, 1) are those of p in the interval."""
    r = list(p)
    n = len(r)
    if k:
        for i in range(n):
            r[i] <<= k * (n - 1 - i)
    if a:
        for i in range(n - 1):
            for j in range(n - 2, i - 1, -1):
                r[j] += a * r[j + 1]
    if width != 1:
        power = 1
        for i in range(1, n):
            power *= width
            r[i] *= power
    return r


def roots_of_unit(q):
    """A bound on the number of roots of q in (0, 1), exact if it is 0 or 1."""
    return poly.variations(poly.shifted_by_one(q[::-1]))


class DyadicRoot(Exception):
    """A bisection point is a root."""


def isolate_square_free(p, a, b, k):
    """Roots of the square-free p strictly between a / 2^k and b / 2^k, ascending, as instants. p may be
    zero at the two ends."""
    if len(p) <= 1:
        return []
    if len(p) == 2:
        x = Instant.rational(-p[0], p[1]) if p[1] > 0 else Instant.rational(p[0], -p[1])
        n, d = x.value
        return [x] if a * d < n << k and n << k < b * d else []
    rational = []

    def deflate(numerator, exponent):
        nonlocal p
        f = Fraction(numerator, 1 << exponent)
        factor = (-f.numerator, f.denominator)
        p = poly.quotient(p, factor)
        return f

    for end in (a, b):
        if len(p) > 1 and poly.sign_at_dyadic(p, end, k) == 0:
            deflate(end, k)
    while True:
        found = []
        if len(p) <= 1:
            break
        try:
            bisect(p, mapped(p, a, b - a, k), a, b, k, found)
            break
        except DyadicRoot as root:
            f = deflate(*root.args)
            rational.append(Instant.rational(f.numerator, f.denominator))
    roots = [Instant.root(p, *interval) for interval in found]
    if rational:
        for r in rational:
            place = 0
            while place < len(roots) and compare(roots[place], r) < 0:
                place += 1
            roots.insert(place, r)
    return roots


def bisect(p, q, a, b, k, found):
    """Intervals with one root of p each; q is p, mapped to (0, 1)."""
    bound = roots_of_unit(q)
    if bound == 0:
        return
    if bound == 1:
        found.append((a, b, k))
        return
    if k > MOST_BITS:
        raise GaveUp("roots were not told apart within %d bits" % MOST_BITS)
    n = len(q)
    left = [c << (n - 1 - i) for i, c in enumerate(q)]
    right = poly.shifted_by_one(left)
    if right[0] == 0:
        raise DyadicRoot(a + b, k + 1)
    bisect(p, left, 2 * a, a + b, k + 1, found)
    bisect(p, right, a + b, 2 * b, k + 1, found)


def cauchy_exponent(p):
    """All real roots lie strictly between -2^e and 2^e."""
    lead = abs(p[-1]).bit_length() - 1
    most = max((abs(c) for c in p[:-1]), default=0).bit_length()
    return max(0, most - lead) + 1


def count_below(p, a, k):
    """The number of roots of the square-free p below a / 2^k, which is no root."""
    e = cauchy_exponent(p)
    if a <= -(1 << (e + k)):
        return 0
    return len(isolate_square_free(p, -(1 << (e + k)), a, k))


def all_roots(p, window):
    """The real roots of p in the window, each once."""
    if len(p) <= 1:
        return []
    free = poly.primitive(p)
    if len(p) > 2:
        free = poly.quotient(free, poly.common_divisor(p, poly.derivative(p)))
    if window is None:
        e = cauchy_exponent(free)
        window = (-(1 << e), 1 << e, 0)
    return isolate_square_free(free, *window)


class SignChanges:
    """The sign changes of a polynomial in a window, at its roots of odd multiplicity, and its touches of zero,
    at the others."""

    __slots__ = ("sign", "roots", "touches", "p")

    def __init__(self, p, window):
        self.p = p
        self.touches = []
        if not p:
            self.sign, self.roots = 0, []
            return
        if len(p) == 1:
            self.sign, self.roots = (1 if p[0] > 0 else -1), []
            return
        if len(p) == 2:
            self.sign = -1 if p[1] > 0 else 1
            x = (-p[0], p[1]) if p[1] > 0 else (p[0], -p[1])
            self.roots = [Instant.rational(*x)]
            return
        if window is None:
            e = cauchy_exponent(p)
            a, b, k = -(1 << e), 1 << e, 0
        else:
            a, b, k = window
        while (sign := poly.sign_at_dyadic(p, a, k)) == 0:
            a -= 1
        self.sign = sign
        q = mapped(p, a, b - a, k)
        if roots_of_unit(q) == 0:
            self.roots = []
            return
        roots = []
        for factor, multiplicity in poly.square_free_parts(p):
            into = roots if multiplicity % 2 else self.touches
            for r in isolate_square_free(factor, a, b, k):
                place = len(into)
                while place and compare(r, into[place - 1]) < 0:
                    place -= 1
                into.insert(place, r)
        self.roots = roots

    def after(self, x):
        """The sign right after x, an instant of the window."""
        if not self.roots:
            return self.sign
        i = self.first_after(x)
        return self.sign if i % 2 == 0 else -self.sign

    def before(self, x):
        """The sign right before x, an instant of the window."""
        i = sum(compare(r, x) < 0 for r in self.roots)
        return self.sign if i % 2 == 0 else -self.sign

    def first_after(self, x):
        """Index of the first sign change after x."""
        i = 0
        for r in self.roots:
            if compare(r, x) > 0:
                break
            i += 1
        return i

    def first_negative(self, x):
        """The first instant >= x right after which the polynomial is negative, or None."""
        if not self.roots:
            return x if self.sign < 0 else None
        i = self.first_after(x)
        if (self.sign if i % 2 == 0 else -self.sign) < 0:
            return x
        return self.roots[i] if i < len(self.roots) else None


def window_of(start, end):
    """Dyadic numbers a / 2^k < start and b / 2^k > end, for SignChanges."""
    if end is None:
        return None
    width, j = end - start, 0
    while width > 1 << 20:
        width /= 2
        j -= 1
    while width < 1:
        width *= 2
        j += 1
    unit = Fraction(1, 1 << j) if j >= 0 else Fraction(1 << -j)
    a, b = start // unit - 1, end // unit + 2
    if j < 0:
        a, b, j = a << -j, b << -j, 0
    return int(a), int(b), j
