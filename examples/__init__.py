# SPDX-License-Identifier: GPL-3.0-or-later
"""Four objects as an artist would leave them, each built by a script: `examples.chair.build()` and so on."""
