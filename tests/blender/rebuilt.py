# SPDX-License-Identifier: MIT OR Apache-2.0
"""Another build of the extension, made from a built zip without a compiler."""

import base64
import hashlib
import io
import re
import zipfile

#: A version later than any.
NEWER = "99.0.0"


def rebuilt_zip(zip_path, folder, version):
    """Write the extension of `zip_path` as `version` into `folder`, with a wheel of that version and other
    compiled bytes; return its path. The same version gives another build of the same version.
    """
    with zipfile.ZipFile(zip_path) as archive:
        files = {name: archive.read(name) for name in archive.namelist()}
    manifest = files.pop("blender_manifest.toml").decode()
    old = re.search(r'^version = "(.*)"$', manifest, re.MULTILINE).group(1)
    (wheel_name,) = (name for name in files if name.endswith(".whl"))
    new_wheel_name = wheel_name.replace(f"-{old}-", f"-{version}-")
    files[new_wheel_name] = _rebuilt_wheel(files.pop(wheel_name), old, version)
    manifest = manifest.replace(f'version = "{old}"', f'version = "{version}"', 1)
    files["blender_manifest.toml"] = manifest.replace(wheel_name, new_wheel_name).encode()
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / zip_path.name.replace(f"-{old}-", f"-{version}-")
    _write(path, files)
    return path


def other_platform(zip_path, folder, platform):
    """Write the extension of `zip_path` as if it were for another platform into `folder`; return its path."""
    with zipfile.ZipFile(zip_path) as archive:
        files = {name: archive.read(name) for name in archive.namelist()}
    manifest = files["blender_manifest.toml"].decode()
    files["blender_manifest.toml"] = manifest.replace('"linux-x64"', f'"{platform}"').encode()
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / zip_path.name.replace("linux_x64", platform.replace("-", "_"))
    _write(path, files)
    return path


def _rebuilt_wheel(wheel, old, version):
    """Return a wheel's bytes as another version's: its names, its metadata, its record, and `__version__`."""
    with zipfile.ZipFile(io.BytesIO(wheel)) as archive:
        files = {name: archive.read(name) for name in archive.namelist()}
    info = f"boxmorph-{version}.dist-info"
    files = {name.replace(f"boxmorph-{old}.dist-info", info): data for name, data in files.items()}
    del files[f"{info}/RECORD"]
    files[f"{info}/METADATA"] = files[f"{info}/METADATA"].replace(
        f"\nVersion: {old}\n".encode(), f"\nVersion: {version}\n".encode()
    )
    files["boxmorph/__init__.py"] += f'\n__version__ = "{version}"\n'.encode()
    # Bytes after its end do not matter to a library, but make it another file.
    files["boxmorph/_boxmorph.abi3.so"] += b"rebuilt"
    record = [f"{name},sha256={_digest(data)},{len(data)}" for name, data in files.items()]
    files[f"{info}/RECORD"] = "\n".join([*record, f"{info}/RECORD,,", ""]).encode()
    out = io.BytesIO()
    _write(out, files)
    return out.getvalue()


def _digest(data):
    return base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()


def _write(target, files):
    with zipfile.ZipFile(target, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
        for name, data in files.items():
            archive.writestr(name, data)
