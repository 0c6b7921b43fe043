#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
# Writes Gappa proofs of reciprocal_sqrt, one for each of the 256 segments of its table:
#   |value - (slope - curvature t) t - 1/sqrt(x)| < 0.77 2^-24, the two truncations and the last
#   rounding of the unit included.
# Usage: reciprocal_sqrt.py TABLE.h SEGMENT [BOUND in 2^-24]   (SEGMENT 0..255) -> standard output
# The polynomial's distance from 1/sqrt(x) is enclosed by exact rational bounds on a grid of its
# derivative; Gappa proves the roundings and adds it up.
import re
import sys
from fractions import Fraction
from math import isqrt


def table(path):
    words = re.findall(r"0x[0-9a-fA-F]+", open(path).read())
    if len(words) != 256:
        sys.exit(f"{path}: {len(words)} words instead of 256")
    return [int(w, 16) for w in words]


def root(x):  # 1/sqrt(x) within 2^-80, from below
    return Fraction(isqrt((1 << 160) * x.denominator * 1 // x.numerator), 1 << 80)


def gap(word, k, parts=16):
    """Enclosure of value - slope t + curvature t^2 - 1/sqrt(x) over the segment."""
    value, slope, curvature = (Fraction(c, 1 << 28) for c in
                               (word >> 34, word >> 13 & 0x1fffff, word & 0x1fff))
    width = Fraction(1, 128) if k < 128 else Fraction(1, 64)
    start = 1 + k * width if k < 128 else 2 + (k - 128) * width
    low, high = Fraction(10), Fraction(-10)
    # e(t) has |e''| <= M on a part: between samples it is off the chord by at most M h^2 / 8.
    second = abs(2 * curvature - Fraction(3, 4) * width ** 2 * root(start) ** 5) + \
        Fraction(3, 4) * width ** 2 * (root(start) ** 5 - root(start + width) ** 5) + Fraction(1, 1 << 40)
    slack = second / (8 * parts ** 2) + Fraction(1, 1 << 70)
    for i in range(parts + 1):
        t = Fraction(i, parts)
        e = value - slope * t + curvature * t * t - root(start + width * t)
        low, high = min(low, e - slack), max(high, e + slack)
    # t drops the bits of x below 2^-20 of the segment: 1/sqrt falls by at most slope 2^-20.
    return low - Fraction(1, 1 << 78), high + (slope + Fraction(1, 1 << 28)) / (1 << 20)


def decimal(q, down):
    scaled = q * 10 ** 20
    n = scaled.numerator // scaled.denominator
    return f"{n if down else n + 1}e-20"


def proof(word, k, bound):
    value, slope, curvature = word >> 34, word >> 13 & 0x1fffff, word & 0x1fff
    low, high = gap(word, k)
    return f"""# Segment {k} of kReciprocalSqrtTable; ReciprocalSqrt::kContract.max_error_ulp = 0.77.
# q: polynomial of the table less 1/sqrt(x), enclosed by proofs/reciprocal_sqrt.py.
@short = fixed<-14, dn>;      # t >> 6
@steep = fixed<-28, dn>;      # curvature (t >> 6) >> 14
t = fixed<-20, dn>(T);
product = steep({curvature}b-28 * short(t));
fine = {value}b-28 - ({slope}b-28 - product) * t;
mantissa = fixed<-24, nu>(fine);
polynomial = {value}b-28 - ({slope}b-28 - {curvature}b-28 * t) * t;
error = (mantissa - fine) + (fine - polynomial) + q;
{{ T in [0, 1] /\\ t in [0, 1] /\\ q in [{decimal(low, True)}, {decimal(high, False)}]
  -> error in [-{bound}b-24, {bound}b-24] }}
fine - polynomial -> (product - {curvature}b-28 * t) * t;
product - {curvature}b-28 * t -> (product - {curvature}b-28 * short(t)) + {curvature}b-28 * (short(t) - t);
"""


def text(word, k, ulps):
    limit = decimal(Fraction(ulps) / (1 << 24), True)
    return proof(word, k, "1").replace("[-1b-24, 1b-24]", f"[-{limit}, {limit}]")


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit("usage: reciprocal_sqrt.py TABLE.h SEGMENT [BOUND]")
    print(text(table(sys.argv[1])[int(sys.argv[2])], int(sys.argv[2]),
               sys.argv[3] if len(sys.argv) > 3 else "0.77"))
