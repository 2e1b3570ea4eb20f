#!/usr/bin/env python3
# SPDX-License-Identifier: MIT OR Apache-2.0
"""Third ring, on a virtual screen: the built zip in real Blender, used by mouse and keyboard.

    tests/blender/run_screen.py [SUITE ...]            SUITE: trixie, sid (default: both)

Screenshots of each step stay in tests/artifacts/.
"""

import shutil
import sys
import tempfile
from pathlib import Path

from chroots import ARTIFACTS, CHROOTS, SUITES, Counts, built_zip, enter, ready


def check_suite(suite, zip_path, counts):
    """Install into the Blender of one chroot and sit down in front of it."""
    ARTIFACTS.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="boxmorph-", dir=CHROOTS / suite / "tmp") as outside:
        inside = f"/tmp/{Path(outside).name}"
        shutil.copy(zip_path, f"{outside}/{zip_path.name}")
        user = ("env", f"BLENDER_USER_RESOURCES={inside}/user")
        for arguments in (
            (
                "--command",
                "extension",
                "install-file",
                "-r",
                "user_default",
                "-e",
                f"{inside}/{zip_path.name}",
            ),
            ("-b", "--factory-startup", "--python", "/repo/tests/blender/make_chair.py", "--")
            + (f"{inside}/chair.blend",),
        ):
            enter(suite, *user, "blender", *arguments, capture_output=True)
        session = "/repo/tests/blender/screen_session.py"
        run = enter(
            suite,
            *(*user, "python3", session, inside, "/repo/tests/artifacts", suite),
            capture_output=True,
            timeout=1500,
        )
        lines = run.stdout.splitlines()
        seen = 0
        for line in lines:
            if line.startswith(("pass  ", "FAIL  ")):
                seen += 1
                counts.check(line.startswith("pass"), line[6:])
        if run.returncode or not seen or counts.failed:
            counts.check(run.returncode == 0 and seen, "the session ran to its end", run.stdout + run.stderr)


def main():
    counts = Counts("screen")
    zip_path = built_zip()
    for suite in sys.argv[1:] or SUITES:
        counts.title = f"screen {suite}"
        if ready(suite):
            check_suite(suite, zip_path, counts)
        else:
            counts.skip(f"Blender of {suite}", "not provisioned; run scripts/provision_blender.sh")
    print(counts.summary())
    return 1 if counts.failed else 0


if __name__ == "__main__":
    sys.exit(main())
