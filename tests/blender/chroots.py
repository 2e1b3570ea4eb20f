# SPDX-License-Identifier: MIT OR Apache-2.0
"""Shared by the runners of the third ring: where the chroots and the built zip are, and the counts at the end.

`BOXMORPH_CHROOTS` names the folder of the chroots (default build/chroot), `BOXMORPH_ZIP` the zip (default: the one
in dist/). A runner prints one line for each check and ends in "N passed, N failed, N skipped".
"""

import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
CHROOTS = Path(os.environ.get("BOXMORPH_CHROOTS") or ROOT / "build" / "chroot").absolute()
ARTIFACTS = ROOT / "tests" / "artifacts"
SUITES = ("trixie", "sid")


def built_zip():
    """Return the path of the built extension. Raises SystemExit with a sentence where there is none or several."""
    named = os.environ.get("BOXMORPH_ZIP")
    found = [Path(named)] if named else sorted((ROOT / "dist").glob("boxmorph-*-linux_x64.zip"))
    if len(found) != 1 or not found[0].is_file():
        raise SystemExit(
            "One zip dist/boxmorph-<version>-linux_x64.zip is needed; run `make extension` first."
        )
    return found[0]


def ready(suite):
    """Whether the chroot of `suite` was provisioned."""
    return (CHROOTS / suite / ".boxmorph-provisioned").is_file()


def enter(suite, *command, **options):
    """Run a command in a chroot, the repository at /repo; return the CompletedProcess with text output."""
    script = ROOT / "scripts" / "enter_chroot.sh"
    return subprocess.run(
        [script, CHROOTS / suite, *map(str, command)], text=True, stdin=subprocess.DEVNULL, **options
    )


class Counts:
    """Counts checks and prints each."""

    def __init__(self, title):
        self.title = title
        self.passed = self.failed = self.skipped = 0

    def check(self, holds, what, detail=""):
        """Count a check; `detail` is shown where it fails. Returns whether it holds."""
        if holds:
            self.passed += 1
        else:
            self.failed += 1
        print(f"{self.title}: {'pass' if holds else 'FAIL'}  {what}", flush=True)
        if not holds and detail:
            print("    " + str(detail).strip().replace("\n", "\n    "), flush=True)
        return holds

    def skip(self, what, reason):
        """Count something left out."""
        self.skipped += 1
        print(f"{self.title}: skip  {what}: {reason}", flush=True)

    def summary(self):
        """Return the counts in one line."""
        return f"{self.passed} passed, {self.failed} failed, {self.skipped} skipped"
