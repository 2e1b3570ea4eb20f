#!/usr/bin/env python3
# SPDX-License-Identifier: MIT OR Apache-2.0
"""Builds the installable extension, dist/boxmorph-<version>-<platform>.zip, from addon/ and the wheels in
dist/.

    scripts/build_extension.py [--wheel FILE ...] [--output-dir DIR]

One zip for each platform that has a wheel. The same inputs give the same bytes. Before anything is written,
the manifest is held against what Blender itself does not check: see `lint`. Exit codes: 0 done, 1 a fault in
the inputs.
"""

import argparse
import re
import sys
import tomllib
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
ADDON = ROOT / "addon"

#: End of a wheel's platform tag → the platform's name in an extension manifest.
PLATFORMS = {
    r"manylinux.*_x86_64|linux_x86_64": "linux-x64",
    r"manylinux.*_aarch64|linux_aarch64": "linux-arm64",
    r"win_amd64": "windows-x64",
    r"win_arm64": "windows-arm64",
    r"macosx_.*_arm64": "macos-arm64",
    r"macosx_.*_x86_64": "macos-x64",
}
PERMISSIONS = {"files", "network", "clipboard", "camera", "microphone"}

#: Every file in the zip bears this time, so that it depends on the contents alone.
TIMESTAMP = (2020, 1, 1, 0, 0, 0)


def platform_of(wheel):
    """Return the manifest's name for the platform of a wheel's file name, or None."""
    tag = wheel.stem.split("-")[-1]
    # A wheel may bear several tags, joined by dots; the last is the most general.
    for pattern, name in PLATFORMS.items():
        if re.fullmatch(pattern, tag.split(".")[-1]):
            return name
    return None


def lint(manifest, crate_version, wheels):
    """Return the faults of the manifest and the wheels, each a sentence."""
    faults = []
    version = manifest.get("version")
    if version != crate_version:
        faults.append(
            f"addon/blender_manifest.toml has version {version}, but Cargo.toml has {crate_version}"
        )
    for licence in manifest.get("license", []) or ["nothing"]:
        if not re.fullmatch(r"SPDX:[A-Za-z0-9.+-]+", licence):
            faults.append(f"the licence “{licence}” is not of the form SPDX:GPL-3.0-or-later")
    for field in ("platforms", "wheels"):
        if field in manifest:
            faults.append(
                f"`{field}` stands in addon/blender_manifest.toml, but is filled in from the wheels"
            )
    tagline = manifest.get("tagline", "")
    if not tagline or len(tagline) > 64 or not tagline[-1].isalnum():
        faults.append("the tagline must have 1 to 64 characters and no punctuation at its end")
    for name, reason in manifest.get("permissions", {}).items():
        if name not in PERMISSIONS:
            faults.append(f"Blender knows no permission “{name}”")
        if len(reason) > 64 or not reason[-1].isalnum():
            faults.append(
                f"the reason for permission “{name}” must have up to 64 characters, no punctuation at its end"
            )
    if not wheels:
        faults.append("there is no wheel; build one into dist/ first, or name one with --wheel")
    seen = {}
    for wheel in wheels:
        if not wheel.is_file():
            faults.append(f"the wheel {wheel} does not exist")
            continue
        parts = wheel.stem.split("-")
        if parts[0] != "boxmorph" or parts[1] != crate_version:
            faults.append(f"the wheel {wheel.name} is not boxmorph {crate_version}; remove it")
        if parts[2:4] != ["cp311", "abi3"]:
            faults.append(
                f"the wheel {wheel.name} is not cp311-abi3, so it would fit only one of Blender's Pythons"
            )
        platform = platform_of(wheel)
        if platform is None:
            faults.append(f"the wheel {wheel.name} is for a platform that Blender's extensions do not name")
        elif platform in seen:
            faults.append(f"{seen[platform]} and {wheel.name} are both for {platform}; remove one")
        seen[platform] = wheel.name
    return faults


def filled_manifest(text, wheel, platform):
    """Return the manifest's text with the one wheel and platform of a zip, before its first table."""
    lines = f'platforms = ["{platform}"]\nwheels = ["./wheels/{wheel.name}"]\n\n'
    head, table, rest = text.partition("[permissions]")
    return head + lines + table + rest


def write_zip(path, manifest_text, wheel):
    """Write one extension zip; the same contents give the same bytes."""
    files = {"blender_manifest.toml": manifest_text.encode(), f"wheels/{wheel.name}": wheel.read_bytes()}
    for source in sorted(ADDON.rglob("*")):
        name = source.relative_to(ADDON).as_posix()
        if source.is_file() and name not in files and "__pycache__" not in name and not name.startswith("."):
            files[name] = source.read_bytes()
    with zipfile.ZipFile(path, "w") as archive:
        for name in sorted(files):
            info = zipfile.ZipInfo(name, TIMESTAMP)
            # As on Unix, on whichever system it is built.
            info.create_system = 3
            info.external_attr = 0o644 << 16
            # A wheel is compressed already.
            info.compress_type = zipfile.ZIP_STORED if name.endswith(".whl") else zipfile.ZIP_DEFLATED
            archive.writestr(info, files[name])


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--wheel", type=Path, action="append", help="default: the wheels in dist/")
    parser.add_argument("--output-dir", type=Path, default=ROOT / "dist")
    options = parser.parse_args()
    wheels = options.wheel or sorted((ROOT / "dist").glob("boxmorph-*.whl"))

    text = (ADDON / "blender_manifest.toml").read_text(encoding="utf-8")
    manifest = tomllib.loads(text)
    crate_version = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["package"]["version"]
    faults = lint(manifest, crate_version, wheels)
    if faults:
        for fault in faults:
            print(f"build_extension: {fault}.", file=sys.stderr)
        return 1
    options.output_dir.mkdir(parents=True, exist_ok=True)
    for wheel in wheels:
        platform = platform_of(wheel)
        path = options.output_dir / f"boxmorph-{crate_version}-{platform.replace('-', '_')}.zip"
        filled = filled_manifest(text, wheel, platform)
        tomllib.loads(filled)
        write_zip(path, filled, wheel)
        print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main())
