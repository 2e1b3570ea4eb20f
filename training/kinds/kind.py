# SPDX-License-Identifier: MIT OR Apache-2.0
"""A kind: what a name means, as a soft region in the measured proportions of its family."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Kind:
    """A range for every proportion that matters, the traits asked for, and other names.

    `ranges` maps a proportion to (low, high) or (low, high, sigma): inside, a shape belongs fully; outside,
    belonging falls with the distance in sigmas (log units; SIGMA when not given). `traits` maps a trait to
    (wanted values, squared sigmas that lacking it costs).
    """

    synonyms: tuple
    ranges: dict
    traits: dict


def kind(*synonyms, traits=None, **ranges):
    """A kind with its other names, its traits and a range for each proportion that matters."""
    return Kind(synonyms, ranges, traits or {})
