# SPDX-License-Identifier: MIT OR Apache-2.0
"""The extension as a package: it comes and goes without a trace, and its zip is built soundly."""

import ast
import importlib.util
import pathlib
import re
import sys
import zipfile

import addon_blender as blender
import addon_utils
import pytest
from addon_blender import bpy

ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def build():
    path = ROOT / "scripts" / "build_extension.py"
    spec = importlib.util.spec_from_file_location("build_extension", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def traces():
    """Return what of the extension is registered in Blender."""
    lists = [(name, getattr(bpy.app.handlers, name)) for name in dir(bpy.app.handlers)]
    return {
        "types": sorted(name for name in dir(bpy.types) if "boxmorph" in name.lower()),
        "operators": sorted(dir(bpy.ops.boxmorph)),
        "scene": hasattr(bpy.types.Scene, "boxmorph"),
        "handlers": {name: len(listed) for name, listed in lists if isinstance(listed, list)},
    }


def test_register_and_unregister_leave_no_trace(capfd):
    on = traces()
    assert on["scene"] and on["types"]
    addon_utils.disable(blender.PACKAGE)
    off = traces()
    assert (off["types"], off["operators"], off["scene"]) == ([], [], False)
    addon_utils.enable(blender.PACKAGE, default_set=True)
    assert traces() == on
    assert "".join(capfd.readouterr()) == ""


def test_enabling_does_not_load_the_rust_module():
    loaded = sys.modules.pop("boxmorph", None)
    try:
        addon_utils.disable(blender.PACKAGE)
        addon_utils.enable(blender.PACKAGE, default_set=True)
        assert "boxmorph" not in sys.modules
    finally:
        if loaded is not None:
            sys.modules["boxmorph"] = loaded


def test_no_threads_and_no_path_edits():
    for source in (ROOT / "addon").rglob("*.py"):
        text = source.read_text(encoding="utf-8")
        assert "threading" not in text and "sys.path" not in text, source.name
        assert text.startswith("# SPDX-License-Identifier: GPL-3.0-or-later\n"), source.name


def test_the_demo_finds_what_it_takes_of_the_extension():
    # `make demo` broke when modules moved, and no test ran it.
    taken = set()
    for source in (ROOT / "demo").glob("*.py"):
        text = source.read_text(encoding="utf-8")
        taken |= set(re.findall(r'\{extension\}\.([a-z_.]+)"', text))
        for names in re.findall(r"\{extension\}\.\{name\}\"\) for name in \(([^)]*)\)", text):
            taken |= set(re.findall(r'"([a-z_.]+)"', names))
    assert len(taken) >= 4, taken
    for name in taken:
        assert (ROOT / "addon" / f"{name.replace('.', '/')}.py").is_file(), name


#: The extension's rooms; each knows only those before it, and the modules beside them.
ROOMS = ["core", "part_boxes", "outcomes", "searching", "operators", "interface", "command_line"]


def test_dependencies_point_one_way():
    for source in (ROOT / "addon").glob("*/*.py"):
        room = source.parent.name
        if room not in ROOMS:
            continue
        for node in ast.walk(ast.parse(source.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and node.level == 2 and node.module:
                other = node.module.partition(".")[0]
                if other in ROOMS:
                    assert ROOMS.index(other) < ROOMS.index(room), f"{source.name} of {room} knows {other}"


WHEEL = "boxmorph-{}-cp311-abi3-manylinux_2_28_x86_64.whl"


@pytest.fixture
def version(build):
    return build.tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["package"]["version"]


@pytest.fixture
def manifest(build):
    return build.tomllib.loads((ROOT / "addon" / "blender_manifest.toml").read_text(encoding="utf-8"))


def test_zip_is_reproducible(build, version, tmp_path, monkeypatch):
    wheel = tmp_path / WHEEL.format(version)
    wheel.write_bytes(b"wheel")
    archives = []
    for folder in ("a", "b"):
        monkeypatch.setattr(sys, "argv", ["", "--wheel", str(wheel), "--output-dir", str(tmp_path / folder)])
        assert build.main() == 0
        archives.append((tmp_path / folder / f"boxmorph-{version}-linux_x64.zip").read_bytes())
    assert archives[0] == archives[1]
    with zipfile.ZipFile(tmp_path / "a" / f"boxmorph-{version}-linux_x64.zip") as archive:
        assert archive.read(f"wheels/{wheel.name}") == b"wheel"
        written = build.tomllib.loads(archive.read("blender_manifest.toml").decode())
    assert written["platforms"] == ["linux-x64"]
    assert written["wheels"] == [f"./wheels/{wheel.name}"]


def test_lint_passes_the_committed_manifest(build, version, manifest, tmp_path):
    wheel = tmp_path / WHEEL.format(version)
    wheel.touch()
    assert build.lint(manifest, version, [wheel]) == []


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"version": "9.9.9"}, "Cargo.toml"),
        ({"license": ["GPL-3.0-or-later"]}, "SPDX"),
        ({"tagline": "Ends badly."}, "tagline"),
        ({"platforms": ["macos-x86"]}, "filled in"),
        ({"permissions": {"telepathy": "Reads minds"}}, "telepathy"),
    ],
)
def test_lint_finds_what_blender_does_not(build, version, manifest, tmp_path, change, words):
    wheel = tmp_path / WHEEL.format(version)
    wheel.touch()
    faults = build.lint(manifest | change, version, [wheel])
    assert len(faults) == 1 and words in faults[0]


@pytest.mark.parametrize(
    ("names", "words"),
    [
        ([], "no wheel"),
        (["boxmorph-0.0.1-cp311-abi3-win_amd64.whl"], "is not boxmorph"),
        (["boxmorph-{}-cp311-cp311-win_amd64.whl"], "cp311-abi3"),
        (["boxmorph-{}-cp311-abi3-any.whl"], "platform"),
        ([WHEEL, "boxmorph-{}-cp311-abi3-manylinux_2_34_x86_64.whl"], "both for linux-x64"),
    ],
)
def test_lint_of_wheels(build, version, manifest, tmp_path, names, words):
    wheels = [tmp_path / name.format(version) for name in names]
    for wheel in wheels:
        wheel.touch()
    faults = build.lint(manifest, version, wheels)
    assert len(faults) == 1 and words in faults[0]


def test_lint_of_a_missing_wheel(build, version, manifest, tmp_path):
    faults = build.lint(manifest, version, [tmp_path / WHEEL.format(version)])
    assert len(faults) == 1 and "does not exist" in faults[0]
