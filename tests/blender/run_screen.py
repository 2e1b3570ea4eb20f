#!/usr/bin/env python3
# SPDX-License-Identifier: MIT OR Apache-2.0
"""Third ring, on a virtual screen: the built zip in real Blender, used by mouse and keyboard.

    tests/blender/run_screen.py [CHROOT ...]

Screenshots of each step stay in tests/artifacts/.
"""

import sys

from chroots import ARTIFACTS, run_everywhere, run_session


def check_suite(bench, counts):
    """Install into the Blender of one chroot and sit down in front of it."""
    ARTIFACTS.mkdir(parents=True, exist_ok=True)
    bench.install()
    bench.make_chair()
    run_session(bench, counts, "screen_session.py")


if __name__ == "__main__":
    sys.exit(run_everywhere("screen", check_suite))
