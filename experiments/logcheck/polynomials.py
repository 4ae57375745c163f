# SPDX-License-Identifier: GPL-3.0-or-later
"""Polynomials with integer coefficients: tuples of ints, low degree first, no leading zeros; () is 0."""

from math import gcd


def trimmed(coefficients):
    n = len(coefficients)
    while n and coefficients[n - 1] == 0:
        n -= 1
    return tuple(coefficients[:n])


def content(p):
    c = 0
    for a in p:
        c = gcd(c, a)
        if c == 1:
            break
    return c


def primitive(p):
    """p over its content: the same sign everywhere."""
    c = content(p)
    return p if c in (0, 1) else tuple(a // c for a in p)


def add(p, q):
    if len(p) < len(q):
        p, q = q, p
    return trimmed([a + q[i] if i < len(q) else a for i, a in enumerate(p)])


def negated(p):
    return tuple(-a for a in p)


def subtract(p, q):
    n, m = len(p), len(q)
    return trimmed([(p[i] if i < n else 0) - (q[i] if i < m else 0) for i in range(max(n, m))])


def multiply(p, q):
    if not p or not q:
        return ()
    result = [0] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        if a:
            for j, b in enumerate(q):
                result[i + j] += a * b
    return tuple(result)


def scaled(p, factor):
    return p if factor == 1 else trimmed([a * factor for a in p])


def derivative(p):
    return tuple(i * a for i, a in enumerate(p))[1:]


def remainder(p, q):
    """A primitive multiple of the remainder of p by q; positive multiple for q with positive leading
    coefficient."""
    r = list(p)
    lead, n = q[-1], len(q)
    while len(r) >= n:
        top = r.pop()
        if top:
            shift = len(r) + 1 - n
            r = [a * lead for a in r]
            for i in range(n - 1):
                r[shift + i] -= top * q[i]
        else:
            continue
    return primitive(trimmed(r))


def common_divisor(p, q):
    """The greatest common divisor, primitive with positive leading coefficient."""
    p, q = primitive(p), primitive(q)
    if len(p) < len(q):
        p, q = q, p
    while q:
        if len(q) == 1:
            return (1,)
        p, q = q, remainder(p, q)
    return p if p[-1] > 0 else negated(p)


def quotient(p, q):
    """p / q for a primitive q that divides p (over the rationals, so over the integers)."""
    r = list(p)
    result = [0] * (len(p) - len(q) + 1)
    for shift in range(len(result) - 1, -1, -1):
        factor, left = divmod(r[shift + len(q) - 1], q[-1])
        if left:
            raise ArithmeticError("a division of polynomials that leaves a remainder")
        result[shift] = factor
        if factor:
            for i, b in enumerate(q):
                r[shift + i] -= factor * b
    if any(r):
        raise ArithmeticError("a division of polynomials that leaves a remainder")
    return tuple(result)


def square_free_parts(p):
    """[(factor, multiplicity)]: square-free, pairwise coprime factors whose powers make up the
    primitive p, but for its sign (Yun)."""
    p = primitive(p)
    d = derivative(p)
    g = common_divisor(p, d) if len(p) > 2 else (1,)
    if len(g) == 1:
        return [(p, 1)]
    parts, multiplicity = [], 1
    b, c = quotient(p, g), quotient(d, g)
    while len(b) > 1:
        d = subtract(c, derivative(b))
        a = common_divisor(b, d) if d else (b if b[-1] > 0 else negated(b))
        if len(a) > 1:
            parts.append((a, multiplicity))
        b = quotient(b, a)
        c = quotient(d, a) if d else ()
        multiplicity += 1
    return parts


def is_square_free(p):
    return len(p) <= 2 or len(common_divisor(p, derivative(p))) == 1


def sign_at(p, numerator, denominator):
    """Sign of p at a rational number; denominator > 0."""
    if not p:
        return 0
    value = p[-1]
    if denominator == 1:
        for a in p[-2::-1]:
            value = value * numerator + a
    else:
        power = 1
        for a in p[-2::-1]:
            power *= denominator
            value = value * numerator + a * power
    return (value > 0) - (value < 0)


def sign_at_dyadic(p, a, k):
    """Sign of p at a / 2^k, k >= 0."""
    if not p:
        return 0
    value, shift = p[-1], 0
    for c in p[-2::-1]:
        shift += k
        value = value * a + (c << shift)
    return (value > 0) - (value < 0)


def shifted_by_one(p):
    """p(x + 1)."""
    r = list(p)
    n = len(r)
    for i in range(n - 1):
        for j in range(n - 2, i - 1, -1):
            r[j] += r[j + 1]
    return r


def variations(p):
    """Sign changes in the coefficients."""
    count, last = 0, 0
    for a in p:
        if a:
            if last and (a > 0) != (last > 0):
                count += 1
            last = a
    return count


def text(p):
    """For messages, as in a log."""
    return "[" + ", ".join(map(str, p)) + "]"
