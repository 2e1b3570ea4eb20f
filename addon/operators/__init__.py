# SPDX-License-Identifier: GPL-3.0-or-later
"""What buttons and scripts call, and the settings that they share."""
