#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The constants of the library's own mathematics (src/base/math_*.c and a table of cosines), made from nothing but arithmetic. Python's standard library only.

    constants.py show           prints every table and polynomial as it stands in the sources
    constants.py check          holds the sources to that

Values come from series in decimal arithmetic of 80 digits. A polynomial passes through its function at the Chebyshev points of its interval, which is within a factor of two
of the best one of its degree, and its error there, relative to the whole function, is measured on a grid and printed. A part of a number in two pieces has so
many bits that the products and sums it is made for are exact.
"""
import fractions
import pathlib
import re
import sys
from decimal import Decimal, getcontext

getcontext().prec = 80
ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
ONE = Decimal(1)


# ---------------------------------------------------------------------------------------------------------- functions

def series(term, factor):
    """term + term * factor(1) + term * factor(1) * factor(2) + ..., until nothing is added."""
    total, i = term, 0
    while abs(term) > Decimal(10) ** -90:
        i += 1
        term *= factor(i)
        total += term
    return total


def sine(x):
    return series(x, lambda i: -x * x / (2 * i * (2 * i + 1)))


def cosine(x):
    return series(ONE, lambda i: -x * x / (2 * i * (2 * i - 1)))


def arctangent(x):
    """By three halvings of the angle and Euler's series."""
    for _ in range(3):
        x = x / (1 + (1 + x * x).sqrt())
    y = x * x / (1 + x * x)
    return 8 * series(y / x, lambda i: y * 2 * i / (2 * i + 1)) if x else Decimal(0)


PI = 4 * arctangent(ONE)
LN2 = Decimal(2).ln()


# --------------------------------------------------------------------------------------------------------------- bits

def nearest(x):
    """The double nearest to a decimal."""
    return float(fractions.Fraction(x))


def grid(x, bits):
    """A decimal to a multiple of 2^-bits."""
    return float(fractions.Fraction(round(fractions.Fraction(x) * 2**bits), 2**bits))


def rest(x, *parts):
    return x - sum(Decimal(part) for part in parts)


def hexadecimal(x):
    text = float(x).hex()
    return re.sub(r"\.?0*p", "p", text) if x else "0.0"


# --------------------------------------------------------------------------------------------------------- polynomials

def solve(rows):
    """Linear equations by elimination: each row its coefficients and the right side."""
    n = len(rows)
    for i in range(n):
        pivot = max(range(i, n), key=lambda r: abs(rows[r][i]))
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [value / rows[i][i] for value in rows[i]]
        for r in range(n):
            if r != i:
                rows[r] = [a - rows[r][i] * b for a, b in zip(rows[r], rows[i])]
    return [row[n] for row in rows]


def polynomial(function, low, high, count):
    """`count` coefficients, lowest first, as doubles: through the function at the Chebyshev points of [low, high]."""
    middle, half = (low + high) / 2, (high - low) / 2
    points = [middle + half * cosine(PI * (2 * i + 1) / (2 * count)) for i in range(count)]
    return [nearest(c) for c in solve([[point**k for k in range(count)] + [function(point)] for point in points])]


def worst(function, coefficients, low, high, weight):
    """The largest error of the polynomial times `weight` of its argument, in bits below one."""
    points = [low + (high - low) * (2 * i + 1) / 400 for i in range(200)]
    errors = [abs(weight(z) * (sum(Decimal(c) * z**k for k, c in enumerate(coefficients)) - function(z))) for z in points]
    return float(-max(errors).ln() / LN2)


def sine_part(z):
    """(sin r / r - 1) / z with z = r^2"""
    return series(-ONE / 6, lambda i: -z / ((2 * i + 2) * (2 * i + 3)))


def cosine_part(z):
    """(cos r - 1 + z / 2) / z^2"""
    return series(ONE / 24, lambda i: -z / ((2 * i + 3) * (2 * i + 4)))


def odd_fractions(z, sign):
    """1 / 3 + sign z / 5 + z^2 / 7 + sign z^3 / 9 + ..."""
    total, term, d = Decimal(0), ONE, 3
    while abs(term) > Decimal(10) ** -85:
        total, term, d = total + term / d, term * sign * z, d + 2
    return total


def arctangent_part(z):
    """(atan q / q - 1) / z with z = q^2"""
    return -odd_fractions(z, -1)


def logarithm_part(z):
    """(2 artanh s / s - 2) / z with z = s^2"""
    return 2 * odd_fractions(z, 1)


def exponential_part(r):
    """(exp r - 1 - r - r^2 / 2) / r^3"""
    return series(ONE / 6, lambda i: r / (i + 3))


def square(text):
    return Decimal(text) ** 2


POLYNOMIALS = {
    # name: (file, function, lowest argument, highest, coefficients, its share in the whole)
    "trig_sine": ("base/math_trig.c", sine_part, Decimal(0), square("0.26"), 5, lambda z: z),
    "trig_cosine": ("base/math_trig.c", cosine_part, Decimal(0), square("0.26"), 4, lambda z: z * z),
    "arc_near": ("base/math_arc.c", arctangent_part, Decimal(0), square("0.126"), 7, lambda z: z),
    "arc_step": ("base/math_arc.c", arctangent_part, Decimal(0), square("0.0079"), 3, lambda z: z),
    "log_near": ("base/math_log.c", logarithm_part, Decimal(0), square("0.0667"), 6, lambda z: z),
    "log_step": ("base/math_log.c", logarithm_part, Decimal(0), square("0.0057"), 3, lambda z: z),
    "exp_near": ("base/math_exp.c", exponential_part, Decimal("-0.1251"), Decimal("0.1251"), 8, lambda r: r * r),
    "exp_step": ("base/math_exp.c", exponential_part, Decimal("-0.0109"), Decimal("0.0109"), 4, lambda r: r**3),
}


