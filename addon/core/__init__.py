# SPDX-License-Identifier: GPL-3.0-or-later
"""The way to the Rust module and its guides, and objects of Blender as arrays."""
