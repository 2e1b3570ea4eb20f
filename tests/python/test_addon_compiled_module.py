# SPDX-License-Identifier: MIT OR Apache-2.0
"""A compiled module that is not of the extension's build is refused in a sentence."""

import types
import zipfile

import addon_blender as blender
import pytest

LOADED, NEWER = "0.1.0", "0.2.0"


def record(version, digest):
    compiled = f"boxmorph/_boxmorph.abi3.so,sha256={digest},7"
    return f"boxmorph/__init__.py,sha256=x,1\n{compiled}\nboxmorph-{version}.dist-info/RECORD,,\n"


@pytest.fixture
def differ(tmp_path):
    """A function that says how a loaded module differs from an extension, both made up."""

    def differ(extension=LOADED, unpacked=(LOADED, "a"), wheel="a", pip=False):
        (tmp_path / "wheels").mkdir()
        name = f"wheels/boxmorph-{extension}-cp311-abi3-win_amd64.whl"
        manifest = f'version = "{extension}"\nwheels = ["./{name}"]\n'
        (tmp_path / "blender_manifest.toml").write_text(manifest, encoding="utf-8")
        with zipfile.ZipFile(tmp_path / name, "w") as archive:
            archive.writestr(f"boxmorph-{extension}.dist-info/RECORD", record(extension, wheel))
        packages = tmp_path / "site-packages"
        if unpacked:
            version, digest = unpacked
            info = packages / f"boxmorph-{version}.dist-info"
            info.mkdir(parents=True)
            (info / "RECORD").write_text(record(version, digest), encoding="utf-8")
            if pip:
                (info / "INSTALLER").write_text("pip", encoding="utf-8")
        module = types.SimpleNamespace(
            __version__=LOADED, __file__=str(packages / "boxmorph" / "__init__.py")
        )
        return blender.addon("compiled_module").difference(module, tmp_path)

    return differ


def test_the_installed_module_is_of_this_build():
    import boxmorph

    folder = blender.addon("compiled_module")._HERE
    assert blender.addon("compiled_module").difference(boxmorph, folder) is None
    assert blender.addon("engine").library() is boxmorph


@pytest.mark.parametrize(
    ("case", "words"),
    [
        ({}, None),
        ({"unpacked": None}, None),
        ({"wheel": "b"}, "another build of Boxmorph 0.1.0"),
        ({"wheel": "b", "pip": True}, None),
        ({"extension": NEWER, "unpacked": (NEWER, "a")}, "0.2.0 was installed while 0.1.0 was in use"),
        ({"extension": NEWER}, "other copies of Boxmorph"),
    ],
)
def test_another_build_is_named(differ, case, words):
    said = differ(**case)
    assert said is None if words is None else words in str(said)


def test_a_search_is_refused_and_nothing_is_left(monkeypatch):
    blender.empty_scene()
    chair = blender.chair()
    before = blender.key_state(chair)
    module = blender.addon("compiled_module")
    monkeypatch.setattr(module, "_right", [])
    monkeypatch.setattr(module, "difference", lambda *_: blender.addon("errors").Refusal("Restart Blender"))
    with pytest.raises(RuntimeError, match="Restart Blender"):
        blender.deform()
    assert blender.key_state(chair) == before
