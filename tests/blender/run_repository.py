#!/usr/bin/env python3
# SPDX-License-Identifier: MIT OR Apache-2.0
"""Third ring, packages: real Blender installs and updates the extension from a static repository.

tests/blender/run_repository.py [CHROOT ...]
"""

import contextlib
import functools
import http.server
import json
import shutil
import subprocess
import sys
import threading

from chroots import ROOT, run_everywhere
from rebuilt import NEWER, other_platform, rebuilt_zip

REPOSITORY = "boxmorph_test"

#: Prints what the extension and its compiled module are, and how a search ends, as JSON.
_LOOK = """
import bpy, json, pathlib, sys, tomllib
package = next(name for name in bpy.context.preferences.addons.keys() if name.endswith('.boxmorph'))
def look():
    addon = pathlib.Path(sys.modules[package].__file__).parent
    import boxmorph
    objects = bpy.data.objects
    bpy.context.view_layer.objects.active = objects['Plain Chair']
    for obj in objects: obj.select_set(obj.name == 'Plain Chair')
    try:
        bpy.ops.boxmorph.deform(prompt='a bar stool', splits='2', preset='standard')
        answer = 'deformed'
    except RuntimeError as error:
        answer = str(error)
    manifest = tomllib.loads((addon / 'blender_manifest.toml').read_text())
    print('LOOK' + json.dumps([manifest['version'], boxmorph.__version__, answer]))
"""


def looks(run):
    """Return what `look()` printed in a run: [extension's version, module's version, answer], each time."""
    return [json.loads(line[4:]) for line in run.stdout.splitlines() if line.startswith("LOOK")]


def check_suite(bench, counts):
    """Build, serve, install, update; then the cases that go wrong elsewhere."""
    bench.make_chair()
    folder = bench.outside / "repository"
    original = bench.outside_zip
    newer = rebuilt_zip(original, bench.outside / "newer", NEWER)
    version = original.name.split("-")[1]
    windows = other_platform(original, bench.outside / "windows", "windows-x64")
    check_index(bench, [original, newer, windows], counts)
    publish(original, folder)
    with served(folder) as url:
        check_update(bench, counts, url, lambda: publish(newer, folder), version)
    check_other_build(bench, counts, original, folder, version)
    check_running(bench, counts, newer, version)


def publish(zip_path, folder):
    """Put a zip into the repository; return the CompletedProcess."""
    command = [sys.executable, ROOT / "scripts" / "build_repository.py", zip_path, "--output-dir", folder]
    return subprocess.run(command, text=True, capture_output=True)


@contextlib.contextmanager
def served(folder):
    """Serve a folder on this machine; give the address of its index."""

    class Handler(http.server.SimpleHTTPRequestHandler):
        def log_message(self, *_):
            pass

    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Handler, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/index.json"
    finally:
        server.shutdown()


def check_index(bench, zips, counts):
    """Our list of several zips is the one that Blender would write."""
    folder, theirs_folder = bench.outside / "several", bench.outside / "theirs"
    for path in zips:
        publish(path, folder)
    theirs_folder.mkdir()
    for path in folder.glob("*.zip"):
        shutil.copy(path, theirs_folder)
    run = bench.run(
        *("blender", "--command", "extension", "server-generate", "--repo-dir", f"{bench.inside}/theirs")
    )
    ours, theirs = (
        json.loads((place / "index.json").read_text(encoding="utf-8")) for place in (folder, theirs_folder)
    )
    for index in (ours, theirs):
        index["data"].sort(key=lambda item: item["archive_url"])
    counts.check(
        ours == theirs and len(ours["data"]) == 2,
        "index.json is what Blender itself would write",
        f"{ours}\n{theirs}\n{run}",
    )


def extension(bench, *arguments):
    """Run `blender --command extension`, allowed to go online; return the CompletedProcess."""
    return bench.run("blender", "--online-mode", "--command", "extension", *arguments)


