# SPDX-License-Identifier: MIT OR Apache-2.0
"""Shared by the runners of the third ring: where the chroots and the built zip are, and the counts.

A runner is given chroots that scripts/provision_blender.sh made; without any, it takes trixie and sid in
build/chroot, or in the folder that `BOXMORPH_CHROOTS` names. `BOXMORPH_ZIP` names the zip (default: the one
in dist/). It prints one line for each check and ends in "N passed, N failed, N skipped".
"""

import os
import shutil
import subprocess
import sys
import tempfile
from contextlib import contextmanager
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
ARTIFACTS = ROOT / "tests" / "artifacts"


def built_zip():
    """Return the path of the built extension; without one, or with several, end with a sentence."""
    named = os.environ.get("BOXMORPH_ZIP")
    found = [Path(named)] if named else sorted((ROOT / "dist").glob("boxmorph-*-linux_x64.zip"))
    if len(found) != 1 or not found[0].is_file():
        raise SystemExit(
            "One zip dist/boxmorph-<version>-linux_x64.zip is needed; run `make extension` first."
        )
    return found[0]


def chroots(arguments):
    """Return the chroots named on the command line, else the usual ones, as absolute paths."""
    folder = Path(os.environ.get("BOXMORPH_CHROOTS") or ROOT / "build" / "chroot")
    return [Path(path).absolute() for path in arguments or (folder / "trixie", folder / "sid")]


def ready(chroot):
    """Whether a chroot was provisioned."""
    return (chroot / ".boxmorph-provisioned").is_file()


@contextmanager
def bench(chroot, zip_path):
    """Give a Bench in a chroot; its folder is removed afterwards."""
    with tempfile.TemporaryDirectory(prefix="boxmorph-", dir=chroot / "tmp") as outside:
        shutil.copy(zip_path, outside)
        yield Bench(chroot, Path(outside), zip_path.name)


class Bench:
    """A Blender in a chroot, with a user folder and files of its own."""

    def __init__(self, chroot, outside, zip_name):
        self.chroot = chroot
        self.suite = chroot.name
        self.outside = outside  #: the folder of the files, as this machine sees it
        self.inside = f"/tmp/{outside.name}"  #: the same, as the chroot sees it
        self.zip = f"{self.inside}/{zip_name}"
        self.outside_zip = outside / zip_name
        self.chair = f"{self.inside}/chair.blend"

    def run(self, *command, timeout=600):
        """Run a command there; return the CompletedProcess with its output."""
        enter = (ROOT / "scripts" / "enter_chroot.sh", self.chroot)
        user = ("env", f"BLENDER_USER_RESOURCES={self.inside}/user")
        return subprocess.run(
            [*enter, *user, *command],
            text=True,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=timeout,
        )

    def install(self):
        """Install the zip; return the CompletedProcess."""
        return self.run(
            "blender", "--command", "extension", "install-file", "-r", "user_default", "-e", self.zip
        )

    def make_chair(self):
        """Save chair.blend; return the CompletedProcess."""
        script = ("--python-exit-code", "9", "--python", "/repo/tests/blender/make_chair.py")
        return self.run("blender", "-b", "--factory-startup", *script, "--", self.chair)


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


def run_session(bench, counts, script, *arguments):
    """Run a script that sits in front of the screen, inside the chroot; count the lines it prints."""
    command = ("python3", f"/repo/tests/blender/{script}", bench.inside, "/repo/tests/artifacts", bench.suite)
    run = bench.run(*command, *arguments, timeout=1500)
    lines = [line for line in run.stdout.splitlines() if line.startswith(("pass  ", "FAIL  "))]
    for line in lines:
        counts.check(line.startswith("pass"), line[6:])
    if run.returncode or not lines:
        counts.check(False, "the session ran to its end", run.stdout + run.stderr)


def run_everywhere(title, check_suite):
    """Call `check_suite(bench, counts)` in each chroot that is ready; print the counts, return the exit
    status.
    """
    zip_path = built_zip()
    counts = Counts(title)
    for chroot in chroots(sys.argv[1:]):
        counts.title = f"{title} {chroot.name}"
        if ready(chroot):
            with bench(chroot, zip_path) as prepared:
                check_suite(prepared, counts)
        else:
            counts.skip(f"Blender of {chroot.name}", "not provisioned; run scripts/provision_blender.sh")
    print(counts.summary())
    return 1 if counts.failed else 0
