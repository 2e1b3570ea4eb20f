#!/usr/bin/env python3
# SPDX-License-Identifier: MIT OR Apache-2.0
"""Builds a static extensions repository, a folder from which Blender installs and updates, out of built zips.

    scripts/build_repository.py [--output-dir DIR] [ZIP ...]

Without a ZIP, those of dist/ are taken; the default folder is dist/repository/. What the folder holds already
stays in it, so it can be the one that is served. `index.json` lists the newest version for each platform, as
`blender --command extension server-generate` would: Blender takes any of several. Older versions lie in
`older/`. The same zips give the same bytes. Exit codes: 0 done, 1 a fault in the inputs.
"""

import argparse
import hashlib
import html
import json
import re
import shutil
import sys
import tomllib
import urllib.parse
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

#: The fields of a manifest that the list shows, in Blender's order; those after `blender_version_min` are
#: optional.
FIELDS = (
    *("schema_version", "id", "name", "tagline", "version", "type", "maintainer", "license"),
    *("blender_version_min", "blender_version_max", "website", "copyright", "permissions", "tags"),
    "platforms",
)

PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>Boxmorph for Blender</title>
<style>body {{ font: 1em/1.5 sans-serif; max-width: 44em; margin: 2em auto; padding: 0 1em }}
td, th {{ text-align: left; padding: 0 1.5em .3em 0 }}</style>
</head>
<body>
<h1>Boxmorph for Blender</h1>
<p>Drag the link for your system into Blender. The first time it offers to add this repository; the second
time, to install Boxmorph. From then on Blender tells of newer versions. Or add the repository by hand:
Preferences, Get Extensions, Repositories, Add Remote Repository, with the address of
<a href="index.json">index.json</a>.</p>
<table>
<tr><th>Version</th><th>System</th><th>Blender</th><th>Size</th></tr>
{rows}
</table>
</body>
</html>
"""


class Fault(Exception):  # noqa: N818
    """A sentence about the inputs."""


def read_manifest(path):
    """Return the manifest of an extension zip as a dict. Raises Fault."""
    try:
        with zipfile.ZipFile(path) as archive:
            manifest = tomllib.loads(archive.read("blender_manifest.toml").decode())
    except (OSError, KeyError, ValueError, zipfile.BadZipFile) as error:
        raise Fault(f"{path} is not an extension's zip ({error})") from error
    for field in (*FIELDS[: FIELDS.index("blender_version_min") + 1], "platforms", "wheels"):
        if not manifest.get(field):
            raise Fault(f"the manifest in {path} has no `{field}`; build it by scripts/build_extension.py")
    return manifest


def file_name(manifest):
    """Return the name of a zip in the repository: one for each version and platform."""
    platforms = "-".join(platform.replace("-", "_") for platform in manifest["platforms"])
    return f"{manifest['id']}-{manifest['version']}-{platforms}.zip"


def python_versions(wheels):
    """Return the Pythons that wheels ask for, as Blender lists them: for a stable ABI just the major."""
    versions = set()
    for wheel in wheels:
        python, abi = Path(wheel).stem.split("-")[-3:-1]
        digits = re.fullmatch(r"(?:cp|py)(\d)(\d*)", python)
        if digits is None:
            raise Fault(f"the wheel {wheel} names no Python version")
        major, minor = digits.groups()
        versions.add(major if abi == "abi3" or not minor else f"{major}.{minor}")
    return sorted(versions)


def entry(path):
    """Return what `index.json` says of a zip. Raises Fault."""
    manifest, contents = read_manifest(path), path.read_bytes()
    listed = {field: manifest[field] for field in FIELDS if field in manifest}
    return listed | {
        "python_versions": python_versions(manifest["wheels"]),
        "archive_url": "./" + urllib.parse.quote(path.name),
        "archive_size": len(contents),
        "archive_hash": "sha256:" + hashlib.sha256(contents).hexdigest(),
    }


def newness(version):
    """Return a key by which versions sort as in Semantic Versioning."""
    numbers, _, early = version.partition("+")[0].partition("-")
    steps = [(not part.isdigit(), int(part) if part.isdigit() else 0, part) for part in early.split(".")]
    return [int(number) for number in numbers.split(".")], not early, steps


def collect(zips, folder):
    """Return all versions that the folder is to hold, {name in the folder: zip}. Raises Fault."""
    found = {path.name: path for path in (*folder.glob("*.zip"), *folder.glob("older/*.zip"))}
    for path in zips:
        name = file_name(read_manifest(path))
        if name not in found:
            found[name] = path
        elif found[name].read_bytes() != path.read_bytes():
            raise Fault(
                f"the repository holds {name} already, with other contents; raise the version, "
                "since Blender does not replace a compiled module by another of the same version"
            )
    return found


def newest(found):
    """Return the names of the zips that are the newest for one of their platforms, sorted."""
    best = {}
    for name, path in sorted(found.items()):
        manifest = read_manifest(path)
        for platform in manifest["platforms"]:
            if platform not in best or newness(best[platform][0]) < newness(manifest["version"]):
                best[platform] = (manifest["version"], name)
    return sorted({name for _, name in best.values()})


def page(entries):
    """Return `index.html`, whose links can be dropped into Blender."""
    rows = []
    for item in entries:
        about = {
            "repository": "./index.json",
            "blender_version_min": item["blender_version_min"],
            "platforms": ",".join(item["platforms"]),
            "python_versions": ",".join(item["python_versions"]),
        }
        link = html.escape(f"{item['archive_url']}?{urllib.parse.urlencode(about)}")
        cells = (
            f'<a href="{link}">{html.escape(item["name"])} {html.escape(item["version"])}</a>',
            html.escape(", ".join(item["platforms"])),
            f"from {html.escape(item['blender_version_min'])}",
            f"{item['archive_size'] / 1e6:.1f} MB",
        )
        rows.append("<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + "</tr>")
    return PAGE.format(rows="\n".join(rows))


def build(zips, folder):
    """Write the repository; return the entries of its list. Raises Fault, before anything is written."""
    found = collect(zips, folder)
    if not found:
        raise Fault("there is no zip; run `make extension` or `make release` first, or name one")
    listed = newest(found)
    older = folder / "older"
    folder.mkdir(parents=True, exist_ok=True)
    for name, path in found.items():
        place = (folder if name in listed else older) / name
        if path.resolve() == place.resolve():
            continue
        place.parent.mkdir(exist_ok=True)
        # What the folder held already is moved aside by a newer version.
        (shutil.move if path.parent in (folder, older) else shutil.copyfile)(path, place)
    entries = [entry(folder / name) for name in listed]
    index = json.dumps({"version": "v1", "blocklist": [], "data": entries}, indent=2)
    (folder / "index.json").write_text(index + "\n", encoding="utf-8")
    (folder / "index.html").write_text(page(entries), encoding="utf-8")
    return entries


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("zips", type=Path, nargs="*", metavar="ZIP", help="default: the zips of dist/")
    parser.add_argument("--output-dir", type=Path, default=ROOT / "dist" / "repository")
    options = parser.parse_args()
    try:
        entries = build(options.zips or sorted((ROOT / "dist").glob("boxmorph-*.zip")), options.output_dir)
    except Fault as fault:
        print(f"build_repository: {fault}.", file=sys.stderr)
        return 1
    for item in entries:
        print(f"{options.output_dir / 'index.json'}: {item['version']} for {', '.join(item['platforms'])}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