def start(bench, script="look()"):
    """Start Blender with the chair and run `script`; return the CompletedProcess."""
    expression = ("--python-exit-code", "9", "--python-expr", _LOOK + script)
    return bench.run("blender", "-b", bench.chair, *expression)


def check_update(bench, counts, url, publish_newer, version):
    """From an empty profile to the installed extension, and to the next version."""
    run = extension(bench, "repo-add", REPOSITORY, "--name", "Boxmorph", "--url", url)
    counts.check(run.returncode == 0, "the repository is added", run.stdout + run.stderr)
    run = extension(bench, "sync")
    counts.check(run.returncode == 0, "it is read", run.stdout + run.stderr)
    run = extension(bench, "install", "boxmorph", "-e")
    counts.check(run.returncode == 0, "the extension is installed from it", run.stdout + run.stderr)
    run = extension(bench, "list")
    counts.check("boxmorph [installed]" in run.stdout, "and listed as installed", run.stdout + run.stderr)
    run = start(bench)
    counts.check(looks(run) == [[version, version, "deformed"]], "it deforms", run.stdout + run.stderr)

    run = publish_newer()
    counts.check(run.returncode == 0, "a newer version is published", run.stderr)
    run = extension(bench, "list", "--sync")
    outdated = f"outdated: {version} -> {NEWER}"
    counts.check(outdated in run.stdout, "Blender sees the newer version", run.stdout + run.stderr)
    run = extension(bench, "update")
    counts.check(run.returncode == 0, "it is updated", run.stdout + run.stderr)
    run = start(bench)
    counts.check(
        looks(run) == [[NEWER, NEWER, "deformed"]],
        "the next start has the newer extension and the newer module",
        run.stdout + run.stderr,
    )
    run = extension(bench, "remove", f"{REPOSITORY}.boxmorph")
    counts.check(run.returncode == 0, "it is removed", run.stdout + run.stderr)


def check_other_build(bench, counts, original, folder, version):
    """Another build of the same version: not to be published; where it is installed by hand, named."""
    other = rebuilt_zip(original, bench.outside / "other", version)
    run = publish(other, folder)
    counts.check(
        run.returncode == 1 and "raise the version" in run.stderr,
        "another build of a published version is refused",
        run.stdout + run.stderr,
    )
    bench.install()
    install = ("install-file", "-r", "user_default", "-e", f"{bench.inside}/other/{other.name}")
    run = extension(bench, *install)
    counts.check(run.returncode == 0, "it can be installed by hand", run.stdout + run.stderr)
    run = start(bench)
    answer = looks(run)[0][2]
    counts.check("another build" in answer, "that Blender kept the old module is said", answer)
    extension(bench, "remove", "user_default.boxmorph")
    extension(bench, *install)
    run = start(bench)
    counts.check(
        looks(run) == [[version, version, "deformed"]],
        "removed and installed again, it deforms",
        run.stdout + run.stderr,
    )
    extension(bench, "remove", "user_default.boxmorph")


def check_running(bench, counts, newer, version):
    """The newer version installed over one that is loaded and in use."""
    bench.install()
    path = f"{bench.inside}/newer/{newer.name}"
    run = start(
        bench,
        "look()\nbpy.ops.extensions.package_install_files("
        f"repo='user_default', filepath={path!r}, enable_on_install=True)\nlook()",
    )
    seen = looks(run)
    counts.check(run.returncode == 0, "installing over a running one ends nothing", run.stdout + run.stderr)
    counts.check(
        len(seen) == 2
        and seen[0] == [version, version, "deformed"]
        and seen[1][:2] == [NEWER, version]
        and "Restart Blender" in seen[1][2],
        "it asks for a restart",
        run.stdout + run.stderr,
    )
    run = start(bench)
    counts.check(looks(run) == [[NEWER, NEWER, "deformed"]], "and works after it", run.stdout + run.stderr)


if __name__ == "__main__":
    sys.exit(run_everywhere("repository", check_suite))