# -------------------------------------------------------------------------------------------------------------- tables

def in_two(x, bits):
    """A number as a multiple of 2^-bits and the rest."""
    high = grid(x, bits)
    return high, nearest(rest(x, high))


def as_doubles(x):
    high = nearest(x)
    return high, nearest(rest(x, high))


def trig_table():
    """sin and cos of j / 32, j = 8 ... 25, each in two doubles."""
    return [[*as_doubles(sine(Decimal(j) / 32)), *as_doubles(cosine(Decimal(j) / 32))] for j in range(8, 26)]


def arc_table():
    """atan(j / 64), j = 8 ... 64, a multiple of 2^-48 and the rest."""
    return [list(in_two(arctangent(Decimal(j) / 64), 48)) for j in range(8, 65)]


def log_table():
    """ln(j / 64), j = 45 ... 90, a multiple of 2^-42 and the rest."""
    return [list(in_two((Decimal(j) / 64).ln(), 42)) for j in range(45, 91)]


def exp_table():
    """2^(j / 32), j = 0 ... 31, in two doubles, of which the first has 40 bits."""
    return [list(in_two((LN2 * j / 32).exp(), 39)) for j in range(32)]


def half_pi():
    """pi / 2 in three: 37 bits, 37 bits, the rest."""
    first = grid(PI / 2, 36)
    second = grid(rest(PI / 2, first), 73)
    return [[first], [second], [nearest(rest(PI / 2, first, second))]]


def arc_bases():
    """0, pi / 2 and pi, multiples of 2^-48 and the rest."""
    return [list(in_two(PI * k / 2, 48)) for k in range(3)]


def two_over_pi():
    """The bits of 2 / pi from 64 before the point on, 32 a word."""
    bits = int(fractions.Fraction(2 / long_pi()) * 2**1184)
    return [bits >> (1184 - 32 * i) & 0xffffffff for i in range(-1, 38)]


def long_pi():
    """pi with 400 digits: Machin's formula in whole numbers."""
    unit = 10**400

    def arc(n):
        total, term, k = 0, unit // n, 1
        while term:
            total += term // k if k % 4 == 1 else -(term // k)
            term, k = term // (n * n), k + 2
        return total
    return fractions.Fraction(4 * (4 * arc(5) - arc(239)), unit)


TABLES = {
    "trig_nodes": ("base/math_trig.c", trig_table),
    "trig_half_pi": ("base/math_trig.c", half_pi),
    "reduce_half_pi": ("base/math_reduce.c", lambda: [[x] for x in as_doubles(PI / 2)]),
    "arc_nodes": ("base/math_arc.c", arc_table),
    "arc_bases": ("base/math_arc.c", arc_bases),
    "log_nodes": ("base/math_log.c", log_table),
    "log_two": ("base/math_log.c", lambda: [[x] for x in in_two(LN2, 42)]),
    "exp_nodes": ("base/math_exp.c", exp_table),
    "shape_cosines": ("growth/shape.c", lambda: [[nearest(cosine(PI * k / 28)) if k != 14 else 0.0] for k in range(29)]),
    "exp_two": ("base/math_exp.c", lambda: [[x] for x in in_two(LN2 / 32, 42)]),
}


# --------------------------------------------------------------------------------------------------------------- main

def values():
    """(name, file, the numbers in their order) of everything."""
    for name, (path, function, low, high, count, _) in POLYNOMIALS.items():
        yield name, path, polynomial(function, low, high, count)
    for name, (path, make) in TABLES.items():
        yield name, path, [x for row in make() for x in row]
    yield "reduce_two_over_pi", "base/math_reduce.c", two_over_pi()


def show():
    for name, (_, function, low, high, count, weight) in POLYNOMIALS.items():
        print(f"{name}: error 2^-{worst(function, polynomial(function, low, high, count), low, high, weight):.1f}")
    for name, _, found in values():
        print(f"{name}[{len(found)}]: " + ", ".join(hex(x) if isinstance(x, int) else hexadecimal(x) for x in found))
    return 0


NUMBER = re.compile(r"(?<![\w.])-?(?:0x[0-9a-f.]+(?:p[-+]\d+)?|\d+\.\d+)")


def written(name, path):
    """The numbers between the braces of an array in a source; None when there is no such array."""
    text = (ROOT / "src" / path).read_text()
    found = re.search(rf"\b{name}(?:\[[^=]*\])? = \{{(.*?)\}};", text, re.S)
    words = NUMBER.findall(found.group(1)) if found else None
    return words and [int(w, 16) if w.startswith("0x") and "p" not in w else float.fromhex(w) if "x" in w else float(w) for w in words]


def check():
    bad = False
    for name, path, found in values():
        there = written(name, path)
        problem = "is not there" if there is None else f"has {len(there)} numbers, not {len(found)}" if len(there) != len(found) else next(
            (f"{i}: {a!r}, not {b!r}" for i, (a, b) in enumerate(zip(there, found)) if a != b), "")
        print(f"not ok constants {name} of {path}: {problem}" if problem else f"ok constants {name}: {len(found)} numbers")
        bad |= bool(problem)
    return int(bad)


if __name__ == "__main__":
    sys.exit(show() if sys.argv[1:] == ["show"] else check())
