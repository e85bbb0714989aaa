"""Motions: each entry of a pose is a form in s = 1 - t and t, over a divisor that all twelve share.

A form of degree n is the list of the coefficients of s^n, s^(n-1) t, ..., t^n. Where all are positive, so is the form at all times from 0 to 1."""
from fractions import Fraction

from bodies import given_pose
from reading import given, need_form, vector


def added(*forms):
    return [sum(coefficients) for coefficients in zip(*forms)]


def product(f, g):
    result = [Fraction(0)] * (len(f) + len(g) - 1)
    for i, x in enumerate(f):
        for j, y in enumerate(g):
            result[i + j] += x * y
    return result


def raised(f, size):
    """A form with `size` coefficients, which is f at all times, since s + t = 1."""
    return raised(product(f, [1, 1]), size) if len(f) < size else f


def over(f, first, last):
    """The form whose times from 0 to 1 are those of f from first to last."""
    found, power = f[-1:], [1]
    for coefficient in f[-2::-1]:
        power = product(power, [1 - first, 1 - last])
        found = added(product(found, [first, last]), [coefficient * x for x in power])
    return found


def line(start, end):
    """The motion between two poses in which each corner moves on a line: the forms, and their divisor."""
    return [list(ends) for ends in zip(start, end)], [Fraction(1)]


def motion_of(start, end):
    """The motion between what is given at its ends: two poses, or two quaternions w, x, y, z, each with a translation."""
    if not isinstance(start, list) or len(start) != 7:
        return line(given_pose(start), given_pose(end))
    ends = [list(pair) for pair in zip(vector(start, given, 7), vector(end, given, 7))]
    squares = [product(q, q) for q in ends[:4]]
    ww, xx, yy, zz = squares
    first, twice, last = divisor = added(*squares)
    need_form(first and last and (twice > 0 or twice * twice < 4 * first * last), "a quaternion is 0 at some time")

    def turn(i, j, k, sign):
        return [2 * (x + sign * y) for x, y in zip(product(ends[i], ends[j]), product(ends[0], ends[k]))]

    def diagonal(plus, *minus):
        return [w + x - y - z for w, x, y, z in zip(ww, plus, *minus)]

    rows = ([diagonal(xx, yy, zz), turn(1, 2, 3, -1), turn(1, 3, 2, 1)], [turn(1, 2, 3, 1), diagonal(yy, xx, zz), turn(2, 3, 1, -1)],
            [turn(1, 3, 2, -1), turn(2, 3, 1, 1), diagonal(zz, xx, yy)])
    return [f for row, shift in zip(rows, ends[4:]) for f in (*row, product(divisor, shift))], divisor


def pose_at(motion, time):
    entries, divisor = motion
    return [over(f, time, time)[0] / over(divisor, time, time)[0] for f in entries]


def together(motions):
    """The entries of both motions over one divisor, which is left out: it is positive. All have one degree."""
    (a, of_a), (b, of_b) = motions
    both = [product(f, of_b) for f in a], [product(f, of_a) for f in b]
    size = max(len(f) for entries in both for f in entries)
    return [[raised(f, size) for f in entries] for entries in both]
