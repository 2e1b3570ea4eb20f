# SPDX-License-Identifier: MIT OR Apache-2.0
"""The static extensions repository; that its list is Blender's own is tested in real Blender."""

import hashlib
import importlib.util
import json
import pathlib
import zipfile

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def repository():
    path = ROOT / "scripts" / "build_repository.py"
    spec = importlib.util.spec_from_file_location("build_repository", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


MANIFEST = """
schema_version = "1.0.0"
id = "boxmorph"
version = "{version}"
name = "Boxmorph"
tagline = "Deforms <things>"
maintainer = "The Boxmorph developers"
type = "add-on"
blender_version_min = "4.2.0"
license = ["SPDX:GPL-3.0-or-later"]
platforms = ["{platform}"]
wheels = ["./wheels/boxmorph-{version}-cp311-abi3-any.whl"]
"""


@pytest.fixture
def make(tmp_path):
    """A function that writes the zip of a version, a platform and some contents."""

    def make(version, platform="linux-x64", contents="", folder="built"):
        path = tmp_path / folder / f"boxmorph-{version}-{platform.replace('-', '_')}.zip"
        path.parent.mkdir(exist_ok=True)
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr("blender_manifest.toml", MANIFEST.format(version=version, platform=platform))
            archive.writestr("contents.txt", contents)
        return path

    return make


def listed(folder):
    """Return what the list names, as {platform: version}."""
    index = json.loads((folder / "index.json").read_text(encoding="utf-8"))
    assert (index["version"], index["blocklist"]) == ("v1", [])
    return {item["platforms"][0]: item["version"] for item in index["data"]}


def contents(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


def test_every_platform_is_listed_with_size_and_hash(repository, make, tmp_path):
    zips = [make("0.1.0", platform) for platform in ("linux-x64", "windows-x64", "macos-arm64")]
    entries = repository.build(zips, tmp_path / "out")
    assert listed(tmp_path / "out") == dict.fromkeys(("linux-x64", "windows-x64", "macos-arm64"), "0.1.0")
    for item in entries:
        data = (tmp_path / "out" / item["archive_url"]).read_bytes()
        assert item["archive_size"] == len(data)
        assert item["archive_hash"] == "sha256:" + hashlib.sha256(data).hexdigest()
        assert "wheels" not in item and item["python_versions"] == ["3"]


def test_the_same_zips_give_the_same_bytes_in_any_order_and_again(repository, make, tmp_path):
    zips = [
        make(version, platform) for version in ("0.1.0", "0.2.0") for platform in ("linux-x64", "macos-x64")
    ]
    repository.build(zips, tmp_path / "a")
    repository.build(zips[::-1], tmp_path / "b")
    for path in zips:
        repository.build([path], tmp_path / "c")
    repository.build([], tmp_path / "c")
    assert contents(tmp_path / "a") == contents(tmp_path / "b") == contents(tmp_path / "c")


@pytest.mark.parametrize(
    "versions", [("0.9.0", "0.10.0"), ("1.0.0-rc.1", "1.0.0"), ("1.0.0-rc.2", "1.0.0-rc.10")]
)
def test_the_newest_of_each_platform_is_listed_and_older_ones_kept(repository, make, tmp_path, versions):
    older, newer = versions
    zips = [make(newer), make(older), make(older, "windows-x64")]
    repository.build(zips, tmp_path / "out")
    assert listed(tmp_path / "out") == {"linux-x64": newer, "windows-x64": older}
    assert sorted(path.name for path in (tmp_path / "out").glob("*.zip")) == sorted(
        [zips[0].name, zips[2].name]
    )
    assert (tmp_path / "out" / "older" / zips[1].name).read_bytes() == zips[1].read_bytes()


@pytest.mark.parametrize("later", [[], ["0.2.0"]])
def test_a_published_version_is_never_replaced(repository, make, tmp_path, later):
    repository.build([make("0.1.0")] + [make(version) for version in later], tmp_path / "out")
    before = contents(tmp_path / "out")
    with pytest.raises(repository.Fault, match="raise the version"):
        repository.build([make("0.3.0"), make("0.1.0", contents="other", folder="other")], tmp_path / "out")
    assert contents(tmp_path / "out") == before


def test_what_is_no_extension_is_named(repository, tmp_path, make):
    odd = tmp_path / "odd.zip"
    odd.write_bytes(b"no zip")
    with pytest.raises(repository.Fault, match=r"odd\.zip is not an extension's zip"):
        repository.build([odd], tmp_path / "out")
    with pytest.raises(repository.Fault, match="there is no zip"):
        repository.build([], tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_the_page_links_what_can_be_dropped_into_blender(repository, make, tmp_path):
    repository.build([make("0.1.0")], tmp_path / "out")
    page = (tmp_path / "out" / "index.html").read_text(encoding="utf-8")
    link = "./boxmorph-0.1.0-linux_x64.zip?repository=.%2Findex.json&amp;blender_version_min=4.2.0"
    assert link in page
