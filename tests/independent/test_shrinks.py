#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The moment from which a polynomial radius shrinks: the command against Sturm's sequences in exact fractions.

The rates have single roots, roots of order two (where a radius stands still and grows on), and pairs so close that the radius shrinks for a
moment only. All coefficients are exact in doubles. The command is the one named by TDSP, else build/tdsp.
"""
import json
import pathlib
import random
import re
import sys
from fractions import Fraction

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "cli"))
sys.dont_write_bytecode = True
from harness import done, expect, expect_near, fails, main, test, write  # noqa: E402

SEED = 20264
SCALE = 2.0**-40  # keeps radii far from the journey, and changes no root
LAST = 900.0  # the last departure asked for
JOURNEY = 1e-3  # the time of the journey


def times(p, q):
    return [sum(p[i] * q[k - i] for i in range(len(p)) if 0 <= k - i < len(q)) for k in range(len(p) + len(q) - 1)]


def value(p, x):
    total = Fraction(0)
    for c in reversed(p):
        total = total * x + c
    return total


def remainder(a, b):
    a = list(a)
    while len(a) >= len(b):
        share = a[-1] / b[-1]
        for i, c in enumerate(b):
            a[len(a) - len(b) + i] -= share * c
        a.pop()
    while a and a[-1] == 0:
        a.pop()
    return a


def sturm(p):
    chain = [p, [k * c for k, c in enumerate(p)][1:]]
    while len(chain[-1]) > 1:
        rest = remainder(chain[-2], chain[-1])
        if not rest:
            break
        chain.append([-c for c in rest])
    return chain


def changes(chain, x):
    signs = [s for s in (value(p, x) for p in chain) if s != 0]
    return sum((a > 0) != (b > 0) for a, b in zip(signs, signs[1:]))


def roots_after_zero(p):
    """Intervals with one distinct root each, in order, to 2^-60 of themselves; no end of one is a root."""
    chain = sturm(p)
    high = 1 + max(abs(c / p[-1]) for c in p[:-1])
    stack, found = [(Fraction(0), high, changes(chain, Fraction(0)), changes(chain, high))], []
    while stack:
        low, high, left, right = stack.pop()
        if left == right:
            continue
        if left - right == 1 and (high - low) * 2**60 < high:
            found.append((low, high))
            continue
        middle = low + (high - low) * Fraction(1, 2)
        while value(p, middle) == 0:
            middle -= (high - low) / 1001
        between = changes(chain, middle)
        stack += [(middle, high, between, right), (low, middle, left, between)]
    return found


def shrinks_from(rate):
    """Where the rate becomes negative first, None if nowhere. The lowest coefficient is positive."""
    for low, high in roots_after_zero(rate) if len(rate) > 1 else []:
        if value(rate, high) < 0:
            return float(high)
    return None


def draw_rate(chance):
    """Up to degree 7, whole coefficients, positive at 0: factors of distinct roots."""
    roots, rate = chance.sample(range(1, 12), 4), [Fraction(chance.randint(1, 5))]
    while True:
        root = roots.pop()
        single = [Fraction(2 * root + 1), Fraction(-2)]
        square = times([Fraction(root), Fraction(-1)], [Fraction(root), Fraction(-1)])
        pair = [2**20 * c for c in square]
        pair[0] -= 1
        more = chance.choice([single, square, square, pair, [Fraction(root), Fraction(1)], [Fraction(root), Fraction(-1), Fraction(1)]])
        if len(rate) + len(more) > 9 or not roots:
            return rate
        rate = times(rate, more)


def coefficients(rate):
    """Of the radius, as doubles; 840 is a multiple of 1 to 8."""
    exact = [840 * c / (k + 1) for k, c in enumerate(rate)]
    doubles = [float(c) * SCALE for c in exact]
    return doubles if all(Fraction(float(c)) == c for c in exact) else None


def scene_of(values):
    return json.dumps({"robot": {"speed": 1e20 / JOURNEY}, "source": [0, 0], "destination": [1e20, 0],
                       "discs": [{"center": [0, 1e30], "radius": 1, "growth": values}]})


def moment(chance):
    """Check one polynomial; what it did."""
    rate = draw_rate(chance)
    values = coefficients(rate)
    if values is None or len(values) < 2:
        return "left out"
    file, expected = write("scene.json", scene_of(values)), shrinks_from(rate)
    if expected is None:
        done("arrive", file, LAST)
        return "never"
    done("arrive", file, max(expected * (1 - 1e-5) - JOURNEY, 0.0))
    said = fails(3, ["scene.json: discs[0].growth: the radius shrinks after t = ", "this question reaches beyond"], "arrive", file, LAST)
    expect_near(float(re.search(r"t = ([^,]*),", said.err)[1]), expected, 1e-9 * expected, json.dumps(values))
    return "later"


@test
def a_radius_shrinks_when_exact_arithmetic_says_so():
    print(f"# seed {SEED}")
    chance = random.Random(SEED)
    kinds = [moment(chance) for _ in range(120)]
    count = {kind: kinds.count(kind) for kind in ("never", "later", "left out")}
    print(f"# {count}")
    expect(count["never"] > 20 and count["later"] > 40, count)


if __name__ == "__main__":
    main()
