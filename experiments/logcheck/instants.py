# SPDX-License-Identifier: GPL-3.0-or-later
"""The instants of a log (level 1)."""

import re
from fractions import Fraction

import polynomials as poly
from log import Wrong, rational
from roots import Instant, compare, count_below, isolate_square_free

DECIMAL = re.compile(r"(-?)(0|[1-9]\d*)(?:\.(\d+))?(?:e(-?[1-9]\d*))?\Z")
DIGITS = 12  # significant ones
LEAST_PLAIN, MOST_PLAIN = -5, 11  # powers of ten that are written with a point


def read_instant(time, level):
    """The instant of a record in a log with names. Level 1 checks every part of it."""
    p = tuple(int(c) for c in time["polynomial"])
    a, b = (rational(end) for end in time["interval"])
    root = time["root"]
    if a == b:
        if p != (-a.numerator, a.denominator) or root != 1:
            raise Wrong("the rational instant %s has another name than root 1 of %s"
                        % (a, poly.text((-a.numerator, a.denominator))))
        x = Instant.rational(a.numerator, a.denominator)
    else:
        if a > b:
            raise Wrong("the interval's ends %s and %s are in the wrong order" % (a, b))
        for end in (a, b):
            if end.denominator & (end.denominator - 1):
                raise Wrong("the interval's end %s is not dyadic" % end)
        if p[-1] <= 0:
            raise Wrong("the leading coefficient of %s is not positive" % poly.text(p))
        k = max(a.denominator, b.denominator).bit_length() - 1
        low, high = int(a * 2**k), int(b * 2**k)
        signs = poly.sign_at_dyadic(p, low, k), poly.sign_at_dyadic(p, high, k)
        if signs[0] * signs[1] >= 0:
            raise Wrong("%s does not change its sign from %s to %s" % (poly.text(p), a, b))
        if level:
            check_name(p, low, high, k, root, a, b)
        x = Instant.root(p, low, high, k)
        if level:
            check_irrational(x)
    if level:
        check_decimal(time["decimal"], x)
    return x


def check_name(p, low, high, k, root, a, b):
    if poly.content(p) != 1:
        raise Wrong("%s is not primitive: %d divides it" % (poly.text(p), poly.content(p)))
    if not poly.is_square_free(p):
        raise Wrong("%s is not square-free" % poly.text(p))
    inside = len(isolate_square_free(p, low, high, k))
    if inside != 1:
        raise Wrong("%s has %d roots between %s and %s, not one" % (poly.text(p), inside, a, b))
    number = count_below(p, low, k) + 1
    if number != root:
        raise Wrong("the root of %s between %s and %s is number %d, not %d"
                    % (poly.text(p), a, b, number, root))


def check_irrational(x):
    """A rational root would be a multiple of 1 / (leading coefficient)."""
    lead = x.p[-1]
    y = Instant.root(x.p, x.a, x.b, x.k)
    while y.value is None and (y.b - y.a) * 2 * lead >= 1 << y.k:
        y.halve()
    if y.value is None:
        n = y.a * lead >> y.k
        for m in (n, n + 1):
            if y.a * lead < m << y.k < y.b * lead and poly.sign_at(y.p, m, lead) == 0:
                y = Instant.rational(m, lead)
                break
    if y.value is not None:
        raise Wrong("the instant is the rational number %s and has to be named so" % Fraction(*y.value))


def decimal_range(text):
    """The numbers that `text` is the decimal of, truncated towards zero: the two ends."""
    if text == "0":
        return Fraction(0), Fraction(0)
    match = DECIMAL.match(text)
    if match:
        sign, whole, part, power = match.groups()
        digits = (whole + (part or "")).lstrip("0")
        # The power of ten of the first digit.
        leading = int(power or 0) + (len(whole) if whole != "0" else len(digits) - len(part or "")) - 1
        plain = LEAST_PLAIN <= leading <= MOST_PLAIN
        scientific = power is not None and len(whole) == 1 and whole != "0"
        if len(digits) == DIGITS and (power is None if plain else scientific):
            unit = Fraction(10) ** (leading - DIGITS + 1)
            low = int(digits) * unit
            return (-low - unit, -low) if sign else (low, low + unit)
    raise Wrong("%s is not a decimal number of %d significant digits" % (text, DIGITS))


def check_decimal(text, x):
    """`text` is x, truncated towards zero."""
    low, high = decimal_range(text)
    ends = [Instant.rational(e.numerator, e.denominator) for e in (low, high)]
    below, above = compare(ends[0], x), compare(x, ends[1])
    inside = below < 0 and above <= 0 if low < 0 else below <= 0 and above < 0
    if not inside and not (low == high and below == above == 0):
        raise Wrong("the decimal %s is not the instant (about %r), truncated" % (text, x))


def read_instants(log, level, progress):
    """One instant per record; the same object for equal ones. Times must not decrease, whether level 1
    was asked for or not: everything else is read in this order."""
    result, last_time, last = [], None, None
    for r in log.records:
        if r.time == last_time:
            result.append(last)
            continue
        try:
            x = read_instant(r.time, level)
            if last is not None:
                order = compare(x, last)
                if order < 0:
                    raise Wrong("time goes back: from %r to %r" % (last, x))
                if order == 0:
                    x = last
        except Wrong as error:
            error.line = error.line or r.line
            raise
        result.append(x)
        last_time, last = r.time, x
        progress.show("level 1: record", len(result), len(log.records))
    return result


def check_intervals(log):
    """Level 1 for logs whose instants are only enclosed: intervals in order, decimals within."""
    latest = None
    for r in log.records:
        try:
            a, b = (rational(end) for end in r.time["interval"])
            if a > b:
                raise Wrong("the interval's ends %s and %s are in the wrong order" % (a, b))
            if latest is not None and b < latest:
                raise Wrong("time goes back: the instant is before %s, an earlier one is not" % latest)
            latest = a if latest is None else max(a, latest)
            low, high = decimal_range(r.time["decimal"])
            if high < a or b < low:
                raise Wrong("the decimal %s is outside of the interval" % r.time["decimal"])
        except Wrong as error:
            error.line = error.line or r.line
            raise
