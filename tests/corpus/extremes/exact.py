# SPDX-License-Identifier: GPL-3.0-or-later
"""Polynomials over the rationals and their real roots, by Sturm's theorem: what make.py proves its answers
with. Shares nothing with kinex. A polynomial is a list of Fractions, low degree first, no leading zeros.
"""
from fractions import Fraction as F
from math import gcd as igcd, lcm


def trim(p):
    p = [F(c) for c in p]
    while p and p[-1] == 0:
        p.pop()
    return p


def add(p, q, factor=1):
    size = max(len(p), len(q))
    p, q = list(p) + [F(0)] * (size - len(p)), list(q) + [F(0)] * (size - len(q))
    return trim(a + factor * b for a, b in zip(p, q))


def sub(p, q):
    return add(p, q, -1)


def mul(*factors):
    result = [F(1)]
    for q in factors:
        product = [F(0)] * (len(result) + len(q) - 1)
        for i, a in enumerate(result):
            for j, b in enumerate(q):
                product[i + j] += a * b
        result = product
    return trim(result)


def power(p, n):
    return mul(*[p] * n)


def scaled(p, factor):
    return [c * factor for c in p]


def shifted(p, by):
    """p(t - by)"""
    result = []
    for c in reversed(p):
        result = add(mul(result, [-F(by), F(1)]) if result else [], [c])
    return trim(result)


def value(p, t):
    result = F(0)
    for c in reversed(p):
        result = result * t + c
    return result


def derivative(p):
    return trim(i * c for i, c in enumerate(p) if i)


def divide(p, q):
    p, quotient = list(p), [F(0)] * max(len(p) - len(q) + 1, 1)
    while len(p) >= len(q):
        c, at = p[-1] / q[-1], len(p) - len(q)
        quotient[at] = c
        for i, b in enumerate(q):
            p[at + i] -= c * b
        p = trim(p[:-1])
        if not p:
            break
    return trim(quotient), trim(p)


def monic(p):
    return [c / p[-1] for c in p]


def gcd(p, q):
    p, q = whole(p), whole(q)
    while q:
        p, q = q, Sturm.remainder(p, q) if len(p) >= len(q) else p
    return monic([F(c) for c in p])


def by_multiplicity(p):
    """Square-free factors and the multiplicity of their roots (Yun's algorithm)."""
    result, k = [], 1
    d = derivative(p)
    g = gcd(p, d)
    b, c = divide(p, g)[0], divide(d, g)[0]
    while len(b) > 1:
        rest = sub(c, derivative(b))
        a = gcd(b, rest) if rest else monic(b)
        if len(a) > 1:
            result.append((a, k))
        b, c = divide(b, a)[0], (divide(rest, a)[0] if rest else [])
        k += 1
    return result


def whole(p):
    """The coprime integers that are a positive multiple of p."""
    scale = lcm(*(c.denominator for c in p))
    c = [int(x * scale) for x in p]
    content = igcd(*c)
    return [x // content for x in c]


class Sturm:
    def __init__(self, p):
        self.sequence = [whole(p), whole(derivative(p))]
        while len(self.sequence[-1]) > 1:
            remainder = self.remainder(*self.sequence[-2:])
            if not remainder:
                break
            self.sequence.append(remainder)

    @staticmethod
    def remainder(p, q):
        """Minus the remainder of p by q, times a positive number."""
        p, lead, sign = list(p), abs(q[-1]), 1 if q[-1] > 0 else -1
        while len(p) >= len(q):
            c, at = p.pop() * sign, len(p) + 1 - len(q)
            p = [x * lead for x in p]
            for i, b in enumerate(q[:-1]):
                p[at + i] -= c * b
            while p and p[-1] == 0:
                p.pop()
        content = igcd(*p) if p else 1
        return [-x // content for x in p]

    def variations(self, t):
        signs = []
        for p in self.sequence:
            v, scale = 0, 1
            for c in reversed(p):
                v = v * t.numerator + c * scale
                scale *= t.denominator
            if v:
                signs.append(v > 0)
        return sum(a != b for a, b in zip(signs, signs[1:]))

    def count(self, a, b):
        """Distinct roots in (a, b]."""
        return self.variations(a) - self.variations(b)

    def count_all(self):
        def changes(signs):
            return sum(a != b for a, b in zip(signs, signs[1:]))
        return (changes([(p[-1] > 0) == (len(p) % 2 == 1) for p in self.sequence])
                - changes([p[-1] > 0 for p in self.sequence]))


class Root:
    """A root of a square-free polynomial in (lower, upper]; equal ends where it is rational."""

    def __init__(self, p, sturm, lower, upper, multiplicity):
        self.p, self.sturm, self.lower, self.upper = p, sturm, lower, upper
        self.multiplicity = multiplicity

    def refine(self):
        middle = (self.lower + self.upper) / 2
        if value(self.p, self.upper) == 0:
            self.lower = self.upper
        elif self.sturm.count(self.lower, middle) == 1:
            self.upper = middle
        else:
            self.lower = middle

    def settle(self):
        """Narrows the interval until a rational root of few digits has been found if it is one."""
        if len(self.p) == 2 and (self.p[0] / self.p[1]).denominator < 10**80:
            self.lower = self.upper = -self.p[0] / self.p[1]
        for _ in range(48):
            if self.lower == self.upper:
                return
            guess = ((self.lower + self.upper) / 2).limit_denominator(10**6)
            if self.lower < guess <= self.upper and value(self.p, guess) == 0:
                self.lower = self.upper = guess
            else:
                self.refine()


def roots(p, lower, upper):
    """All real roots in (lower, upper], in order."""
    found = []
    for factor, multiplicity in by_multiplicity(p):
        sturm = Sturm(factor)
        todo = [(F(lower), F(upper))]
        while todo:
            a, b = todo.pop()
            count = sturm.count(a, b)
            if count == 1:
                found.append(Root(factor, sturm, a, b, multiplicity))
            elif count > 1:
                todo += [(a, (a + b) / 2), ((a + b) / 2, b)]
    for root in found:
        root.settle()
    return separate(found)


def separate(found):
    """In order, with disjoint intervals; rational roots of few digits may be equal, others must differ."""
    for i, a in enumerate(found):
        for b in found[:i]:
            while not (a.upper < b.lower or b.upper < a.lower or a.lower == a.upper == b.lower == b.upper):
                a.refine(), b.refine()
    return sorted(found, key=lambda root: root.lower)
