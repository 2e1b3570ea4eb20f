#!/usr/bin/env python3
# SPDX-License-Identifier: MIT OR Apache-2.0
"""Third ring, on a virtual screen: the built zip in real Blender, used by mouse and keyboard.

    tests/blender/run_screen.py [CHROOT ...]

Screenshots of each step stay in tests/artifacts/.
"""

import sys

from chroots import ARTIFACTS, Counts, bench, built_zip, chroots, ready


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


def main():
    counts = Counts("screen")
    zip_path = built_zip()
    for chroot in chroots(sys.argv[1:]):
        counts.title = f"screen {chroot.name}"
        if ready(chroot):
            with bench(chroot, zip_path) as prepared:
                check_suite(prepared, counts)
        else:
            counts.skip(f"Blender of {chroot.name}", "not provisioned; run scripts/provision_blender.sh")
    print(counts.summary())
    return 1 if counts.failed else 0


if __name__ == "__main__":
    sys.exit(main())
