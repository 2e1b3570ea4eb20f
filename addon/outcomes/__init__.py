# SPDX-License-Identifier: GPL-3.0-or-later
"""What a search has left: shape keys with their records, and what is done with them."""
