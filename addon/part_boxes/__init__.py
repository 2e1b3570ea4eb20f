# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of an object: found, kept with their locks, drawn, and the faces that span them."""
