# SPDX-License-Identifier: MIT OR Apache-2.0
"""Guides on the command line of real Blender: listed, refused offline, downloaded from a server of ours."""

import json
import sys
from pathlib import Path

from chroots import ROOT

sys.path.insert(0, str(ROOT / "tests" / "python"))
from hub_server import HubServer

GUIDE = "clip-vit-base-patch32"


def check_guides(bench, counts):
    """List, refuse, download, deform by the guide's name, remove."""

    def boxmorph(*arguments, before=()):
        return bench.run("blender", "-b", *before, "--command", "boxmorph", *arguments)

    run = boxmorph("guides")
    counts.check(
        run.returncode == 0 and f"{GUIDE}: " in run.stdout and "int8: about 156 MB" in run.stdout,
        "guides are listed",
        run.stdout + run.stderr,
    )
    with HubServer() as hub:
        get = ("guides", "--get", GUIDE, "--endpoint", hub.url)
        for before in ((), ("--offline-mode",)):
            run = boxmorph(*get, before=before)
            counts.check(
                run.returncode == 1 and "--online-mode" in run.stderr and hub.log == [],
                f"{before[0] if before else 'without --online-mode'}: exit code 1 and a sentence",
                f"{run.returncode}\n{run.stderr}\n{hub.log}",
            )
        hub.cuts = [1_000_000]
        run = boxmorph(*get, before=("--online-mode",))
        counts.check(
            run.returncode == 0 and "is whole" in run.stdout and "licence MIT" in run.stdout,
            "with it, the guide comes, over a cut",
            run.stdout + run.stderr,
        )
    run = bench.run(
        *("blender", "-b", bench.chair, "--command", "boxmorph", "deform", "--object", "Plain Chair"),
        *("--prompt", "a bar stool", "--splits", "2", "--guide", f"{GUIDE}-fp32"),
        *("--output", f"{bench.inside}/judged.blend", "--report", f"{bench.inside}/judged.json"),
    )
    report = Path(f"{bench.outside}/judged.json")
    judge = json.loads(report.read_text(encoding="utf-8"))["guide"]["name"] if report.is_file() else None
    counts.check(judge == f"{GUIDE}-fp32", "it judges by its name", run.stdout + run.stderr)
    run = boxmorph("guides", "--remove", GUIDE)
    listed = boxmorph("guides").stdout
    counts.check(run.returncode == 0 and "downloaded" not in listed, "it is removed", run.stderr + listed)
