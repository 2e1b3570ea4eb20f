# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels, preferences, presets, and the report on a bug."""
