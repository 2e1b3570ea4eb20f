# SPDX-License-Identifier: GPL-3.0-or-later
"""A search, beside the user’s work or waited for, and what is seen of it."""
