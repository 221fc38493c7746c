# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Linear RGB spaces, by the matrix from their colours to CIE XYZ with white D65."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Any

from .faults import ForeseenError

Row = tuple[float, float, float]
Matrix = tuple[Row, Row, Row]  # rows

# IEC 61966-2-1, from the chromaticities of the primaries and of D65.
REC709: Matrix = (
    (0.41239079926595934, 0.357584339383878, 0.1804807884018343),
    (0.21263900587151027, 0.715168678767756, 0.07219231536073371),
    (0.01933081871559182, 0.11919477979462598, 0.9505321522496607),
)

# Programs write such matrices with five digits; what is the same to them is left as it is.
_SAME = 1e-4


class SpaceError(ForeseenError):
    """What should be a colour space is none."""


def conversion(source: Matrix, target: Matrix) -> Matrix | None:
    """From colours of one space to those of the other; None where they are the same."""
    found = _multiply(_inverse(target), source)
    differences = (found[i][j] - (i == j) for i in range(3) for j in range(3))
    return None if all(abs(value) < _SAME for value in differences) else found


def conversion_from_xyz(target: Matrix) -> Matrix:
    """From CIE XYZ with white D65 to colours of a space."""
    return _inverse(target)


def relative_to(source: Matrix, matrix: Matrix) -> Matrix:
    """The space of the colours that `matrix` makes of those of `source`."""
    return _multiply(source, _inverse(matrix))


def converted(matrix: Matrix | None, colour: Sequence[float]) -> Row:
    """The colour in the other space; it may get negative channels."""
    if matrix is None:
        return (colour[0], colour[1], colour[2])
    return tuple(sum(row[j] * colour[j] for j in range(3)) for row in matrix)


def dual(matrix: Matrix) -> Matrix:
    """For triples whose product with a colour is the same number in every space."""
    inverse = _inverse(matrix)
    return tuple(tuple(inverse[j][i] for j in range(3)) for i in range(3))


def text(matrix: Matrix) -> str:
    """The nine numbers that a file stores, row by row."""
    return " ".join(f"{value:.9g}" for row in matrix for value in row)


def parse(values: Any) -> Matrix:
    """From the text of nine numbers, or from three rows of three."""
    try:
        items = values.split() if isinstance(values, str) else values
        numbers = [float(value) for item in items for value in _listed(item)]
    except (TypeError, ValueError) as error:
        raise SpaceError("must be a matrix of 3 x 3 numbers") from error
    if len(numbers) != 9 or not all(map(math.isfinite, numbers)):
        raise SpaceError("must be a matrix of 3 x 3 numbers")
    matrix = tuple(tuple(numbers[3 * i : 3 * i + 3]) for i in range(3))
    if abs(_determinant(matrix)) < 1e-6:
        raise SpaceError("must have three primaries of different chromaticity")
    return matrix


def _listed(item: Any) -> Iterable[Any]:
    return item if isinstance(item, (list, tuple)) else [item]


def _multiply(a: Matrix, b: Matrix) -> Matrix:
    return tuple(
        tuple(sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)) for i in range(3)
    )


def _cofactor(m: Matrix, i: int, j: int) -> float:
    (a, b), (c, d) = ([m[r][s] for s in range(3) if s != j] for r in range(3) if r != i)
    return (-1.0) ** (i + j) * (a * d - b * c)


def _determinant(m: Matrix) -> float:
    return sum(m[0][j] * _cofactor(m, 0, j) for j in range(3))


def _inverse(m: Matrix) -> Matrix:
    determinant = _determinant(m)
    return tuple(tuple(_cofactor(m, j, i) / determinant for j in range(3)) for i in range(3))


def srgb(linear: float) -> float:
    """IEC 61966-2-1."""
    held = min(max(linear, 0.0), 1.0)
    return 12.92 * held if held <= 0.0031308 else 1.055 * held ** (1.0 / 2.4) - 0.055
