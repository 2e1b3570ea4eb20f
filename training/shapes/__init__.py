# SPDX-License-Identifier: MIT OR Apache-2.0
"""Procedural shapes, family by family, each built from parameters and measured from its vertices."""

from . import lamps, planes, seats, tables

FAMILIES = {"seat": seats, "table": tables, "lamp": lamps, "aeroplane": planes}
