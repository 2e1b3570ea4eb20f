#!/usr/bin/env python3
# SPDX-License-Identifier: MIT OR Apache-2.0
"""Third ring, on a virtual screen: the built zip in real Blender, used by mouse and keyboard.

    tests/blender/run_screen.py [CHROOT ...]

Screenshots of each step stay in tests/artifacts/.
"""

import sys

from chroots import ARTIFACTS, run_everywhere


def check_suite(bench, counts):
    """Install into the Blender of one chroot and sit down in front of it."""
    ARTIFACTS.mkdir(parents=True, exist_ok=True)
    bench.install()
    bench.make_chair()
    script = "/repo/tests/blender/screen_session.py"
    session = ("python3", script, bench.inside, "/repo/tests/artifacts", bench.suite)
    run = bench.run(*session, timeout=1500)
    lines = [line for line in run.stdout.splitlines() if line.startswith(("pass  ", "FAIL  "))]
    for line in lines:
        counts.check(line.startswith("pass"), line[6:])
    if run.returncode or not lines:
        counts.check(False, "the session ran to its end", run.stdout + run.stderr)


if __name__ == "__main__":
    sys.exit(run_everywhere("screen", check_suite))
