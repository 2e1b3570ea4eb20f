#!/usr/bin/env python3
# SPDX-License-Identifier: MIT OR Apache-2.0
"""Third ring, on a virtual screen: a guide is downloaded in real Blender's preferences, with a cut in the
middle, and deforms; from a server on this machine.

    tests/blender/run_download.py [CHROOT ...]

Screenshots of each step stay in tests/artifacts/.
"""

import sys

from chroots import ARTIFACTS, run_everywhere, run_session


def check_suite(bench, counts):
    """Sit down in front of a Blender that has nothing but the extension."""
    ARTIFACTS.mkdir(parents=True, exist_ok=True)
    bench.install()
    bench.make_chair()
    run_session(bench, counts, "screen_download.py")


if __name__ == "__main__":
    sys.exit(run_everywhere("download", check_suite))
