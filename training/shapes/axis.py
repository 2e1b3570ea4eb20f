# SPDX-License-Identifier: MIT OR Apache-2.0
"""Axes of proportions: the range a builder takes, and the scale on which two values are compared."""

from typing import NamedTuple

import numpy as np

SHIFT = 0.1  # added to proportions that may be zero (a back, an overhang) before the logarithm


class Axis(NamedTuple):
    """One proportion of a family, from `low` to `high`, far wider than any kind."""

    low: float
    high: float
    shift: float | None  # None: compared as it is; otherwise as log(value + shift)

    def place(self, value):
        """Where a value lies on the axis of comparison (log units, or the value itself)."""
        if self.shift is None:
            return value
        return np.log(np.maximum(value, 0.0 if self.shift else 1e-3) + self.shift)

    def value(self, place):
        """The value at a place: the inverse of `place`."""
        return place if self.shift is None else np.exp(place) - self.shift

    def between(self, a, b, t):
        """The value at the share t of the way from a to b."""
        return self.value(self.place(a) + (self.place(b) - self.place(a)) * t)


def ratio(low, high):
    """A proportion that is never zero: compared by its logarithm."""
    return Axis(low, high, 0.0)


def amount(low, high):
    """A proportion that may be zero: compared by the logarithm of value + SHIFT."""
    return Axis(low, high, SHIFT)


def slope(low, high):
    """A quantity of either sign: compared as it is."""
    return Axis(low, high, None)


def outside(value, low, high):
    """Log distance of a positive value to a range, 0 inside: how a `measure` grades a fault."""
    value = max(value, 1e-3)
    return max(np.log(low / value), np.log(value / high), 0.0)
