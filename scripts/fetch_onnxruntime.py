# SPDX-License-Identifier: MIT OR Apache-2.0
"""Puts ONNX Runtime's C library, unmodified, into the Python package.

It is taken from the pinned `onnxruntime` wheel of the package index that pip is configured for. Our wheel
then needs no Python package: that wheel is tied to one Python version, ours is not.
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import zipfile

VERSION = "1.32.0"
TARGET = pathlib.Path(__file__).parent.parent / "python" / "boxmorph" / "onnxruntime"
LIBRARIES = {"linux": "libonnxruntime.so", "darwin": "libonnxruntime.", "win32": "onnxruntime.dll"}


def main() -> None:
    """Downloads the wheel and extracts the library and its licences."""
    marker = TARGET / "VERSION.txt"
    if marker.is_file() and marker.read_text() == VERSION:
        return
    shutil.rmtree(TARGET, ignore_errors=True)
    TARGET.mkdir(parents=True)
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "pip", "download", "--quiet", "--no-deps", "--only-binary", ":all:"]
        subprocess.run([*command, "--dest", folder, f"onnxruntime=={VERSION}"], check=True)
        (wheel,) = pathlib.Path(folder).glob("*.whl")
        extract(zipfile.ZipFile(wheel))
    marker.write_text(VERSION)


def extract(wheel: zipfile.ZipFile) -> None:
    """Copies the library (never its provider plug-ins) and the licence texts."""
    prefix = LIBRARIES[sys.platform]
    for entry in wheel.namelist():
        name = entry.rsplit("/", 1)[-1]
        if name.startswith(prefix) and "providers" not in name:
            (TARGET / name).write_bytes(wheel.read(entry))
        elif name in ("LICENSE", "ThirdPartyNotices.txt"):
            (TARGET / f"{name.removesuffix('.txt')}.txt").write_bytes(wheel.read(entry))


if __name__ == "__main__":
    main()
