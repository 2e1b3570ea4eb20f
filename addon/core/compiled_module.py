# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether the compiled module that Python has loaded is the one that this extension brought.

Blender unpacks the wheels of all extensions into one folder, and replaces a wheel only by one of another
version. A module that is loaded stays until Blender ends.
"""

import pathlib
import tomllib
import zipfile

from ..errors import Refusal

_HERE = pathlib.Path(__file__).parents[1]
_right = []


def check(module):
    """Raise Refusal if `module` is not of this extension's build; what was right is not looked at again."""
    if module not in _right:
        fault = difference(module, _HERE)
        if fault:
            raise fault
        _right.append(module)


def difference(module, extension):
    """Return a Refusal on how `module` differs from the wheel in the folder `extension`, or None."""
    manifest = tomllib.loads((extension / "blender_manifest.toml").read_text(encoding="utf-8"))
    version = manifest["version"]
    unpacked = pathlib.Path(module.__file__).parents[1] / f"boxmorph-{version}.dist-info" / "RECORD"
    if module.__version__ == version:
        # Where Blender is a Python module, pip may have put ours there: it leaves an INSTALLER, and replaces.
        if not unpacked.is_file() or unpacked.with_name("INSTALLER").exists():
            return None
        if _compiled(unpacked.read_text(encoding="utf-8")) == _compiled(_record(extension, manifest)):
            return None
        return Refusal(
            "Blender has kept the compiled module of another build of Boxmorph {version}. "
            "Remove the extension, restart Blender and install it again",
            version=version,
        )
    if unpacked.is_file():
        return Refusal(
            "Boxmorph {version} was installed while {loaded} was in use. "
            "Restart Blender to finish the update",
            version=version,
            loaded=module.__version__,
        )
    return Refusal(
        "This is Boxmorph {version}, but Blender has loaded the compiled module of {loaded}. "
        "Remove other copies of Boxmorph from the extensions and restart Blender",
        version=version,
        loaded=module.__version__,
    )


def _record(extension, manifest):
    """Return the list of files, with their hashes, inside the extension's wheel."""
    with zipfile.ZipFile(extension / manifest["wheels"][0]) as wheel:
        return wheel.read(f"boxmorph-{manifest['version']}.dist-info/RECORD").decode()


def _compiled(record):
    """Return the lines of a wheel's RECORD that are about compiled code."""
    return sorted(line for line in record.split() if line.partition(",")[0].endswith((".so", ".pyd")))
