#!/usr/bin/env python3
# SPDX-License-Identifier: MIT OR Apache-2.0
"""Third ring, on a virtual screen: guides in real Blender's preferences. One is downloaded, with a cut in the
middle, and deforms; from a server on this machine. Another, made by the tests or in the folder that
`BOXMORPH_GUIDE` names, is copied in eight bits.

    tests/blender/run_download.py [CHROOT ...]

Screenshots of each step stay in tests/artifacts/.
"""

import os
import shutil
import sys

from chroots import ARTIFACTS, ROOT, run_everywhere, run_session


def check_suite(bench, counts):
    """Sit down in front of a Blender that has nothing but the extension."""
    ARTIFACTS.mkdir(parents=True, exist_ok=True)
    bench.install()
    bench.make_chair()
    run_session(bench, counts, "screen_download.py")
    try:
        large_guide(bench.outside / "guides" / "large")
    except ImportError as error:
        counts.skip("a copy in eight bits", error)
    else:
        run_session(bench, counts, "screen_copy.py")


def large_guide(folder):
    """Put a guide into a folder that takes some seconds to be copied."""
    named = os.environ.get("BOXMORPH_GUIDE")
    if named:
        shutil.copytree(named, folder)
        return
    sys.path.insert(0, str(ROOT / "tests" / "python"))
    from toy_guides import TinyViT

    TinyViT(width=1024, size=192).write(folder)


if __name__ == "__main__":
    sys.exit(run_everywhere("download", check_suite))
