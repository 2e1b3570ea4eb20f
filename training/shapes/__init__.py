# SPDX-License-Identifier: MIT OR Apache-2.0
"""Procedural shapes, family by family, each built from parameters and measured from its vertices."""
