# SPDX-License-Identifier: MIT OR Apache-2.0
"""Runs every ring of tests and ends in their counts.

Ring 1: cargo. Ring 2: pytest on the built wheel, then the extension in bpy 4.2, 4.5 and 5.0.
Ring 3: the built zip in real Blender, in a chroot: headless, out of an extensions repository, and by a real
mouse on a virtual screen.
Pytest shares its files among the cores, and the chroots are made meanwhile. The two Blenders of the third
ring run side by side, as they mostly wait; where answers are timed, on the screen, they come one at a time.
What a machine cannot provide is left out, by name, at the end.
"""

import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
CHROOTS = pathlib.Path(os.environ.get("BOXMORPH_CHROOTS", ROOT / "build" / "chroot"))
BPY = {"4.2": ["bpy==4.2.23"], "5.0": ["bpy==5.0.1"]}
SUITES = {"trixie": "Blender 4.3", "sid": "Blender 5.2"}
#: Runners of the third ring that may run beside another, and those that must be alone.
TOGETHER, ALONE = ("headless", "repository", "install"), ("download", "screen")
#: Files stay whole, as many build their objects once.
PYTEST = ["-m", "pytest", "--numprocesses", "auto", "--maxprocesses", "4", "--dist", "loadfile"]
COUNT = re.compile(r"(\d+) (passed|failed|skipped|ignored|errors?)\b")


class Tally:
    """Counts over all rings, and what was left out."""

    def __init__(self) -> None:
        self.counts = {"passed": 0, "failed": 0, "skipped": 0}
        self.left_out: list[str] = []

    def run(self, title: str, command: list[str], **options) -> None:
        """Runs a test runner, shows its output, adds its counts; one that dies counts as a failure."""
        print(f"\n== {title}", flush=True)
        start = time.monotonic()
        process = subprocess.Popen(
            command, cwd=ROOT, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **options
        )
        failed = 0
        for line in process.stdout:
            print(line, end="", flush=True)
            # Only closing lines count: cargo's, pytest's, and our own "N passed, N failed, N skipped".
            if not re.match(r"(test result:|=*\s*\d+ (passed|failed|skipped|error))", line):
                continue
            for number, kind in COUNT.findall(line):
                kind = {"ignored": "skipped", "error": "failed", "errors": "failed"}.get(kind, kind)
                self.counts[kind] += int(number)
                failed += int(number) if kind == "failed" else 0
        if process.wait() and not failed:
            print(f"{title}: ended with status {process.returncode}")
            self.counts["failed"] += 1
        print(f"== {title}: {time.monotonic() - start:.0f} s", flush=True)

    def leave_out(self, what: str) -> None:
        """Notes a part that this machine cannot run."""
        print(f"\n== left out: {what}", flush=True)
        self.left_out.append(what)


def bpy_python(version: str, packages: list[str]) -> pathlib.Path | None:
    """The Python of a virtual environment with that bpy, made on first use."""
    folder = ROOT / "build" / f"bpy-{version}"
    python = folder / "bin" / "python"
    if not (folder / "ready").exists():
        wanted = [*packages, "numpy==1.26.4", "pytest==9.2.0", "pytest-xdist==3.8.0"]
        base = os.environ.get("PYTHON", "python3.11")
        made = subprocess.run([base, "-m", "venv", str(folder)], check=False).returncode == 0
        if (
            not made
            or subprocess.run([python, "-m", "pip", "install", "--quiet", *wanted], check=False).returncode
        ):
            return None
        (folder / "ready").touch()
    return python


def provision(suite: str) -> bool:
    """Makes a chroot with a real Blender, unless it is there; whether that went well."""
    command = ["bash", "scripts/provision_blender.sh", str(CHROOTS / suite), suite]
    return subprocess.run(command, cwd=ROOT, check=False).returncode == 0


def ring3(tally: Tally, suite: str, rings: tuple[str, ...]) -> None:
    """Runs some runners of the third ring in one real Blender, one after the other."""
    for ring in rings:
        script = f"run_{ring}.py"
        command = [sys.executable, f"tests/blender/{script}", str(CHROOTS / suite)]
        tally.run(f"Ring 3: {script} in real {SUITES[suite]}", command)


def main() -> int:
    """Runs all rings; the exit status is 1 if anything failed."""
    tally = Tally()
    # One at a time: apt allows no two.
    with concurrent.futures.ThreadPoolExecutor(1) as background:
        provisioned = {suite: background.submit(provision, suite) for suite in SUITES}
        # The Python module shares the tests' profile, so that dependencies are compiled once.
        tally.run("Ring 1: cargo", ["cargo", "test", "--release", "--quiet"])
        tally.run("Ring 2: pytest on the wheel, bpy 4.5", [sys.executable, *PYTEST])
        addon_tests = sorted(str(p) for p in (ROOT / "tests" / "python").glob("test_addon*.py"))
        for version, packages in BPY.items():
            python = bpy_python(version, packages)
            if python is None:
                tally.leave_out(f"the extension in bpy {version}: the package could not be installed")
                continue
            tally.run(f"Ring 2: the extension in bpy {version}", [str(python), *PYTEST, *addon_tests])
    there = [suite for suite in SUITES if provisioned[suite].result()]
    for suite in SUITES:
        if suite not in there:
            tally.leave_out(f"real {SUITES[suite]}: its chroot ({suite}) could not be made")
    with concurrent.futures.ThreadPoolExecutor(len(SUITES)) as side_by_side:
        list(side_by_side.map(lambda suite: ring3(tally, suite, TOGETHER), there))
    for suite in there:
        ring3(tally, suite, ALONE)
    print("\n" + "".join(f"left out: {what}\n" for what in tally.left_out))
    print(", ".join(f"{number} {kind}" for kind, number in tally.counts.items()))
    return 1 if tally.counts["failed"] else 0


if __name__ == "__main__":
    sys.exit(main())
