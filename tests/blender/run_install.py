#!/usr/bin/env python3
# SPDX-License-Identifier: MIT OR Apache-2.0
"""Third ring, on a virtual screen: the built zip, and then a newer one, dropped into real Blender's window.

    tests/blender/run_install.py [CHROOT ...]

Screenshots of each step stay in tests/artifacts/.
"""

import sys

from chroots import ARTIFACTS, run_everywhere, run_session
from rebuilt import NEWER, rebuilt_zip


def check_suite(bench, counts):
    """Sit down in front of a Blender without the extension."""
    ARTIFACTS.mkdir(parents=True, exist_ok=True)
    bench.make_chair()
    newer = rebuilt_zip(bench.outside_zip, bench.outside / "newer", NEWER)
    zips = (bench.zip, f"{bench.inside}/newer/{newer.name}")
    run_session(bench, counts, "screen_install.py", *zips)


if __name__ == "__main__":
    sys.exit(run_everywhere("install", check_suite))
