# SPDX-License-Identifier: GPL-3.0-or-later
"""Instants as kinex names them: real roots of integer polynomials, compared and refined exactly.

Standard library only. Coefficients are low degree first. kinex_results.py offers what is here to its users.
"""
import functools
from fractions import Fraction


def value_at(polynomial, t):
    """The exact value at a Fraction (or integer)."""
    result = Fraction(0)
    for coefficient in reversed(polynomial):
        result = result * t + coefficient
    return result


def _sign(number):
    return (number > 0) - (number < 0)


def _trimmed(polynomial):
    while len(polynomial) > 1 and polynomial[-1] == 0:
        polynomial = polynomial[:-1]
    return polynomial


def _remainder(a, b):
    a = [Fraction(c) for c in a]
    while len(a) >= len(b) and any(a):
        factor = a[-1] / b[-1]
        for k in range(len(b)):
            a[len(a) - len(b) + k] -= factor * b[k]
        a = _trimmed(a[:-1]) if len(a) > 1 else [Fraction(0)]
    return a


def greatest_common_divisor(a, b):
    """Of two polynomials, up to a factor; a constant if they have no root in common."""
    while any(b):
        a, b = b, _trimmed(_remainder(a, b))
    return a


@functools.total_ordering
class Instant:
    """One real root of a square-free polynomial, alone in [lower, upper].

    Equal ends: the instant is that rational number. Other ends are no roots of the polynomial.
    Comparisons are exact, with other instants and with numbers.
    """

    def __init__(self, polynomial, root, lower, upper):
        self.polynomial = [int(c) for c in polynomial]
        self.root = int(root)
        self.lower, self.upper = Fraction(lower), Fraction(upper)
        if self.upper < self.lower:
            raise ValueError(f"the interval [{lower}, {upper}] is empty; give its ends in order")

    @classmethod
    def from_log(cls, time):
        """From the "time" of a record. Raises ValueError where the log does not name instants."""
        if "polynomial" not in time:
            raise ValueError("the log does not name its instants; run kinex with --instants names (the default), "
                             "in an exact arithmetic")
        return cls(time["polynomial"], time["root"], *time["interval"])

    @property
    def is_rational(self):
        """True if it is known to be rational: then lower is its value."""
        return self.lower == self.upper

    def refine(self, bits):
        """The same instant in an interval of length 2^-bits or less, by bisection."""
        lower, upper = self.lower, self.upper
        most = Fraction(1, 2 ** bits) if bits >= 0 else Fraction(2 ** -bits)
        if upper - lower <= most:
            return self
        sign = _sign(value_at(self.polynomial, lower))
        while upper - lower > most:
            middle = (lower + upper) / 2
            there = _sign(value_at(self.polynomial, middle))
            if there == 0:
                lower = upper = middle
            elif there == sign:
                lower = middle
            else:
                upper = middle
        return Instant(self.polynomial, self.root, lower, upper)

    def __float__(self):
        instant = self
        for bits in range(64, 2200, 64):
            instant = instant.refine(bits)
            if float(instant.lower) == float(instant.upper):
                break
        return float(instant.lower)

    def decimal(self, digits):
        """With this many digits after the point, truncated towards zero."""
        instant, scale = self, 10 ** digits
        while True:
            low, high = int(instant.lower * scale), int(instant.upper * scale)
            if high == low + 1:  # the limit between the two decides
                if high > 0:
                    low = high if instant >= Fraction(high, scale) else low
                else:
                    low = low if instant <= Fraction(low, scale) else high
                break
            if low == high:
                break
            instant = instant.refine(instant._bits() + 8)
        sign = "-" if low < 0 else ""
        text = str(abs(low)).rjust(digits + 1, "0")
        return sign + (text[:-digits] + "." + text[-digits:] if digits else text)

    def _bits(self):
        width = self.upper - self.lower
        return 0 if width == 0 else max(0, width.denominator.bit_length() - width.numerator.bit_length())

    def _compare(self, other):
        if not isinstance(other, Instant):
            number = Fraction(other)
            other = Instant([-number.numerator, number.denominator], 1, number, number)
        a, b = self, other
        if a.is_rational and b.is_rational:
            return _sign(a.lower - b.lower)
        if a._is_same(b):
            return 0
        bits = max(a._bits(), b._bits())
        while not (a.upper < b.lower or b.upper < a.lower):
            bits += 16
            a, b = a.refine(bits), b.refine(bits)
            if a.is_rational and b.is_rational:
                return _sign(a.lower - b.lower)
        return -1 if a.upper < b.lower else 1

    def _is_same(self, other):
        if self.is_rational or other.is_rational:
            rational, root = (self, other) if self.is_rational else (other, self)
            return (root.lower <= rational.lower <= root.upper
                    and value_at(root.polynomial, rational.lower) == 0)
        lower, upper = max(self.lower, other.lower), min(self.upper, other.upper)
        if lower >= upper:
            return False
        common = greatest_common_divisor(self.polynomial, other.polynomial)
        # Ends are no roots; within an isolating interval there is one root at most.
        return len(common) > 1 and _sign(value_at(common, lower)) != _sign(value_at(common, upper))

    def __eq__(self, other):
        if not isinstance(other, (Instant, int, Fraction)):
            return NotImplemented
        return self._compare(other) == 0

    def __lt__(self, other):
        return self._compare(other) < 0

    def __le__(self, other):
        return self._compare(other) <= 0

    __hash__ = None  # equal instants may have different polynomials

    def __repr__(self):
        if self.is_rational:
            return f"Instant({self.lower})"
        return f"Instant(root {self.root} of {self.polynomial}, about {float(self):.12g})"
